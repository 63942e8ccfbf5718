// SPDX-License-Identifier: Apache-2.0
// Built-in functions against references in double precision.
#include "language/ir/lower/test_support.h"
#include "language/runtime/runtime_functions.h"

#include <cmath>
#include <numbers>

namespace candela::ir {
namespace {

constexpr double pi = std::numbers::pi;

struct Case {
    const char *expression;
    double (*expected)(double u, double v);
};

double clampTo(double x, double low, double high) { return std::min(std::max(x, low), high); }

const Case floats[] = {
    {"radians(u)", [](double u, double) { return u * pi / 180; }},
    {"degrees(u)", [](double u, double) { return u * 180 / pi; }},
    {"sin(3 * u)", [](double u, double) { return std::sin(3 * u); }},
    {"asin(u)", [](double u, double) { return std::asin(u); }},
    {"cos(3 * u)", [](double u, double) { return std::cos(3 * u); }},
    {"acos(u)", [](double u, double) { return std::acos(u); }},
    {"tan(u)", [](double u, double) { return std::tan(u); }},
    {"atan(3 * u)", [](double u, double) { return std::atan(3 * u); }},
    {"atan(u, v)", [](double u, double v) { return std::atan2(u, v); }},
    {"pow(abs(u), v)", [](double u, double v) { return std::pow(std::fabs(u), v); }},
    {"pow(u, 2)", [](double u, double) { return u * u; }},
    {"exp(2 * u)", [](double u, double) { return std::exp(2 * u); }},
    {"sqrt(u)", [](double u, double) { return u < 0 ? 0 : std::sqrt(u); }},
    {"inversesqrt(1 + u * u)", [](double u, double) { return 1 / std::sqrt(1 + u * u); }},
    {"log(2 + u)", [](double u, double) { return std::log(2 + u); }},
    {"log(2 + u, 10)", [](double u, double) { return std::log10(2 + u); }},
    {"mod(5 * u, 1.5)", [](double u, double) { return 5 * u - 1.5 * std::floor(5 * u / 1.5); }},
    {"abs(u)", [](double u, double) { return std::fabs(u); }},
    {"sign(u) + 10 * sign(0)", [](double u, double) { return u < 0 ? -1.0 : 1.0; }},
    {"min(u, v, 0.25)",
     [](double u, double v) {
         return std::min({u, v, 0.25});
     }},
    {"max(u, v, 0.25)",
     [](double u, double v) {
         return std::max({u, v, 0.25});
     }},
    {"clamp(u, -0.25, 0.5)", [](double u, double) { return clampTo(u, -0.25, 0.5); }},
    {"clamp(u, 0.5, -0.25)", [](double u, double) { return u < 0.5 ? 0.5 : -0.25; }},
    {"clamp(v, u, -u)", [](double u, double v) { return v < u ? u : std::min(v, -u); }},
    {"floor(5 * u)", [](double u, double) { return std::floor(5 * u); }},
    {"ceil(5 * u)", [](double u, double) { return std::ceil(5 * u); }},
    {"round(5 * u) + round(0.5) * 10 + round(-0.5) * 100",
     [](double u, double) { return std::round(5 * u) + 10 - 100; }},
    {"step(0.25, u)", [](double u, double) { return u < 0.25 ? 0.0 : 1.0; }},
    {"smoothstep(-0.5, 0.5, u)",
     [](double u, double) {
         const double t = clampTo(u + 0.5, 0, 1);
         return t * t * (3 - 2 * t);
     }},
    {"smoothstep(0.25, 0.25, u)", [](double u, double) { return u < 0.25 ? 0.0 : 1.0; }},
    {"mix(u, v, 0.25)", [](double u, double v) { return 0.75 * u + 0.25 * v; }},
    {"spline(u, 0, 0, 1, 1)",
     [](double u, double) {
         const double t = clampTo(u, 0, 1);
         return t / 2 + 1.5 * t * t - t * t * t;
     }},
    {"spline(\"linear\", abs(u), 9, 1, 3, 2, 9)",
     [](double u, double) {
         const double x = 2 * std::fabs(u);
         return x < 1 ? 1 + 2 * x : 3 - (x - 1);
     }},
    {"spline(\"bezier\", abs(u), 1, 2, 4, 8)",
     [](double u, double) {
         const double t = std::fabs(u), r = 1 - t;
         return r * r * r + 6 * r * r * t + 12 * r * t * t + 8 * t * t * t;
     }},
    {"spline(\"bspline\", abs(u), 1, 1, 1, 1, 1)", [](double, double) { return 1.0; }},
    {"spline(\"b-spline\", 0, 1, 2, 6, 5)", [](double, double) { return (1 + 4 * 2 + 6) / 6.0; }},
    {"spline(\"hermite\", abs(u), 1, 0, 3, 0)",
     [](double u, double) {
         const double t = std::fabs(u);
         return 1 + 2 * (3 * t * t - 2 * t * t * t);
     }},
    {"spline(\"power\", abs(u), 1, 2, 4, 8)",
     [](double u, double) {
         const double t = std::fabs(u);
         return t * t * t + 2 * t * t + 4 * t + 8;
     }},
    {"length(vector(u, v, 2))", [](double u, double v) { return std::sqrt(u * u + v * v + 4); }},
    {"distance(point(u, 0, 0), point(0, v, 2))",
     [](double u, double v) { return std::sqrt(u * u + v * v + 4); }},
    {"ptlined(point(0, 0, 0), point(1, 0, 0), point(2 * u, 1, 0))",
     [](double u, double) {
         const double d = 2 * u - clampTo(2 * u, 0, 1);
         return std::sqrt(d * d + 1);
     }},
    {"ptlined(point(1, 0, 0), point(1, 0, 0), point(1, u, 0))",
     [](double u, double) { return std::fabs(u); }},
    {"ycomp(rotate(point(2, 0, 5), u, point(1, 0, 0), point(1, 0, 3)))",
     [](double u, double) { return std::sin(u); }},
    {"zcomp(normalize(vector(u, v, 2)))",
     [](double u, double v) { return 2 / std::sqrt(u * u + v * v + 4); }},
    {"ycomp(reflect(vector(u, -1, v), vector(0, 1, 0)))", [](double, double) { return 1.0; }},
    {"zcomp(faceforward(vector(0, 0, 1), vector(u, v, u), vector(0, 0, 1)))",
     [](double u, double) { return u > 0 ? -1.0 : 1.0; }},
    {"xcomp(refract(normalize(vector(u, -1, 0)), vector(0, 1, 0), 0.5))",
     [](double u, double) { return 0.5 * u / std::sqrt(1 + u * u); }},
    {"length(refract(normalize(vector(3, -1, 0)), vector(0, 1, 0), 1.5))",
     [](double, double) { return 0.0; }},
    {"comp(color(1, 2, u), 2)", [](double u, double) { return u; }},
    {"determinant(matrix(1,2,0,0, 3,u,0,0, 0,0,2,0, 0,0,0,1))",
     [](double u, double) { return 2 * (u - 6); }},
    {"determinant(matrix(0,1,0,0, 1,0,0,0, 0,0,0,1, 0,0,1,u)) ",
     [](double, double) { return 1.0; }},
    {"comp(matrix(1,2,3,4, 5,6,7,8, 9,10,11,12, 13,14,15,16), 2, 3 * abs(u))",
     [](double u, double) { return 9.0 + std::floor(3 * std::fabs(u)); }},
    {"totalradiance(color(u, v, 3))", [](double u, double v) { return (u + v + 3) / 3; }},
    {"totalluminance(color(u, v, 1))",
     [](double u, double v) { return 179 * (0.2126 * u + 0.7152 * v + 0.0722); }},
    {"comp(photometric(color(u, v, 1)), 1)", [](double, double v) { return 179 * v; }},
    {"comp(radiometric(photometric(color(u, v, 1))), 0)", [](double u, double) { return u; }},
    {"match(\"^a.*c$\", \"abc\") + 2 * match(\"x\", \"abc\")", [](double, double) { return 1.0; }},
    {"concat(\"a\", \"b\", \"c\") == format(\"%s\", \"abc\")", [](double, double) { return 1.0; }},
    {"format(\"%f\", 2) == \"2.000000\"", [](double, double) { return 1.0; }},
    {"format(\"tex%04d.%s\", 3, \"tif\") == \"tex0003.tif\"", [](double, double) { return 1.0; }},
    {"format(\"%5s|%.1c\", \"a%\", color(1, 2, 3)) == \"   a%|1.0 2.0 3.0\"",
     [](double, double) { return 1.0; }},
    {"comp(ctransform(\"hsv\", color(0.5, 0.25, 0.25)), 1)", [](double, double) { return 0.5; }},
    {"comp(color \"hsl\" (0.5, 1, 0.25), 2)", [](double, double) { return 0.5; }},
    {"comp(ctransform(\"xyY\", color(1, 1, 1)), 0)", [](double, double) { return 0.3127; }},
    {"comp(ctransform(\"XYZ\", color(1, 1, 1)), 1)", [](double, double) { return 1.0; }},
    {"comp(ctransform(\"YIQ\", color(u, u, u)), 0)", [](double u, double) { return u; }},
};

TEST(LowerBuiltins, Floats) {
    for (const Case &c : floats) {
        SCOPED_TRACE(c.expression);
        ShaderRun run(surfaceWith("float", std::string("result = ") + c.expression + ";"));
        ASSERT_TRUE(run.lowered) << run.diagnostics.text();
        const auto result = run.run().at("result")[0];
        for (int lane = 0; lane < run.batch->count; ++lane) {
            const double expected =
                c.expected(run.input(ShaderInput::u, lane), run.input(ShaderInput::v, lane));
            EXPECT_NEAR(result[lane], expected, 2e-6 * std::max(1.0, std::fabs(expected)))
                << "lane " << lane;
        }
    }
}

/// There and back again.
TEST(LowerBuiltins, ColorSpacesInvert) {
    for (const char *space : {"hsv", "hsl", "XYZ", "xyY", "YIQ"}) {
        SCOPED_TRACE(space);
        const std::string name = std::string("\"") + space + "\"";
        ShaderRun run(surfaceWith("color", "color c = color(abs(u), abs(v), 0.3); result = "
                                           "ctransform(" +
                                               name + ", \"rgb\", ctransform(" + name + ", c));"));
        ASSERT_TRUE(run.lowered) << run.diagnostics.text();
        const auto out = run.run().at("result");
        for (int lane = 0; lane < run.batch->count; ++lane) {
            EXPECT_NEAR(out[0][lane], std::fabs(run.input(ShaderInput::u, lane)), 1e-5);
            EXPECT_NEAR(out[1][lane], std::fabs(run.input(ShaderInput::v, lane)), 1e-5);
            EXPECT_NEAR(out[2][lane], 0.3, 1e-5);
        }
    }
}

/// What the checker lets pass is what the lowering knows.
TEST(LowerBuiltins, NamesInOtherSpellings) {
    const std::pair<const char *, const char *> table[] = {
        {"color \"HSV\" (u, 1, v)", "color \"hsv\" (u, 1, v)"},
        {"ctransform(\"RGB\", \"HSL\", Cs)", "ctransform(\"rgb\", \"hsl\", Cs)"},
        {"ctransform(\"xyz\", \"yiq\", Cs)", "ctransform(\"XYZ\", \"YIQ\", Cs)"},
        {"spline(\"catmullrom\", abs(u), Cs, 1, Cs, 0)", "spline(abs(u), Cs, 1, Cs, 0)"},
    };
    for (auto [other, standard] : table)
        EXPECT_EQ(evaluateBody("color", std::string("result = ") + other + ";"),
                  evaluateBody("color", std::string("result = ") + standard + ";"))
            << other;
}

TEST(LowerBuiltins, HueOfPrimaries) {
    const auto out =
        evaluateBody("color", "result = color(comp(ctransform(\"hsv\", color(0, 1, 0)), 0), "
                              "comp(ctransform(\"hsv\", color(0, 0, 1)), 0), "
                              "comp(ctransform(\"hsl\", color(1, 0, 0.5)), 0));");
    EXPECT_NEAR(out[0][0], 1.0 / 3, 1e-6);
    EXPECT_NEAR(out[1][0], 2.0 / 3, 1e-6);
    EXPECT_NEAR(out[2][0], 11.0 / 12, 1e-6);
}

TEST(LowerBuiltins, MatrixTimesInverseIsIdentity) {
    const auto out = evaluateBody(
        "matrix", "matrix m = matrix(2+u,1,0,1, 0,3,v,0, 1,0,4,u, 1,2,3,5); result = m / m;");
    for (int k = 0; k < 16; ++k)
        for (int lane = 0; lane < 21; ++lane)
            EXPECT_NEAR(out[k][lane], k % 5 == 0, 1e-5) << k;
}

/// translate(), rotate() and scale() act after the matrix (RI 3.2 section 15.4: postconcatenate).
TEST(LowerBuiltins, MatricesAppend) {
    const auto out = evaluateBody(
        "point", "matrix m = translate(scale(matrix 1, vector(2, 2, 2)), vector(1, 0, 0)); "
                 "m = rotate(m, PI/2, vector(0, 0, 1)); result = transform(m, point(0, -1, 3));");
    // Doubled to (0, -2, 6), moved to (1, -2, 6), rotated.
    EXPECT_NEAR(out[0][0], 2, 1e-6);
    EXPECT_NEAR(out[1][0], 1, 1e-6);
    EXPECT_NEAR(out[2][0], 6, 1e-6);
}

TEST(LowerBuiltins, SetcompOfMatrix) {
    const auto out =
        evaluateBody("float", "matrix m = 1; setcomp(m, 1, 2, 5); setcomp(m, 3*abs(u), "
                              "3, 7); result = comp(m, 1, 2) + comp(m, 3*abs(u), 3);");
    EXPECT_FLOAT_EQ(out[0][4], 12);
}

TEST(LowerBuiltins, Fresnel) {
    const auto out = evaluateBody(
        "color", "float kr, kt; vector R, T; fresnel(vector(0, 0, -1), normal(0, 0, 1), 1/1.5, kr, "
                 "kt, R, T); result = color(kr, kt, zcomp(R) + 10 * zcomp(T));");
    EXPECT_NEAR(out[0][0], 0.04, 1e-6);
    EXPECT_NEAR(out[1][0], 0.96, 1e-6);
    EXPECT_NEAR(out[2][0], 1 - 10, 1e-5);
    // Brewster's angle: half of the reflected light is all of one polarisation.
    const double theta = std::atan(1.5), beyond = std::asin(std::sin(theta) / 1.5);
    const double across = std::pow(std::sin(theta - beyond) / std::sin(theta + beyond), 2);
    const auto brewster =
        evaluateBody("float", "float a = atan(1.5), kr, kt; fresnel(vector(sin(a), 0, -cos(a)), "
                              "normal(0, 0, 1), 1/1.5, kr, kt); result = kr;");
    EXPECT_NEAR(brewster[0][0], across / 2, 1e-6);
    const auto total = evaluateBody("float", "float kr, kt; fresnel(normalize(vector(3, 0, -1)), "
                                             "normal(0, 0, 1), 1.5, kr, kt); result = kr + 10*kt;");
    EXPECT_FLOAT_EQ(total[0][0], 1);
}

float runtimeNoise(runtime::RuntimeFunction function, std::vector<float> inputs, int output = 0) {
    std::vector<const float *> in;
    for (const float &x : inputs)
        in.push_back(&x);
    float out[3] = {};
    float *outs[3] = {&out[0], &out[1], &out[2]};
    runtime::callScalar(function, in.data(), outs);
    return out[output];
}

TEST(LowerBuiltins, NoiseCallsTheRuntime) {
    using F = runtime::RuntimeFunction;
    const char *body = "point p = point(u, v, 2.5); result = color(noise(u) + 2 * noise(u, v), "
                       "noise(p) + 2 * noise(p, v), comp(color noise(p), 1));";
    ShaderRun run(surfaceWith("color", body));
    ASSERT_TRUE(run.lowered) << run.diagnostics.text();
    const auto out = run.run().at("result");
    ShaderRun periodic(surfaceWith(
        "color", "point p = point(u, v, 2.5); result = color(pnoise(p, point(2, 3, 4)), "
                 "cellnoise(5 * u, v), zcomp(vector cellnoise(p)));"));
    ASSERT_TRUE(periodic.lowered) << periodic.diagnostics.text();
    const auto other = periodic.run().at("result");
    for (int lane = 0; lane < run.batch->count; ++lane) {
        const float u = float(run.input(ShaderInput::u, lane));
        const float v = float(run.input(ShaderInput::v, lane));
        EXPECT_EQ(out[0][lane], runtimeNoise(F::noise1, {u}) + 2 * runtimeNoise(F::noise2, {u, v}));
        EXPECT_EQ(out[1][lane], runtimeNoise(F::noise3, {u, v, 2.5f}) +
                                    2 * runtimeNoise(F::noise4, {u, v, 2.5f, v}));
        EXPECT_EQ(out[2][lane], runtimeNoise(F::vnoise3, {u, v, 2.5f}, 1));
        const float pu = float(periodic.input(ShaderInput::u, lane));
        const float pv = float(periodic.input(ShaderInput::v, lane));
        EXPECT_EQ(other[0][lane], runtimeNoise(F::pnoise3, {pu, pv, 2.5f, 2, 3, 4}));
        EXPECT_EQ(other[1][lane], runtimeNoise(F::cellnoise2, {5 * pu, pv}));
        EXPECT_EQ(other[2][lane], runtimeNoise(F::vcellnoise3, {pu, pv, 2.5f}, 2));
    }
}

TEST(LowerBuiltins, RandomNumbersDiffer) {
    const auto out =
        evaluateBody("color", "result = color(random(), random(), comp(color random(), 1));");
    for (int c = 0; c < 3; ++c) {
        EXPECT_GE(out[c][0], 0);
        EXPECT_LT(out[c][0], 1);
        EXPECT_NE(out[c][0], out[c][1]);
        EXPECT_NE(out[c][0], out[(c + 1) % 3][0]);
    }
}

/// Loops within loops, in functions, under conditions, unrolled or not: no number comes twice.
TEST(LowerBuiltins, RandomNumbersDifferInEachTurnOfALoop) {
    const char *bodies[] = {
        "for (i = 0; i < 24; i += 1) n[i] = random();",
        "for (i = 0; i < 4; i += 1) for (j = 0; j < 6; j += 1) n[6 * i + j] = random();",
        "float draw() { return random(); } while (i < 24) { n[i] = draw(); i += 1; }",
        "for (i = 0; i < 24; i += 1) { if (mod(i, 2) < 1) n[i] = random(); else n[i] = random(); }",
        "for (i = 0; i < 12; i += 1) { n[i] = random(); for (j = 0; j < 1; j += 1) "
        "n[12 + i] = random(); }",
    };
    for (const char *body : bodies) {
        const auto out = evaluateBody(
            "color", std::string("float n[24]; float i = 0, j; uniform float twice = 0, k, l; ") +
                         body +
                         " for (k = 0; k < 24; k += 1) for (l = k + 1; l < 24; l += 1) "
                         "  if (n[k] == n[l]) result += 1; setcomp(result, 1, n[0] - n[23]);");
        EXPECT_EQ(out[0][0], 0) << body;
        EXPECT_NE(out[1][0], 0) << body;
    }
}

TEST(LowerBuiltins, RandomNumbersReadTheSeed) {
    for (auto [body, reads] : {std::pair{"Ci = random();", true}, {"Ci = u;", false}}) {
        ShaderRun run("surface test() { " + std::string(body) + " }", 1);
        ASSERT_TRUE(run.lowered) << run.diagnostics.text();
        EXPECT_EQ(run.lowered->whole.inputsRead[std::size_t(ShaderInput::seed)], reads) << body;
    }
}

TEST(LowerBuiltins, SplineOfArrays) {
    const auto list = evaluateBody("color", "color k[5] = {1, color(0, 1, 2), 3, 4, 5}; "
                                            "result = spline(\"catmull-rom\", 0.3, k);");
    const auto spread =
        evaluateBody("color", "result = spline(0.3, color 1, color(0, 1, 2), color 3, "
                              "color 4, color 5);");
    for (int c = 0; c < 3; ++c)
        EXPECT_EQ(list[c][0], spread[c][0]);
}

/// Knots that lie on a line give the line, and many of them are not chosen one by one.
TEST(LowerBuiltins, SplinesOfManyKnotsStaySmall) {
    constexpr int knots = 1003; // 1000 segments.
    for (const std::string basis : {"catmull-rom", "bspline", "linear"}) {
        std::string text = "result = spline(\"" + basis + "\", abs(u)";
        for (int k = 0; k < knots; ++k)
            text += ", " + std::to_string(k);
        ShaderRun run(surfaceWith("float", text + ");"));
        ASSERT_TRUE(run.lowered) << run.diagnostics.text();
        EXPECT_LT(run.lowered->whole.body.body.size(), std::size_t(4 * knots));
        const auto result = run.run().at("result")[0];
        for (int lane = 0; lane < run.batch->count; ++lane)
            EXPECT_NEAR(result[lane], 1 + 1000 * std::fabs(run.input(ShaderInput::u, lane)), 1e-3);
    }
}

/// Semantics sees what the text says; this is about what only the lowering can know: strings that
/// are folded in.
TEST(LowerBuiltins, UnknownColourSpacesAreWarnings) {
    for (const char *body : {"result = ctransform(\"lab\", Cs);", "result = color \"lab\" Cs;"}) {
        ShaderRun run(surfaceWith("color", body));
        ASSERT_TRUE(run.lowered) << body;
        EXPECT_EQ(run.diagnostics.count(Severity::Warning), 1) << run.diagnostics.text();
    }
}

TEST(LowerBuiltins, ErrorsOfFoldedStrings) {
    const auto messageOf = [](const std::string &given, const char *body) {
        ShaderRun run("surface test(string name = \"\";) { " + std::string(body) + " }", 1,
                      {{"name", {given}}});
        EXPECT_FALSE(run.lowered) << body;
        return run.diagnostics.text();
    };
    EXPECT_NE(messageOf("wavy", "Ci = float spline(name, u, 1, 2, 3, 4);").find("spline basis"),
              std::string::npos);
    EXPECT_NE(messageOf("bezier", "Ci = float spline(name, u, 1, 2, 3, 4, 5);").find("knots"),
              std::string::npos);
    EXPECT_NE(messageOf("%c", "Ci = match(format(name, u), \"\");").find("%c is given"),
              std::string::npos);
    EXPECT_NE(messageOf("(", "Ci = match(name, \"a\");").find("not a regular expression"),
              std::string::npos);
}

} // namespace
} // namespace candela::ir
