// SPDX-License-Identifier: Apache-2.0
// Derivatives against central differences over neighbouring points of a curved patch.
#include "language/ir/lower/test_support.h"

#include <cmath>

namespace candela::ir {
namespace {

// The patch: P, N, s and t as functions of (u, v), with their derivatives in closed form.
struct Patch {
    static Vec3 P(double u, double v) {
        return {float(u + 0.2 * v * v), float(2 * v - u * v), float(u * u + 0.5 * v)};
    }
    static Vec3 dPdu(double u, double v) { return {1, float(-v), float(2 * u)}; }
    static Vec3 dPdv(double u, double v) { return {float(0.4 * v), float(2 - u), 0.5f}; }
};

void place(ShaderRun &run, int lane, double u, double v) {
    const auto set = [&](ShaderInput input, std::initializer_list<double> values) {
        size_t plane = size_t(input);
        for (double value : values)
            run.batch->inputs[plane++][size_t(lane)] = float(value);
    };
    const auto set3 = [&](ShaderInput input, Vec3 x) { set(input, {x.x, x.y, x.z}); };
    set(ShaderInput::u, {u});
    set(ShaderInput::v, {v});
    set3(ShaderInput::P, Patch::P(u, v));
    set3(ShaderInput::dPdu, Patch::dPdu(u, v));
    set3(ShaderInput::dPdv, Patch::dPdv(u, v));
    set(ShaderInput::N, {u * v, 1, v * v});
    set(ShaderInput::dNdu, {v, 0, 0});
    set(ShaderInput::dNdv, {u, 0, 2 * v});
    set(ShaderInput::s, {3 * u + v});
    set(ShaderInput::dsdu, {3});
    set(ShaderInput::dsdv, {1});
    set(ShaderInput::t, {v * v});
    set(ShaderInput::dtdu, {0});
    set(ShaderInput::dtdv, {2 * v});
}

const char *const expressions[] = {
    "u * v + 2 * u - v / (2 + u)",
    "sin(3 * s) * cos(t) + tan(0.3 * u)",
    "exp(-u) + log(3 + v) + sqrt(2 + s) + pow(1 + abs(u), 2.5) + pow(2, v)",
    "asin(0.5 * u) + acos(0.5 * v) + atan(s) + atan(2 + u, 3 + v)",
    "max(u, v) + min(2 * u, v) + abs(v - 3) + clamp(s, -10, 10)",
    "smoothstep(-2, 2, s) + mix(u, v, t) + mod(u, 7)",
    "noise(2 * P) + noise(s) + noise(s, t) + comp(color noise(P), 1)",
    "length(P - point(3, 3, 3)) + xcomp(normalize(N)) + zcomp(P ^ N)",
    "distance(P, point(1, 2, 9)) * floor(10.5)",
    "u > v ? u * u : v * v",
};

/// Du() and Dv() of each, also of what flows through branches, loops, functions and memory.
struct Flowing {
    const char *body, *before = "";
};

const Flowing flowing[] = {
    {"if (u > 0.1) x = u * u; else x = v * 3;"},
    {"float i; x = u; for (i = 0; i < 4; i += 1) x = x * v + u;"},
    {"float a[4]; float i; for (i = 0; i < 4; i += 1) a[i] = i * u * v; x = a[2 + floor(0.2)];"},
    {"x = square(u + v);", "float square(float y) { if (y > 100) return 0; return y * y; } "},
};

void compareWithDifferences(const std::string &text, const std::string &before) {
    SCOPED_TRACE(text);
    const double h = 1.0 / 256;
    ShaderRun plain(surfaceWith("float", "float x = 0; " + text + " result = x;", before), 16 * 5);
    ShaderRun slopes(
        surfaceWith("color", "float x = 0; " + text + " result = color(Du(x), Dv(x), x);", before),
        16);
    ASSERT_TRUE(plain.lowered && slopes.lowered)
        << plain.diagnostics.text() << slopes.diagnostics.text();
    for (int k = 0; k < 16; ++k) {
        const double u = 0.05 + 0.17 * (k % 4), v = 0.08 + 0.21 * (k / 4);
        place(slopes, k, u, v);
        place(plain, 5 * k, u, v);
        place(plain, 5 * k + 1, u - h, v);
        place(plain, 5 * k + 2, u + h, v);
        place(plain, 5 * k + 3, u, v - h);
        place(plain, 5 * k + 4, u, v + h);
    }
    const auto x = plain.run().at("result")[0];
    const auto out = slopes.run().at("result");
    for (int k = 0; k < 16; ++k) {
        const double byU = (x[5 * k + 2] - x[5 * k + 1]) / (2 * h);
        const double byV = (x[5 * k + 4] - x[5 * k + 3]) / (2 * h);
        EXPECT_EQ(out[2][k], x[5 * k]);
        EXPECT_NEAR(out[0][k], byU, 4e-3 * std::max(1.0, std::fabs(byU))) << "point " << k;
        EXPECT_NEAR(out[1][k], byV, 4e-3 * std::max(1.0, std::fabs(byV))) << "point " << k;
    }
}

TEST(LowerDerivatives, AgreeWithCentralDifferences) {
    for (const char *expression : expressions)
        compareWithDifferences(std::string("x = ") + expression + ";", "");
}

TEST(LowerDerivatives, FlowThroughControl) {
    for (const Flowing &f : flowing)
        compareWithDifferences(f.body, f.before);
}

/// Closed forms at one point.
std::vector<float> atPoint(const std::string &type, const std::string &body, double u, double v) {
    ShaderRun run(surfaceWith(type, body), 1);
    EXPECT_TRUE(run.lowered) << run.diagnostics.text();
    if (!run.lowered)
        return {0, 0, 0};
    place(run, 0, u, v);
    run.setInput(ShaderInput::du, {0.5f});
    run.setInput(ShaderInput::dv, {0.25f});
    run.setInput(ShaderInput::orientation, {-1});
    std::vector<float> result;
    const auto outputs = run.run();
    for (const auto &plane : outputs.at("result"))
        result.push_back(plane[0]);
    return result;
}

TEST(LowerDerivatives, CalculatenormalAndArea) {
    const double u = 0.3, v = 0.6;
    const Vec3 natural = cross(Patch::dPdu(u, v), Patch::dPdv(u, v));
    ASSERT_GT(natural.z, 0); // The orientation above is the other one.
    const auto n = atPoint("normal", "result = calculatenormal(P);", u, v);
    EXPECT_NEAR(n[0], -natural.x, 1e-5);
    EXPECT_NEAR(n[1], -natural.y, 1e-5);
    EXPECT_NEAR(n[2], -natural.z, 1e-5);
    EXPECT_NEAR(atPoint("float", "result = area(P);", u, v)[0],
                std::sqrt(dot(natural, natural)) * 0.125f, 1e-5);
}

TEST(LowerDerivatives, Deriv) {
    // d(s^2)/ds by both ways around: Du(s^2)/Du(s) + Dv(s^2)/Dv(s) = 2 * 2s.
    const double u = 0.3, v = 0.2, s = 3 * u + v;
    EXPECT_NEAR(atPoint("float", "result = Deriv(s * s, s);", u, v)[0], 4 * s, 1e-5);
    // t does not change with u: that direction adds nothing.
    EXPECT_NEAR(atPoint("float", "result = Deriv(t * t, t);", u, v)[0], 2 * v * v, 1e-6);
}

TEST(LowerDerivatives, OfDerivatives) {
    EXPECT_NEAR(
        atPoint("float", "result = Du(Du(u * u * u)) + 10 * Dv(Du(u * v * v));", 0.5, 0.25)[0],
        3 + 10 * 0.5, 1e-5);
}

TEST(LowerDerivatives, OnlyWhatReachesAConsumer) {
    ShaderRun run(surfaceWith("float", "float a = noise(P); result = a + Du(u * u);"));
    ASSERT_TRUE(run.lowered);
    EXPECT_FALSE(run.lowered->whole.inputsRead[size_t(ShaderInput::dPdu)]);
}

} // namespace
} // namespace candela::ir
