// SPDX-License-Identifier: Apache-2.0
// What the slicer reads off shaders as the lowering writes them.
#include "language/ir/lower/test_support.h"
#include "language/ir/questions/questions.h"

#include <cmath>

namespace candela::ir {
namespace {

const char *const plastic =
    "surface plastic(float Ka = 1; float Kd = .5; float Ks = .25; float roughness = .1;"
    "  color specularcolor = 1;) {"
    "  normal Nf = faceforward(normalize(N), I); vector V = -normalize(I); Oi = Os;"
    "  Ci = Os * (Cs * (Ka * ambient() + Kd * diffuse(Nf))"
    "             + specularcolor * Ks * specular(Nf, V, roughness)); }";

TEST(LowerSlice, FactsOfPlastic) {
    ShaderRun run(plastic);
    ASSERT_TRUE(run.lowered) << run.diagnostics.text();
    const SurfaceFacts facts = surfaceFacts(run.lowered->whole);
    EXPECT_TRUE(facts.hasLoops);
    EXPECT_TRUE(facts.readsAmbient);
    EXPECT_TRUE(facts.affine);
    EXPECT_TRUE(facts.staticRequests);
    EXPECT_TRUE(facts.opaqueIfOsIs1);
    EXPECT_FALSE(facts.emits);
    EXPECT_EQ(facts.cones.size(), 2u);
}

/// diffuse() is a cosine lobe, specular() one of a quarter of its exponent, 8 / .1.
TEST(LowerSlice, LobesOfBuiltinLoops) {
    ShaderRun run(plastic, 3);
    ASSERT_TRUE(run.lowered) << run.diagnostics.text();
    const Function prepare = slice(run.lowered->whole, Question::Prepare);
    ASSERT_EQ(verify(prepare), "");
    run.setInput(ShaderInput::N, {0, 0, 1});
    run.setInput(ShaderInput::Ng, {0, 0, 1});
    run.setInput(ShaderInput::I, {0, 0.6f, -0.8f});
    run.setInput(ShaderInput::Cs, {1, 1, 1});
    run.setInput(ShaderInput::Os, {1, 1, 1});
    const auto planes =
        run.batch->run(prepare, [](const Function &function, const ShaderArgs &args) {
            interpret(function, args);
        });
    std::map<std::string, float> stated;
    for (size_t i = 0; i < planes.size(); ++i)
        stated[prepare.outputs[i].name.text() + "." +
               std::to_string(prepare.outputs[i].component)] = planes[i][1];
    EXPECT_NEAR(stated["cone 0 exponent.0"], 1, 1e-6);
    EXPECT_NEAR(stated["cone 0 axis.2"], 1, 1e-6);
    EXPECT_NEAR(stated["cone 0 importance.0"], 0.5f, 1e-5);
    EXPECT_NEAR(stated["cone 1 exponent.0"], 20, 1e-4);
    EXPECT_NEAR(stated["cone 1 axis.1"], 0.6f, 1e-6);
    EXPECT_NEAR(stated["cone 1 axis.2"], 0.8f, 1e-6);
    EXPECT_NEAR(stated["cone 1 importance.0"], 0.25f * 2 / (20 + 1), 1e-5); // Its energy.
}

TEST(LowerSlice, EmissionIsNoReflection) {
    ShaderRun run("surface lamp(color power = 2;) { Oi = Os; Ci = power + diffuse(N); }");
    ASSERT_TRUE(run.lowered) << run.diagnostics.text();
    EXPECT_TRUE(surfaceFacts(run.lowered->whole).emits);
}

} // namespace
} // namespace candela::ir
