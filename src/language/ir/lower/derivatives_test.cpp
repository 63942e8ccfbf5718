// SPDX-License-Identifier: Apache-2.0
// Derivatives against central differences over neighbouring points of a curved patch.
#include "language/ir/lower/patch_points.h"

#include <cmath>

namespace candela::ir {
namespace {

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
        placeOnPatch(slopes, k, u, v);
        placeOnPatch(plain, 5 * k, u, v);
        placeOnPatch(plain, 5 * k + 1, u - h, v);
        placeOnPatch(plain, 5 * k + 2, u + h, v);
        placeOnPatch(plain, 5 * k + 3, u, v - h);
        placeOnPatch(plain, 5 * k + 4, u, v + h);
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
    placeOnPatch(run, 0, u, v);
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
    const Vec3 natural = cross(patchDu(u, v), patchDv(u, v));
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

TEST(LowerDerivatives, OnlyWhatReachesAConsumer) {
    ShaderRun run(surfaceWith("float", "float a = noise(P); result = a + Du(u * s);"));
    ASSERT_TRUE(run.lowered);
    EXPECT_FALSE(run.lowered->whole.inputsRead[size_t(ShaderInput::dPdu)]);
    EXPECT_TRUE(run.lowered->whole.inputsRead[size_t(ShaderInput::dsdu)]);
    EXPECT_FALSE(run.lowered->whole.inputsRead[size_t(ShaderInput::dsdv)]);
}

int count(const std::string &text, const std::string &part) {
    int result = 0;
    for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++result;
    return result;
}

TEST(LowerDerivatives, NoiseAndItsSlopesAreOneCall) {
    ShaderRun run(surfaceWith("float", "float a = noise(P); result = a + Du(a) + Dv(a);"));
    ASSERT_TRUE(run.lowered);
    EXPECT_EQ(count(print(run.lowered->whole), "noise3"), 1) << print(run.lowered->whole);
}

/// A counter that does not change with u and v carries no derivatives.
TEST(LowerDerivatives, LoopsCarryOnlyWhatChanges) {
    ShaderRun run(surfaceWith(
        "float", "float i, x = u; for (i = 0; i < s; i += 1) x = x * v + i; result = x + Du(x);"));
    ASSERT_TRUE(run.lowered);
    for (const Instruction &i : run.lowered->whole.body.body)
        if (i.op == Op::Loop) {
            EXPECT_EQ(i.operands.size(), 4u) << print(run.lowered->whole); // Condition, i, x, dx.
        }
}

/// Of what is not known users are told, once a kind.
TEST(LowerDerivatives, UnknownOnesAreTold) {
    const struct {
        const char *body, *message;
    } cases[] = {
        {"result = Du(comp(diffuse(N), 0));", "light is taken not to change"},
        {"result = Du(comp(trace(P, I), 0));", "light is taken not to change"},
        {"result = Du(area(P));", "du is taken not to change"},
        {"result = Du(xcomp(dPdu));", "dPdu is taken not to change"},
        {"result = Du(Du(comp(Cs, 1)));", "the derivative of Cs is taken not to change"},
        {"result = Du(u * random() + xcomp(E));", ""},
        {"result = Du(u + floor(s) + cellnoise(s, t));", ""},
    };
    for (const auto &[body, message] : cases) {
        ShaderRun run(surfaceWith("float", body));
        ASSERT_TRUE(run.lowered) << body << run.diagnostics.text();
        const std::string told = run.diagnostics.text();
        EXPECT_NE(told.find(message), std::string::npos) << body << "\n" << told;
        EXPECT_EQ(told.empty(), *message == 0) << body << "\n" << told;
    }
}

/// Where derivatives are not to be had, an error names the line.
TEST(LowerDerivatives, ImpossibleOnesAreErrors) {
    const struct {
        const char *body, *message;
    } cases[] = {
        {"float i, x = u * u;\nfor (i = 0; i < s; i += 1)\nx = sin(x) + Du(x);\nresult = x;",
         "test.sl:3:14: error: derivatives of derivatives go beyond order 16 here"},
        {"result = Du(Du(Du(noise(s))));", "there are no derivatives of noise beyond the second"},
    };
    for (const auto &[body, message] : cases) {
        ShaderRun run(surfaceWith("float", body));
        EXPECT_FALSE(run.lowered) << body;
        EXPECT_NE(run.diagnostics.text().find(message), std::string::npos)
            << run.diagnostics.text();
    }
}

} // namespace
} // namespace candela::ir
