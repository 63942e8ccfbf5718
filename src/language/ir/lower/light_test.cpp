// SPDX-License-Identifier: Apache-2.0
// Light loops of surface shaders; light shaders.
#include "language/ir/core/regions.h"
#include "language/ir/lower/test_support.h"

#include <cmath>
#include <functional>

namespace candela::ir {
namespace {

const std::vector<ShaderRun::Sample> samples = {{{0, 0, 2}, {1, 2, 3}, 1},
                                                {{3, 0, 4}, {1, 1, 1}, 2},
                                                {{0, 1, 0.1f}, {0.5f, 0, 1}, 0},
                                                {{0, 0, -1}, {7, 7, 7}, 1}};

Vec3 unit(Vec3 v) { return v * (1 / std::sqrt(dot(v, v))); }

/// Red of Ci over the samples.
float redUnder(const std::string &body, const LoweringOptions &options = {},
               const std::vector<ShaderRun::Sample> &lights = samples) {
    ShaderRun run("surface test() { Ci = 0; " + body + " }", 3, {}, {}, options);
    EXPECT_TRUE(run.lowered) << run.diagnostics.text();
    if (!run.lowered)
        return NAN;
    run.setInput(ShaderInput::N, {0, 0, 1});
    run.setInput(ShaderInput::I, {0, 0.6f, -0.8f});
    run.setSamples(lights);
    return run.run().at("Ci")[0][1];
}

float sumOf(const std::function<float(Vec3 L, float Cl)> &term) {
    float sum = 0;
    for (const auto &sample : samples)
        sum += term(sample.L, sample.Cl[0]);
    return sum;
}

TEST(LowerLight, EverywhereTakesAllSamples) {
    EXPECT_FLOAT_EQ(redUnder("illuminance(P) Ci += Cl;"), 9.5f);
    EXPECT_FLOAT_EQ(redUnder("illuminance(P) Ci += Cl * zcomp(L);"),
                    sumOf([](Vec3 L, float Cl) { return Cl * L.z; }));
}

TEST(LowerLight, ClassicCulls) {
    EXPECT_FLOAT_EQ(redUnder("illuminance(P, N, PI/2) Ci += Cl;"), 2.5f);
    EXPECT_FLOAT_EQ(redUnder("illuminance(P, N, PI/4) Ci += Cl;"), 2);
    EXPECT_FLOAT_EQ(redUnder("illuminance(P, N, 0.1) Ci += Cl;"), 1);
}

TEST(LowerLight, ClassicAsksForTheDirectionOfItsAxisAlone) {
    for (const char *axis : {"8 * N", "N / 8", "-(N / -8)"})
        for (const auto &[angle, sum] : {std::pair{"PI/4", 2.0f}, {"0.1", 1.0f}})
            EXPECT_FLOAT_EQ(
                redUnder(std::string("illuminance(P, ") + axis + ", " + angle + ") Ci += Cl;"), sum)
                << axis << " " << angle;
}

/// The normal's length, and that of each direction of light.
TEST(LowerLight, UnitNormalsAreNotNormalizedAgain) {
    const auto roots = [](const std::string &body) {
        ShaderRun run("surface test() { " + body + " }", 3);
        int count = 0;
        forEachInstruction(run.lowered->whole.body,
                           [&](const Instruction &i) { count += i.op == Op::Sqrt; });
        return count;
    };
    EXPECT_EQ(roots("Ci = diffuse(N);"), 2);
    EXPECT_EQ(roots("Ci = diffuse(normalize(N));"), 2);
    EXPECT_EQ(roots("normal Nf = faceforward(normalize(N), I); Ci = diffuse(Nf);"), 2);
    EXPECT_EQ(roots("normal Nf = normalize(N); if (u > .5) Nf = -Nf; Ci = diffuse(Nf);"), 2);
    EXPECT_EQ(roots("normal Nn = normalize(N); illuminance(P, -Nn, PI/2) Ci += Cl * (L . Nn);"), 1);
    EXPECT_EQ(roots("normal Nn = normalize(N); Ci = diffuse(2 * Nn);"), 3);
}

TEST(LowerLight, ExtendedCullsNothing) {
    ShaderRun run("surface test() { Ci = 0; normal Nn = normalize(N);"
                  "vector R = reflect(I, Nn);"
                  "illuminance(P, 2, Nn, 180, 0, 0.25, R, 60, 20, color(1, 0, 0)) {"
                  "  float c = normalize(L) . Nn; if (c <= 0) continue; Ci += Cl * c; } }",
                  3);
    ASSERT_TRUE(run.lowered) << run.diagnostics.text();
    const LightRequest &request = run.lowered->whole.requests.at(0);
    EXPECT_EQ(int(request.form), int(ConeForm::Extended));
    EXPECT_EQ(request.coneCount, 2);
    run.setInput(ShaderInput::N, {0, 0, 5});
    run.setSamples(samples);
    EXPECT_FLOAT_EQ(run.run().at("Ci")[0][0],
                    sumOf([](Vec3 L, float Cl) { return std::max(0.0f, unit(L).z) * Cl; }));
    // What the request says of its second cone: axis R, 60 degrees, 20, luminance of red.
    for (const Instruction &i : run.lowered->whole.body.body)
        if (i.op == Op::LightLoop) {
            EXPECT_EQ(i.operands.size(), 3u + 2 * 6 + i.results.size());
        }
}

/// The constructs of the paper's figure 2: two cones, a parameter named `exp`, continue.
TEST(LowerLight, PhongOfExtendedLoop) {
    const float expected = sumOf([](Vec3 L, float Cl) {
        const Vec3 l = unit(L), R{0, 0.6f, 0.8f};
        if (l.z < 0)
            return 0.0f;
        return Cl * (0.5f * l.z + 0.25f * std::pow(std::max(0.0f, dot(R, l)), 10.0f));
    });
    ShaderRun run("surface glossy(float Kd = .5, Ks = .25, exp = 10;) {"
                  "  normal Nn = normalize(N); vector R = reflect(normalize(I), Nn); color C = 0;"
                  "  illuminance(P, 2, Nn, 180, 1, Kd, R, 180, exp, Ks) {"
                  "    vector Ln = normalize(L);"
                  "    if (Ln . Nn < 0) continue;"
                  "    C += Kd * Cl * (Ln . Nn) + Ks * Cl * pow(max(0, R . Ln), exp);"
                  "  } Ci = C; }",
                  3);
    ASSERT_TRUE(run.lowered) << run.diagnostics.text();
    run.setInput(ShaderInput::N, {0, 0, 1});
    run.setInput(ShaderInput::I, {0, 0.6f, -0.8f});
    run.setSamples(samples);
    EXPECT_NEAR(run.run().at("Ci")[0][0], expected, 1e-5);
}

TEST(LowerLight, RunTimeConeCount) {
    ShaderRun run("surface test(float n = 1;) { illuminance(P, n, N, 180, 0, 1, I, 90, 0, 2) "
                  "Ci += Cl; }",
                  3);
    ASSERT_TRUE(run.lowered) << run.diagnostics.text();
    EXPECT_EQ(run.lowered->whole.requests.at(0).coneCount, 2);
}

TEST(LowerLight, JumpsInLoops) {
    EXPECT_FLOAT_EQ(redUnder("illuminance(P) { if (xcomp(L) > 0) break; Ci += Cl; }"), 1);
    EXPECT_FLOAT_EQ(redUnder("illuminance(P) { if (xcomp(L) > 0) return; Ci += Cl; } Ci = 50;"), 1);
    EXPECT_FLOAT_EQ(redUnder("float i; for (i = 0; i < 3; i += 1) { illuminance(P) { "
                             "if (ycomp(L) > 0) break 2; Ci += Cl; } Ci += 100; }"),
                    2);
    EXPECT_FLOAT_EQ(redUnder("illuminance(P) { Ci += 1; } Ci += L[0] + Cl;"), 4);
}

TEST(LowerLight, Categories) {
    ShaderRun run("surface test() { illuminance(\"a,-b\", P) Ci += Cl; }", 3);
    ASSERT_TRUE(run.lowered) << run.diagnostics.text();
    ASSERT_EQ(run.lowered->whole.categories, std::vector<std::string>{"a,-b"});
    run.setSamples(samples);
    run.batch->samples.lightCount = 2;
    run.batch->samples.categoryAccepts = {0, 0, 1}; // Indirect, light 1, light 2.
    EXPECT_FLOAT_EQ(run.run().at("Ci")[0][0], 1);
}

TEST(LowerLight, BuiltinLoops) {
    EXPECT_NEAR(redUnder("Ci = diffuse(N);"),
                sumOf([](Vec3 L, float Cl) { return std::max(0.0f, unit(L).z) * Cl; }), 1e-6);
    const auto highlights = [](float exponent) {
        return sumOf([exponent](Vec3 L, float Cl) {
            if (L.z < 0)
                return 0.0f;
            const Vec3 half = unit(unit(L) + Vec3{0, -0.6f, 0.8f});
            return Cl * std::pow(std::max(0.0f, half.z), exponent);
        });
    };
    EXPECT_NEAR(redUnder("Ci = specular(N, -I, 0.1);"), highlights(80), 1e-5);
    EXPECT_NEAR(redUnder("Ci = specular(N, -I, 0.1);", {.highlightScale = 1}), highlights(10),
                1e-5);
    EXPECT_NEAR(redUnder("Ci = phong(N, -I, 5);"), sumOf([](Vec3 L, float Cl) {
                    if (L.z < 0)
                        return 0.0f;
                    return Cl * std::pow(std::max(0.0f, dot(unit(L), Vec3{0, 0.6f, 0.8f})), 5.0f);
                }),
                1e-5);
    EXPECT_NEAR(redUnder("illuminance(P, N, PI/2) Ci += Cl * specularbrdf(L, N, -I, 0.2);"),
                redUnder("Ci = specular(N, -I, 0.2);"), 1e-6);
}

TEST(LowerLight, TraceIsANumberedAnswer) {
    ShaderRun run("surface test() { Ci = 0.5 * trace(P, reflect(I, N)) + trace(P, I); }", 3);
    ASSERT_TRUE(run.lowered) << run.diagnostics.text();
    ASSERT_EQ(run.lowered->whole.requests.size(), 2u);
    run.batch->answers.givesTraced = true;
    EXPECT_FLOAT_EQ(run.run().at("Ci")[1][2],
                    0.5f * run.batch->answers.traced[1][2] + run.batch->answers.traced[4][2]);
}

TEST(LowerLight, PointLight) {
    ShaderRun run("light pointlight(float intensity = 1; color lightcolor = 1;"
                  "  point from = point \"shader\" (0, 0, 0);)"
                  "{ illuminate(from) Cl = intensity * lightcolor / (L . L); }");
    ASSERT_TRUE(run.lowered) << run.diagnostics.text();
    EXPECT_EQ(int(run.lowered->lightClass), int(LightClass::Local));
    EXPECT_TRUE(run.lowered->inverseSquare);
    EXPECT_FALSE(run.lowered->directionOnly);
    run.setParameter("intensity", {8});
    run.setParameter("from", {1, 0, 0});
    run.setInput(ShaderInput::Ps, {1, 0, 2});
    const auto out = run.run();
    EXPECT_FLOAT_EQ(out.at("Cl")[0][0], 2);
    EXPECT_FLOAT_EQ(out.at("L")[0][0], 0);
    EXPECT_FLOAT_EQ(out.at("L")[2][0], 2);
}

TEST(LowerLight, SpotLight) {
    ShaderRun run(
        "light spotlight(float intensity = 1; color lightcolor = 1;"
        "  point from = point \"shader\" (0,0,0); point to = point \"shader\" (0,0,1);"
        "  float coneangle = radians(30); float conedeltaangle = radians(5);"
        "  float beamdistribution = 2;) {"
        "  vector A = normalize(to - from); float outer = cos(coneangle);"
        "  float inner = cos(coneangle - conedeltaangle);"
        "  illuminate(from, A, coneangle) { float c = L . A / length(L);"
        "    float atten = pow(c, beamdistribution) / (L . L);"
        "    atten *= smoothstep(outer, inner, c); Cl = atten * intensity * lightcolor; } }");
    ASSERT_TRUE(run.lowered) << run.diagnostics.text();
    EXPECT_TRUE(run.lowered->inverseSquare);
    run.setInput(ShaderInput::Ps, {0, 0, 2});
    EXPECT_FLOAT_EQ(run.run().at("Cl")[0][0], 0.25f);
    run.setInput(ShaderInput::Ps, {3, 0, 2});
    EXPECT_EQ(run.run().at("Cl")[0][0], 0);
}

TEST(LowerLight, DistantLight) {
    ShaderRun run("light distantlight(float intensity = 1; color lightcolor = 1;"
                  "  point from = point \"shader\" (0,0,0); point to = point \"shader\" (0,0,1);)"
                  "{ solar(to - from, 0) Cl = intensity * lightcolor; }");
    ASSERT_TRUE(run.lowered) << run.diagnostics.text();
    EXPECT_EQ(int(run.lowered->lightClass), int(LightClass::Distant));
    EXPECT_TRUE(run.lowered->inverseSquare);
    run.setParameter("to", {0, 3, 4});
    const auto out = run.run();
    EXPECT_FLOAT_EQ(out.at("L")[1][0], 0.6f);
    EXPECT_FLOAT_EQ(out.at("L")[2][0], 0.8f);
    EXPECT_FLOAT_EQ(out.at("Cl")[2][0], 1);
    EXPECT_FALSE(run.lowered->whole.inputsRead[size_t(ShaderInput::lightSample)]);
}

TEST(LowerLight, AmbientLight) {
    ShaderRun run("light ambientlight(float intensity = 1; color lightcolor = 1;)"
                  "{ Cl = intensity * lightcolor; }");
    ASSERT_TRUE(run.lowered) << run.diagnostics.text();
    EXPECT_EQ(int(run.lowered->lightClass), int(LightClass::Ambient));
    EXPECT_FLOAT_EQ(run.run().at("Cl")[0][0], 1);
}

TEST(LowerLight, AreaLightRadianceKnowsOnlyDirections) {
    ShaderRun run("light arealight(float radiance = 1; color lightcolor = 1; float onesided = 1;"
                  "  float exponent = 1;) {"
                  "  illuminate(P, 1, N, 180, exponent, 1) { float c = L . N / length(L);"
                  "    if (onesided == 0 || c > 0) Cl = radiance * lightcolor; } }");
    ASSERT_TRUE(run.lowered) << run.diagnostics.text();
    EXPECT_TRUE(run.lowered->directionOnly);
    EXPECT_FALSE(run.lowered->inverseSquare);
    run.setInput(ShaderInput::P, {0, 0, 1});
    run.setInput(ShaderInput::N, {0, 0, 1});
    run.setInput(ShaderInput::Ps, {1, 0, 3});
    EXPECT_FLOAT_EQ(run.run().at("Cl")[0][0], 1);
    run.setInput(ShaderInput::Ps, {1, 0, -3});
    EXPECT_FLOAT_EQ(run.run().at("Cl")[0][0], 0);
}

TEST(LowerLight, FallOffThatIsNotInverseSquare) {
    const auto isInverseSquare = [](const std::string &value) {
        ShaderRun run("light test(point from = 0;) { illuminate(from) Cl = " + value + "; }");
        EXPECT_TRUE(run.lowered) << run.diagnostics.text();
        return run.lowered && run.lowered->inverseSquare;
    };
    EXPECT_TRUE(isInverseSquare("pow(length(L), -2)"));
    EXPECT_TRUE(isInverseSquare("abs(xcomp(normalize(L))) / (L . L)"));
    EXPECT_FALSE(isInverseSquare("1"));
    EXPECT_FALSE(isInverseSquare("1 / length(L)"));
    EXPECT_FALSE(isInverseSquare("pow(max(1e38, xcomp(normalize(L))), 1e400)"));
    EXPECT_FALSE(isInverseSquare("1 / (1 + L . L)"));
    EXPECT_FALSE(isInverseSquare("(length(L) < 2 ? 1 : 0) / (L . L)"));
    EXPECT_FALSE(isInverseSquare("noise(Ps) / (L . L)"));
}

/// Directions of a solar cone stay inside and have the mean cosine of the uniform distribution.
TEST(LowerLight, SolarConeIsUniform) {
    const int count = 4096;
    ShaderRun run("light sun() { solar(vector(0, 0, -2), 0.5) Cl = 1; }", count);
    ASSERT_TRUE(run.lowered) << run.diagnostics.text();
    for (int lane = 0; lane < count; ++lane) {
        run.batch->inputs[size_t(ShaderInput::lightSample)][lane] = (lane % 64 + 0.5f) / 64;
        run.batch->inputs[size_t(ShaderInput::lightSample) + 1][lane] = (lane / 64 + 0.5f) / 64;
    }
    const auto L = run.run().at("L");
    double mean = 0, meanX = 0;
    for (int lane = 0; lane < count; ++lane) {
        EXPECT_NEAR(std::hypot(L[0][lane], L[1][lane], L[2][lane]), 1, 1e-5);
        EXPECT_LE(std::cos(0.5f) - 1e-6, -L[2][lane]);
        mean -= L[2][lane] / double(count);
        meanX += L[0][lane] / double(count);
    }
    EXPECT_NEAR(mean, (1 + std::cos(0.5)) / 2, 1e-4);
    EXPECT_NEAR(meanX, 0, 1e-4);
}

TEST(LowerLight, SolarWithoutArgumentsIsTheSphere) {
    ShaderRun run("light sky() { solar() Cl = 1; }", 2);
    ASSERT_TRUE(run.lowered) << run.diagnostics.text();
    run.setInput(ShaderInput::lightSample, {0.5f, 0.25f});
    const auto L = run.run().at("L");
    EXPECT_NEAR(L[2][0], 0, 1e-6);
    EXPECT_NEAR(std::hypot(L[0][0], L[1][0]), 1, 1e-6);
}

} // namespace
} // namespace candela::ir
