// SPDX-License-Identifier: Apache-2.0
// What is known of texts that displace, and what they answer.
#include "language/ir/lower/test_support.h"
#include "language/ir/questions/questions.h"

namespace candela::ir {
namespace {

struct Facts {
    const char *text;
    bool movesP, setsN, slopesKnown, readsOtherSpaces;
};

constexpr Facts known[] = {
    {"displacement d() { P += .1 * N; }", true, false, true, false},
    {"displacement d() { P += .1 * N; N = calculatenormal(P); }", true, true, true, false},
    {"displacement d() { N = normalize(N); }", false, true, true, false},
    {"displacement d() { N = N; P = P; }", false, false, false, false},
    {"displacement d() { if (u > .5) P += N; }", true, false, true, false},
    {"displacement d() { P += noise(transform(\"object\", P)) * N; }", true, false, true, false},
    {"displacement d() { P += noise(transform(\"world\", P)) * N; }", true, false, true, true},
    {"displacement d() { P += noise(transform(\"shader\", P)) * N; }", true, false, true, true},
    {"displacement d() { P += length(I) * N; }", true, false, true, true},
    {"displacement d() { P += length(Du(P)) * N; }", true, false, false, false},
    {"surface d() { P += .1 * N; Ci = diffuse(normalize(N)); }", true, false, true, false},
    {"surface d() { N = -N; Ci = diffuse(normalize(N)); }", false, false, false, false},
    {"surface d() { Ci = noise(P); }", false, false, false, false},
};

TEST(Displacement, IsKnownByWhatTheTextDoes) {
    for (const Facts &expected : known) {
        SCOPED_TRACE(expected.text);
        ShaderRun run(expected.text);
        ASSERT_TRUE(run.lowered) << run.diagnostics.text();
        const DisplacementFacts facts = displacementFacts(run.lowered->whole);
        EXPECT_EQ(facts.movesP, expected.movesP);
        EXPECT_EQ(facts.setsN, expected.setsN);
        EXPECT_EQ(facts.slopesKnown, expected.slopesKnown);
        EXPECT_EQ(facts.readsOtherSpaces, expected.readsOtherSpaces);
    }
}

/// Planes of an answer at points with random inputs, by output.
std::map<std::string, std::vector<ShaderRun::Plane>> answers(TestBatch &batch,
                                                             const Function &function) {
    const auto planes =
        batch.run(function, [](const Function &f, const ShaderArgs &args) { interpret(f, args); });
    std::map<std::string, std::vector<ShaderRun::Plane>> result;
    for (size_t i = 0; i < planes.size(); ++i)
        result[function.outputs[i].name.text()].push_back(planes[i]);
    return result;
}

TEST(Displacement, TellsPointsAndTheirDerivatives) {
    for (const char *kind : {"displacement", "surface"}) {
        ShaderRun run(std::string(kind) + " d() { P += 2 * u * N; }");
        ASSERT_TRUE(run.lowered) << run.diagnostics.text();
        const Function asked = slice(run.lowered->whole, Question::Displaced);
        EXPECT_EQ(verify(asked), "");
        TestBatch batch(asked, 21, 7u);
        const auto told = answers(batch, asked);
        EXPECT_EQ(told.count("N"), kind[0] == 'd' ? 1u : 0u);
        const auto given = [&](ShaderInput input, size_t c, size_t k) {
            return double(batch.inputs[size_t(input) + c][k]);
        };
        for (size_t c = 0; c < 3; ++c)
            for (size_t k = 0; k < 21; ++k) {
                const double u = given(ShaderInput::u, 0, k), N = given(ShaderInput::N, c, k);
                EXPECT_NEAR(told.at("P")[c][k], given(ShaderInput::P, c, k) + 2 * u * N, 1e-5);
                EXPECT_NEAR(told.at("dPdu")[c][k],
                            given(ShaderInput::dPdu, c, k) + 2 * N +
                                2 * u * given(ShaderInput::dNdu, c, k),
                            1e-5);
                EXPECT_NEAR(told.at("dPdv")[c][k],
                            given(ShaderInput::dPdv, c, k) + 2 * u * given(ShaderInput::dNdv, c, k),
                            1e-5);
            }
    }
}

TEST(Displacement, IsNoPartOfShading) {
    ShaderRun run("surface d() { P += .1 * N; Oi = 1; Ci = color(noise(P)); }");
    ASSERT_TRUE(run.lowered) << run.diagnostics.text();
    for (Question question : {Question::Shade, Question::Prepare, Question::Opacity})
        for (const OutputSlot &slot : slice(run.lowered->whole, question).outputs)
            EXPECT_NE(slot.name.kind, OutputKind::P) << nameOf(question);
    const Function displace = slice(run.lowered->whole, Question::Displace);
    EXPECT_EQ(displace.outputs.size(), 3u);
}

} // namespace
} // namespace candela::ir
