// SPDX-License-Identifier: Apache-2.0
// Question::Furnace, Bounds and LightBounds of texts: what is known of them over a box.
#include "language/ir/lower/test_support.h"
#include "language/ir/questions/questions.h"
#include "language/ir/transform/light_rule.h"

#include <cmath>

namespace candela::ir {
namespace {

/// A text at a point of a plane, with a box of the given extent about it.
class BoxRun {
public:
    explicit BoxRun(const std::string &source, float extent = .25f) : run_(source, 1) {
        if (!run_.lowered)
            return;
        whole = applyLightRule(run_.lowered->whole, LightRule::Path);
        for (auto &plane : run_.batch->inputs)
            std::fill(plane.begin(), plane.end(), 0.0f);
        set(ShaderInput::P, {.25f, .5f, 0});
        for (ShaderInput normal : {ShaderInput::N, ShaderInput::Ng, ShaderInput::fieldAxis})
            set(normal, {0, 0, -1});
        set(ShaderInput::I, {.6f, 0, .8f});
        set(ShaderInput::dPdu, {1, 0, 0});
        set(ShaderInput::dPdv, {0, 1, 0});
        set(ShaderInput::u, {.25f}), set(ShaderInput::v, {.5f});
        set(ShaderInput::s, {.25f}), set(ShaderInput::t, {.5f});
        set(ShaderInput::dsdu, {1}), set(ShaderInput::dtdv, {1});
        set(ShaderInput::Cs, {1, 1, 1}), set(ShaderInput::Os, {1, 1, 1});
        set(ShaderInput::Du, {extent}), set(ShaderInput::Dv, {extent});
        set(ShaderInput::Ps, {.25f, .5f, -2});
    }

    void set(ShaderInput input, const std::vector<float> &value) { run_.setInput(input, value); }
    /// Channel 0 of an output.
    float ask(const std::string &output, Question question = Question::Bounds) {
        const Function function = slice(whole, question);
        EXPECT_EQ(verify(function), "") << print(function);
        const auto planes = run_.batch->run(
            function, [](const Function &f, const ShaderArgs &args) { interpret(f, args); });
        const int slot = slotOf(function.outputs, OutputName(output));
        EXPECT_GE(slot, 0) << output;
        return slot < 0 ? 0 : planes[std::size_t(slot)][0];
    }

    Function whole;

private:
    ShaderRun run_;
};

std::string surface(const std::string &body) { return "surface test() {" + body + "}"; }
std::string glow(const std::string &value) { return surface("Ci = " + value + ";"); }

TEST(Furnace, DiffuseSurfacesReflectTheirAlbedoExactly) {
    BoxRun run(surface("Ci = .3 * diffuse(normalize(N)) + .5;"));
    EXPECT_FLOAT_EQ(run.ask("reflectance", Question::Furnace), .3f);
    EXPECT_FLOAT_EQ(run.ask("Ce", Question::Furnace), .5f);
    EXPECT_FLOAT_EQ(run.ask("Oi", Question::Furnace), 1);
}

TEST(Furnace, WholeLobesAreIntegratedAndOthersSummed) {
    BoxRun lobe(
        surface("illuminance(P, N, PI / 2) Ci += Cl * pow(normalize(L) . normalize(N), 3);"));
    EXPECT_NEAR(lobe.ask("reflectance", Question::Furnace), 2 / 4.0, 1e-6);
    // Half of the sphere, without a cosine: 2 pi / pi.
    BoxRun flat(surface("illuminance(P) { if (L . N > 0) Ci += Cl; }"));
    EXPECT_NEAR(flat.ask("reflectance", Question::Furnace), 2, .02);
    BoxRun highlight(surface("Ci = specular(normalize(N), -normalize(I), .5);"));
    EXPECT_NEAR(highlight.ask("reflectance", Question::Furnace), .38, .1);
    BoxRun mirror(surface("Ci = .7 * trace(P, reflect(I, N));"));
    EXPECT_FLOAT_EQ(mirror.ask("reflectance", Question::Furnace), .7f);
}

TEST(Bounds, OfWhatIsAffineAreExact) {
    BoxRun run(glow("2 * s + 3 * t"));
    EXPECT_FLOAT_EQ(run.ask("Ce"), 2);
    EXPECT_FLOAT_EQ(run.ask("Ce by u"), 2);
    EXPECT_FLOAT_EQ(run.ask("Ce by v"), 3);
    EXPECT_LT(run.ask("Ce tolerance"), 1e-5f);
    EXPECT_EQ(run.ask("Oi tolerance"), 0);
    EXPECT_EQ(run.ask("reflectance tolerance"), 0);
}

TEST(Bounds, OfASquareAreItsSecondOrder) {
    BoxRun run(glow("s * s"));
    EXPECT_FLOAT_EQ(run.ask("Ce by u"), .5f);
    EXPECT_NEAR(run.ask("Ce tolerance"), .125f * .125f, 1e-6);
}

TEST(Bounds, OfEdgesAreTheStepWhereTheBoxHasOneAndNothingElsewhere) {
    EXPECT_NEAR(BoxRun(glow("step(.3, s)")).ask("Ce tolerance"), 1, 1e-5);
    EXPECT_EQ(BoxRun(glow("step(.5, s)")).ask("Ce tolerance"), 0);
    EXPECT_EQ(BoxRun(glow("step(.3, s)"), .01f).ask("Ce tolerance"), 0);
}

TEST(Bounds, BothSidesOfABranchCountWhereTheBoxTakesBoth) {
    const std::string text = surface("if (s > .3) Ci = 5; else Ci = 2;");
    EXPECT_EQ(BoxRun(text).ask("Ce"), 2);
    EXPECT_NEAR(BoxRun(text).ask("Ce tolerance"), 3, 1e-5);
    EXPECT_EQ(BoxRun(text, .01f).ask("Ce tolerance"), 0);
}

TEST(Bounds, LoopsTurnAsTheMiddleDoesAndAreUnknownWhereOthersTurnOtherwise) {
    const auto text = [](const std::string &count) {
        return surface("float k, x = 0; for (k = 0; k < " + count + "; k += 1) x += s; Ci = x;");
    };
    BoxRun even(text("7"));
    EXPECT_FLOAT_EQ(even.ask("Ce by u"), 7);
    EXPECT_LT(even.ask("Ce tolerance"), 1e-4f);
    EXPECT_TRUE(std::isinf(BoxRun(text("10 * s")).ask("Ce tolerance")));
    EXPECT_FALSE(std::isinf(BoxRun(text("10 * s"), .001f).ask("Ce tolerance")));
}

TEST(Bounds, ArraysKeepFormsAndUnsureIndicesMeanAnyElement) {
    const std::string list = "float a[3] = { .1, s, .7 };";
    BoxRun known(surface(list + "Ci = a[1 + floor(u)];"));
    EXPECT_FLOAT_EQ(known.ask("Ce by u"), 1);
    EXPECT_LT(known.ask("Ce tolerance"), 1e-5f);
    BoxRun any(surface(list + "Ci = a[floor(10 * s)];"));
    EXPECT_NEAR(any.ask("Ce tolerance"), .6f, 1e-5);
    // Who stores where nobody knows, leaves nothing known.
    BoxRun lost(surface(list + "a[floor(10 * s)] = 1; Ci = a[0];"));
    EXPECT_TRUE(std::isinf(lost.ask("Ce tolerance")));
}

TEST(Bounds, StoresThatSomePointsMakeLeaveBothValues) {
    BoxRun run(
        surface("float a[2]; a[floor(u)] = 1; if (s > .3) a[floor(u)] = 4; Ci = a[floor(v)];"));
    EXPECT_EQ(run.ask("Ce"), 1);
    EXPECT_NEAR(run.ask("Ce tolerance"), 3, 1e-5);
}

TEST(Bounds, HoldOverTheConeOfViews) {
    BoxRun run(glow("xcomp(normalize(I))"));
    EXPECT_LT(run.ask("Ce tolerance"), 1e-5f);
    const float W = .01f;
    run.set(ShaderInput::Dw, {W});
    // sin of the angle to the cone's side, across.
    const float off = run.ask("Ce tolerance");
    EXPECT_GE(off, .8f * std::sqrt(W / 3.1416f));
    EXPECT_LE(off, 2 * std::sqrt(W / 3.1416f));
}

TEST(Bounds, OfTheShadersOwnAreTaken) {
    const std::string text =
        surface("Ci = .5 + s * diffuse(normalize(N)); DCiDu = 3; TCiDu = .25; TCiDv = .5;");
    BoxRun run(text);
    EXPECT_EQ(run.ask("Ce by u"), 3);
    EXPECT_EQ(run.ask("Ce by v"), 0);
    EXPECT_EQ(run.ask("Ce tolerance"), .75f);
    EXPECT_EQ(run.ask("reflectance by u"), 0);
    EXPECT_EQ(run.ask("reflectance tolerance"), 1.5f);
    EXPECT_EQ(run.ask("Oi tolerance"), 0);
    EXPECT_TRUE(boundFacts(run.whole).givenByShader);
    // Of the views it says nothing.
    run.set(ShaderInput::Dw, {.1f});
    EXPECT_TRUE(std::isinf(run.ask("Ce tolerance")));
}

TEST(Bounds, ShadersReadTheBox) {
    BoxRun run(surface("Ci = s; TCiDu = Du; TCiDv = Dv; TCiDw = 0; DCiDw = Dw;"), .125f);
    run.set(ShaderInput::Dw, {.5f});
    EXPECT_EQ(run.ask("Ce tolerance"), .125f + .125f + .25f);
    // Elsewhere the region that is sampled stands for it.
    BoxRun shown(surface("Ci = Du + Dw;"));
    shown.set(ShaderInput::du, {.0625f}), shown.set(ShaderInput::Dw, {1});
    EXPECT_EQ(shown.ask("Ci", Question::Shade), .0625f);
}

TEST(Bounds, WhatIsNotKnownHasALine) {
    BoxRun run("surface test() {\n Ci = s;\n Ci += texture(\"x.tif\");\n}");
    const BoundFacts facts = boundFacts(run.whole);
    EXPECT_FALSE(facts.givenByShader);
    ASSERT_EQ(facts.boundless.size(), 1u);
    EXPECT_EQ(facts.boundless[0].what, "texture()");
    EXPECT_EQ(facts.boundless[0].line, 3);
    EXPECT_TRUE(boundFacts(BoxRun(glow("s")).whole).boundless.empty());
}

TEST(Bounds, LightsHearNoLight) {
    for (const std::string Cl :
         {"1 + xcomp(P) + diffuse(N)", "u > 2 ? 7 : 1 + xcomp(P) + specular(N, N, .1)"}) {
        BoxRun run("light test() { illuminate(P + vector(comp(diffuse(N), 0)), N, PI / 2) Cl = " +
                   Cl + "; }");
        EXPECT_FLOAT_EQ(run.ask("Cl", Question::LightBounds), 1.25f) << Cl;
        EXPECT_LT(run.ask("Cl tolerance", Question::LightBounds), 1e-5f) << Cl;
    }
}

TEST(Bounds, LightsAreKnownOverTheirSurfaceAndDirections) {
    const std::string text =
        "light test() { illuminate(P) { Cl = 1 + xcomp(P) + ycomp(normalize(L)); } }";
    BoxRun run(text);
    EXPECT_FLOAT_EQ(run.ask("Cl", Question::LightBounds), 1.25f);
    const float narrow = run.ask("Cl tolerance", Question::LightBounds);
    EXPECT_LT(narrow, .02f);
    run.set(ShaderInput::Dw, {.03f});
    EXPECT_GE(run.ask("Cl tolerance", Question::LightBounds), narrow + .09f);
    BoxRun given("light test() { illuminate(P) Cl = 1; DClDu = 2; TClDu = .5; TClDv = 0; }");
    EXPECT_EQ(given.ask("Cl by u", Question::LightBounds), 2);
    EXPECT_EQ(given.ask("Cl tolerance", Question::LightBounds), .5f);
    EXPECT_TRUE(lightBoundFacts(given.whole).givenByShader);
}

} // namespace
} // namespace candela::ir
