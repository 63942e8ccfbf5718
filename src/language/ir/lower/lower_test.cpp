// SPDX-License-Identifier: Apache-2.0
// The standard shaders, parameters and their defaults, errors.
#include "language/ir/core/print_format.h"
#include "language/ir/lower/test_support.h"

#include <cmath>

namespace candela::ir {
namespace {

const char *const matte = "surface matte(float Ka = 1; float Kd = 1;) {"
                          "  normal Nf = faceforward(normalize(N), I);"
                          "  Oi = Os; Ci = Os * Cs * (Ka * ambient() + Kd * diffuse(Nf)); }";

TEST(Lower, Constant) {
    ShaderRun run("surface constant() { Oi = Os; Ci = Os * Cs; }");
    ASSERT_TRUE(run.lowered) << run.diagnostics.text();
    EXPECT_TRUE(run.lowered->whole.parameters.empty());
    const auto out = run.run();
    for (int lane = 0; lane < run.batch->count; ++lane)
        for (int c = 0; c < 3; ++c) {
            const float Os = float(run.input(ShaderInput::Os, lane, c));
            EXPECT_EQ(out.at("Oi")[c][lane], Os);
            EXPECT_EQ(out.at("Ci")[c][lane], Os * float(run.input(ShaderInput::Cs, lane, c)));
        }
}

TEST(Lower, MatteUnderOneLightFromAbove) {
    ShaderRun run(matte);
    ASSERT_TRUE(run.lowered) << run.diagnostics.text();
    run.setInput(ShaderInput::N, {0, 0, 3});
    run.setInput(ShaderInput::Ng, {0, 0, 3});
    run.setInput(ShaderInput::I, {0, 1, -1});
    run.setInput(ShaderInput::Os, {1, 1, 1});
    run.setInput(ShaderInput::Cs, {1, 0.5f, 0.25f});
    run.setParameter("Kd", {0.8f});
    run.setSamples({{{0, 3, 4}, {1, 1, 2}}, {{0, 0, -1}, {9, 9, 9}}});
    const auto Ci = run.run().at("Ci");
    const float cosine = 0.8f;
    EXPECT_NEAR(Ci[0][0], 0.8f * cosine, 1e-6);
    EXPECT_NEAR(Ci[1][0], 0.5f * 0.8f * cosine, 1e-6);
    EXPECT_NEAR(Ci[2][0], 0.25f * 0.8f * cosine * 2, 1e-6);
    ASSERT_EQ(run.lowered->whole.requests.size(), 1u);
    EXPECT_EQ(run.lowered->whole.categories.at(0), "!diffuse");
}

TEST(Lower, AmbientComesFromTheRenderer) {
    ShaderRun run(matte);
    ASSERT_TRUE(run.lowered);
    run.setInput(ShaderInput::Os, {1, 1, 1});
    run.setInput(ShaderInput::Cs, {1, 1, 1});
    run.setParameter("Ka", {0.5f});
    run.batch->answers.givesAmbient = true;
    const auto Ci = run.run().at("Ci");
    for (int c = 0; c < 3; ++c)
        EXPECT_FLOAT_EQ(Ci[c][3], 0.5f * run.batch->answers.ambient[c][3]);
}

TEST(Lower, UnsetOutputs) {
    ShaderRun run("surface nothing() {}");
    ASSERT_TRUE(run.lowered) << run.diagnostics.text();
    const auto out = run.run();
    EXPECT_EQ(out.at("Ci")[0][0], 0);
    EXPECT_EQ(out.at("Oi")[1][0], float(run.input(ShaderInput::Os, 0, 1)));
}

TEST(Lower, SlotsOnlyForWhatIsRead) {
    ShaderRun run("surface test(float unread = 1; color tint = 1; float scale = 2;) "
                  "{ Ci = comp(tint, 1) * scale; }");
    ASSERT_TRUE(run.lowered) << run.diagnostics.text();
    EXPECT_EQ(run.lowered->whole.parameters.size(), 4u);
    EXPECT_EQ(run.lowered->parameters[0].firstSlot, -1);
    EXPECT_EQ(run.lowered->parameters[1].firstSlot, 0);
    EXPECT_EQ(run.lowered->parameters[2].firstSlot, 3);
    EXPECT_FALSE(run.lowered->whole.inputsRead[size_t(ShaderInput::P)]);
}

TEST(Lower, DefaultsAreEvaluated) {
    ShaderRun run("float three() { return 3; }"
                  "light test(float a = sqrt(16) + three(); float b = a * 2;"
                  "  color c = color \"hsv\" (0, 1, 0.5); point from = point \"world\" (1, 2, 3);"
                  "  vector axis = vector(0, 0, a); string name = concat(\"x\", \"y\");"
                  "  float list[3] = {1, 2};) { Cl = c * a * b * list[0]; }");
    ASSERT_TRUE(run.lowered) << run.diagnostics.text();
    const auto &p = run.lowered->parameters;
    EXPECT_EQ(p[0].defaults, std::vector<float>{7});
    EXPECT_EQ(p[1].defaults, std::vector<float>{14});
    EXPECT_EQ(p[2].defaults, (std::vector<float>{0.5f, 0, 0}));
    EXPECT_EQ(p[3].defaultSpace, "world");
    EXPECT_EQ(p[3].defaults, (std::vector<float>{1, 2, 3}));
    EXPECT_EQ(p[4].defaultSpace, "shader");
    EXPECT_EQ(p[4].defaults, (std::vector<float>{0, 0, 7}));
    EXPECT_EQ(p[5].stringDefaults, std::vector<std::string>{"xy"});
    EXPECT_EQ(p[6].defaults, (std::vector<float>{1, 2, 0}));
    EXPECT_EQ(p[6].arraySize, 3);
}

TEST(Lower, DefaultsMustBeConstant) {
    ShaderRun run("surface test(float a = noise(P);) { Ci = a; }");
    EXPECT_FALSE(run.lowered);
    EXPECT_GT(run.diagnostics.count(Severity::Error), 0);
}

TEST(Lower, StringsAreFolded) {
    const std::string source = "surface test(string mode = \"a\"; uniform float k = 2;) "
                               "{ if (mode == \"b\") Ci = k; else Ci = 1; }";
    ShaderRun plain(source), given(source, 5, {{"mode", {"b"}}});
    ASSERT_TRUE(plain.lowered && given.lowered);
    EXPECT_EQ(plain.run().at("Ci")[0][0], 1);
    EXPECT_TRUE(plain.lowered->whole.parameters.empty());
    EXPECT_EQ(given.run().at("Ci")[0][0], 2);
}

TEST(Lower, VariablesOverrideParameters) {
    ShaderRun run("surface test(varying float k = 2; float m = 3;) { Ci = k * m; }", 5, {}, {"k"});
    ASSERT_TRUE(run.lowered);
    ASSERT_EQ(run.lowered->whole.variables.size(), 1u);
    EXPECT_EQ(run.lowered->whole.parameters.size(), 1u);
    EXPECT_EQ(run.run().at("Ci")[0][2], run.batch->variables[0][2] * 3);
}

TEST(Lower, PrintsThroughTheService) {
    ShaderRun run("surface test() { printf(\"%s: %f %c\\n\", \"at\", 2, color(1, 2, 3)); }", 1);
    ASSERT_TRUE(run.lowered) << run.diagnostics.text();
    std::string text;
    run.batch->services.context = &text;
    run.batch->services[Service::print] = [](void *context, const ServiceCall &call) {
        *static_cast<std::string *>(context) += printedText(call, 0);
    };
    run.run();
    EXPECT_EQ(text, "at: 2.000000 1.000000 2.000000 3.000000\n");
}

TEST(Lower, OtherKindsAreRefused) {
    ShaderRun run("transformation bend() { P = P; }");
    EXPECT_FALSE(run.lowered);
    EXPECT_NE(run.diagnostics.text().find("transformation shaders"), std::string::npos);
}

/// Each kind that is compiled writes its outputs, from the start values of its variables.
TEST(Lower, EmptyShadersWriteTheirKindsOutputs) {
    ShaderRun surface("surface test() {}"), light("light test() {}");
    ASSERT_TRUE(surface.lowered && light.lowered);
    EXPECT_EQ(surface.lowered->kind, sl::ShaderKind::Surface);
    EXPECT_EQ(light.lowered->kind, sl::ShaderKind::Light);
    const auto shaded = surface.run(), lit = light.run();
    ASSERT_EQ(shaded.size(), 2u);
    ASSERT_EQ(lit.size(), 2u);
    for (int c = 0; c < 3; ++c) {
        EXPECT_EQ(shaded.at("Ci")[c][0], 0);
        EXPECT_EQ(shaded.at("Oi")[c][0], float(surface.input(ShaderInput::Os, 0, c)));
        EXPECT_EQ(lit.at("L")[c][0], 0);
        EXPECT_EQ(lit.at("Cl")[c][0], 0);
    }
}

// Such a function is also checked with an array that stands for any, a very long one.
TEST(Lower, ArraysOfAnyLengthAreHandedToFunctions) {
    ShaderRun run("color pick(color c[]; float w) { return c[1] * w; }\n"
                  "surface test() { color three[3] = {1, 2, 3}; Ci = pick(three, 2); }",
                  1);
    ASSERT_TRUE(run.lowered) << run.diagnostics.text();
    EXPECT_EQ(run.run().at("Ci")[0][0], 4);
    ShaderRun uncalled("color pick(color c[]; float w) { return c[1] * w; }\n"
                       "surface test() { Ci = 1; }");
    EXPECT_TRUE(uncalled.lowered) << uncalled.diagnostics.text();
}

TEST(Lower, InliningEnds) {
    std::string source = "float f0(float x) { return x * 1.5 + 1; } ";
    for (int i = 1; i <= 30; ++i)
        source += "float f" + std::to_string(i) + "(float x) { return f" + std::to_string(i - 1) +
                  "(x) + f" + std::to_string(i - 1) + "(x + 1); } ";
    ShaderRun run(source + "surface test() { Ci = f30(u); }");
    EXPECT_FALSE(run.lowered);
    EXPECT_NE(run.diagnostics.text().find("too large"), std::string::npos);
}

TEST(Lower, ArraysHaveALimit) {
    ShaderRun run(surfaceWith("float", "float a[2000000]; result = a[5];"));
    EXPECT_FALSE(run.lowered);
    EXPECT_GT(run.diagnostics.count(Severity::Error), 0);
}

TEST(Lower, SpacesMustBeConstants) {
    ShaderRun run("surface test() { string s = \"world\"; if (u > 0) s = \"shader\"; "
                  "Ci = xcomp(transform(s, P)); }");
    EXPECT_FALSE(run.lowered);
    EXPECT_NE(run.diagnostics.text().find("must be known when the shader is compiled"),
              std::string::npos)
        << run.diagnostics.text();
}

} // namespace
} // namespace candela::ir
