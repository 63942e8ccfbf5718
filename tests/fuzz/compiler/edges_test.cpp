// SPDX-License-Identifier: Apache-2.0
// Functions at the edges of what they are defined for, interpreted and as code of both widths.
#include "language/ir/lower/test_support.h"
#include "language/jit/jit.h"

#include <cmath>
#include <limits>

namespace candela::fuzz {
namespace {

using Planes = std::vector<ir::ShaderRun::Plane>;

/// The result of a body, whose u and v are the given numbers, equal by all ways of running it.
Planes resultOf(const std::string &type, const std::string &body, const std::vector<float> &u,
                const std::vector<float> &v) {
    ir::ShaderRun run(ir::surfaceWith(type, body), int(u.size()));
    EXPECT_TRUE(run.lowered) << body << run.diagnostics.text();
    std::copy(u.begin(), u.end(), run.batch->inputs[std::size_t(ShaderInput::u)].begin());
    std::copy(v.begin(), v.end(), run.batch->inputs[std::size_t(ShaderInput::v)].begin());
    const ir::Function &function = run.lowered->whole;
    const auto expected = run.batch->run(function, ir::interpret);
    for (int width : {1, 16}) {
        JitOptions options;
        options.width = width;
        options.useCache = false;
        Jit jit(options, run.diagnostics);
        const ShaderFunction code = jit.compile(function);
        EXPECT_TRUE(code) << run.diagnostics.text();
        const auto found = run.batch->run(
            function, [code](const ir::Function &, const ShaderArgs &args) { code(&args); });
        for (std::size_t plane = 0; plane < expected.size(); ++plane)
            for (std::size_t lane = 0; lane < u.size(); ++lane)
                EXPECT_TRUE(expected[plane][lane] == found[plane][lane] ||
                            (std::isnan(expected[plane][lane]) && std::isnan(found[plane][lane])))
                    << body << " of " << u[lane] << ", " << v[lane] << ": " << expected[plane][lane]
                    << " and " << found[plane][lane] << " W=" << width;
    }
    Planes result;
    for (std::size_t plane = 0; plane < expected.size(); ++plane)
        if (function.outputs[plane].name.text() == "result")
            result.push_back(expected[plane]);
    return result;
}

const float numbers[] = {
    0,           -0.0f,        1e-9f,        -1e-9f,     .3f,   -.3f,       .7f,        .99999994f,
    1,           -1,           1.0000001f,   6.9999995f, 7,     -7,         20.999998f, 16777215.0f,
    16777217.0f, -16777217.0f, 123456789.0f, 1e9f,       -1e9f, 1234567e8f, -1e25f,     3e38f};
const float periods[] = {1, .1f, .7f, 1.5f, 7, 360, 1e-3f, 3e5f};

/// Arguments that make a - b floor(a / b) leave the range, too: next to multiples.
std::vector<float> argumentsFor(float period) {
    std::vector<float> result(std::begin(numbers), std::end(numbers));
    for (int k = -300; k <= 300; ++k) {
        const float multiple = float(k) * period;
        for (float x : {multiple, std::nextafter(multiple, 1e9f), std::nextafter(multiple, -1e9f)})
            result.push_back(x);
    }
    return result;
}

void expectRemainders(const std::vector<float> &arguments, float period, const Planes &found) {
    int corrected = 0;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const float a = arguments[i], r = found[0][i], b = std::fabs(period);
        EXPECT_TRUE(period > 0 ? r >= 0 && r < b : r <= 0 && -r < b)
            << "mod(" << a << ", " << period << ") = " << r;
        const float multiple = period * std::floor(a / period), plain = a - multiple;
        if (period > 0 ? plain >= 0 && plain < b : plain <= 0 && -plain < b) {
            EXPECT_EQ(r, plain) << "mod(" << a << ", " << period << ")";
        } else {
            ++corrected;
        }
    }
    EXPECT_GT(corrected, 0) << period;
}

TEST(Edges, RemaindersLieBelowThePeriod) {
    for (float size : periods)
        for (float period : {size, -size}) {
            const std::vector<float> a = argumentsFor(period);
            char text[64];
            std::snprintf(text, sizeof text, "result = mod(u, %.9g);", double(period));
            expectRemainders(a, period, resultOf("float", text, a, a));
            const std::vector<float> b(a.size(), period);
            expectRemainders(a, period, resultOf("float", "result = mod(u, v);", a, b));
        }
}

TEST(Edges, RemaindersIndexArrays) {
    const std::vector<float> u = {-1e-9f, 1e-9f, 1e9f, -1e25f, 3e38f};
    const Planes found = resultOf("float", "result = floor(mod(u, 1) * 3);", u, u);
    for (std::size_t i = 0; i < u.size(); ++i)
        EXPECT_TRUE(found[0][i] == 0 || found[0][i] == 1 || found[0][i] == 2) << u[i];
}

/// By its argument 1, by its period -floor(a / b), corrected or not.
TEST(Edges, RemaindersChangeAsTheirArguments) {
    for (float period : periods) {
        const std::vector<float> a = argumentsFor(period), b(a.size(), period);
        const Planes found = resultOf(
            "color", "result = color(Du(mod(u, v)), Dv(mod(u, v)), Du(mod(2 * u, 7)));", a, b);
        for (std::size_t i = 0; i < a.size(); ++i) {
            EXPECT_EQ(found[0][i], 1) << a[i] << ", " << period;
            EXPECT_EQ(found[1][i], -std::floor(a[i] / period)) << a[i] << ", " << period;
            if (std::fabs(a[i]) < 1e38f) {
                EXPECT_EQ(found[2][i], 2) << a[i];
            }
        }
    }
}

TEST(Edges, NumbersAreRoundedToTheNearestInteger) {
    std::vector<float> x;
    for (float half : {.5f, 1.5f, 2.5f, 1234.5f, 4194303.5f, 8388606.5f})
        for (float size : {half, std::nextafter(half, 0.0f), std::nextafter(half, 1e9f)})
            x.push_back(size), x.push_back(-size);
    for (float size : {0.0f, 1e-30f, 8388607.0f, 8388609.0f, 16777215.0f, 1e20f})
        x.push_back(size), x.push_back(-size);
    const Planes found = resultOf("float", "result = round(u);", x, x);
    for (std::size_t i = 0; i < x.size(); ++i)
        EXPECT_EQ(found[0][i], std::round(x[i])) << x[i];
}

TEST(Edges, NothingTurnsAboutAnAxisWithoutLength) {
    const std::vector<float> angle = {0, .5f, 1, -3}, size = {1, 2, -3, 1e6f};
    const char *bodies[] = {"point p = point(v, 1, 2); result = rotate(point(3, v, 4), u, p, p);",
                            "point p = point(v, 1, 2); result = rotate(vector(3, v, 4), u, p, p);",
                            "matrix m = 1; m = rotate(m, u, vector(v - v, 0, 0)); result = "
                            "transform(m, point(3, v, 4));",
                            "result = rotate(point(3, v, 4), u, point(1, 2, 3), point(1, 2, 3));"};
    for (const char *body : bodies) {
        const Planes found = resultOf("point", body, angle, size);
        for (std::size_t i = 0; i < angle.size(); ++i) {
            EXPECT_EQ(found[0][i], 3) << body;
            EXPECT_EQ(found[1][i], size[i]) << body;
            EXPECT_EQ(found[2][i], 4) << body;
        }
    }
}

} // namespace
} // namespace candela::fuzz
