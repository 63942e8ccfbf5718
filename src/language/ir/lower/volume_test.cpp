// SPDX-License-Identifier: Apache-2.0
// Volume shaders: what is known of them, what their questions answer, and the light they ask for.
#include "language/ir/lower/test_support.h"
#include "language/ir/questions/questions.h"

#include <cmath>

namespace candela::ir {
namespace {

struct Text {
    const char *name, *body;
    int notAffineLine = 0;
    bool affine = notAffineLine == 0; ///< What is only given another name has no line.
};

/// Each body stands in the second line.
const Text texts[] = {
    {"nothing", ""},
    {"fog",
     "float c = exp(-length(I)); Ci = mix(color(.5, .25, .125), Ci, c); Oi = mix(color 1, Oi, c);"},
    {"a veil over what is there",
     "float d = 1 - exp(-length(I)); Ci = mix(Ci, Oi * color(.5, .25, .1), d);"},
    {"absorption by channel", "Ci *= color(u, v, .5); Oi = Oi * .5 + .25;"},
    {"turned round", "Ci = color(1, .5, .25) - Ci / (2 + u); Oi = -Oi;"},
    {"by components", "setcomp(Ci, 1, 3 * comp(Ci, 1) + comp(Oi, 1) * u); setcomp(Oi, 2, .5);"},
    {"chosen", "if (u > 0) Ci = Ci * .5 + Oi; else Oi = Oi + v; Ci += (v > .3) ? Oi : Ci;"},
    {"in a loop",
     "float k; for (k = 0; k < 3 + u; k += 1) { Ci = Ci * .5 + color(k, u, v); Oi *= .9; }"},
    {"in an array",
     "color a[3] = {color 1, color 2, color 3}; a[1 + u * .5] = Ci * 2; Ci = a[1] + .5 * a[0];"},
    {"read and not used", "color c = Ci * Ci; Ci = Ci * .5;"},
    {"a square", "Ci = Ci * Ci;", 2},
    {"a root", "Ci = color(sqrt(comp(Ci, 0)), 0, 0);", 2},
    {"clamped", "Ci = clamp(Ci, color 0, color 1);", 2},
    {"mixed channels", "Ci = color(comp(Ci, 1), comp(Ci, 1), comp(Ci, 2));", 0, false},
    {"a choice by what arrives", "if (comp(Ci, 0) > .5) Ci = 1;", 2},
    {"a product of both", "Ci = Ci * Oi;", 2},
    {"opacity from colour", "Oi = Ci;", 0, false},
    {"as often as it is bright", "while (comp(Ci, 0) > .1) Ci *= .5;", 2},
};

using Planes = std::vector<ShaderRun::Plane>;

Planes ask(ShaderRun &run, const Function &function) {
    EXPECT_EQ(verify(function), "") << print(function);
    return run.batch->run(function,
                          [](const Function &f, const ShaderArgs &args) { interpret(f, args); });
}

TEST(Volumes, AreKnownToBeAffineOrNot) {
    for (const Text &text : texts) {
        ShaderRun run("volume v()\n{ " + std::string(text.body) + " }");
        ASSERT_TRUE(run.lowered) << text.name << run.diagnostics.text();
        const VolumeFacts facts = volumeFacts(run.lowered->whole);
        EXPECT_EQ(facts.affine, text.affine) << text.name;
        EXPECT_EQ(facts.notAffineLine, text.notAffineLine) << text.name;
    }
}

TEST(Volumes, HavePartsThatTogetherAreTheWhole) {
    for (const Text &text : texts) {
        if (!text.affine)
            continue;
        ShaderRun run("volume v()\n{ " + std::string(text.body) + " }", 40);
        const Function &whole = run.lowered->whole;
        const Function parts = slice(whole, Question::Segment);
        const Planes expected = ask(run, slice(whole, Question::Volume)), found = ask(run, parts);
        const Planes through = ask(run, slice(whole, Question::Transmission));
        const auto part = [&](OutputKind kind, int c) {
            return found[slotOf(parts.outputs, kind, c)];
        };
        for (int c = 0; c < 3; ++c)
            for (int lane = 0; lane < 40; ++lane) {
                const std::size_t i = lane;
                const double Ci = run.input(ShaderInput::pixelCi, lane, c);
                const double Oi = run.input(ShaderInput::pixelOi, lane, c);
                const double sum = part(OutputKind::Ci, c)[i] +
                                   part(OutputKind::CiOfCi, c)[i] * Ci +
                                   part(OutputKind::CiOfOi, c)[i] * Oi;
                EXPECT_NEAR(expected[c][i], sum, 4e-6) << text.name;
                EXPECT_NEAR(expected[3 + c][i],
                            part(OutputKind::Oi, c)[i] + part(OutputKind::OiOfOi, c)[i] * Oi, 4e-6)
                    << text.name;
                EXPECT_EQ(through[c][i], part(OutputKind::CiOfCi, c)[i]) << text.name;
            }
    }
}

/// A factor is not the difference of two large numbers.
TEST(Volumes, HaveFactorsThatLoseNothingBesideBrightLight) {
    ShaderRun run("volume v() { Ci = Ci * 1e-6 + 1e6; }");
    const Function parts = slice(run.lowered->whole, Question::Segment);
    EXPECT_EQ(ask(run, parts)[slotOf(parts.outputs, OutputKind::CiOfCi)][0], 1e-6f);
}

TEST(Volumes, NeedNoLightForWhatTheyLetThrough) {
    ShaderRun run("volume v() { color c = 0; illuminance (P) c += Cl; printf(\"%f\", u);\n"
                  "Ci = Ci * .5 + c; }");
    const auto asks = [](const Function &function, Op op) {
        return print(function).find(op == Op::Query ? "Query" : "Command") != std::string::npos;
    };
    const Function &whole = run.lowered->whole;
    EXPECT_TRUE(asks(slice(whole, Question::Segment), Op::Query));
    EXPECT_TRUE(asks(slice(whole, Question::Segment), Op::Command));
    EXPECT_FALSE(asks(slice(whole, Question::Transmission), Op::Query));
    EXPECT_FALSE(asks(slice(whole, Question::Transmission), Op::Command));
    EXPECT_TRUE(volumeFacts(whole).asksForLight && volumeFacts(whole).speaks);
}

// ---- Light ----

const std::vector<ShaderRun::Sample> lamps{{{0, 0, 1}, {1, 2, 3}, 1},
                                           {{0, 1, .1f}, {.5f, .25f, 0}, 2},
                                           {{1, 0, 0}, {0, 0, 0}, 1},
                                           {{.1f, 0, -2}, {.25f, 1, 1}, 2}};

/// Answers as the renderer would that has these lamps at every point. Accepts, in category 0, what
/// the batch's table accepts.
void answerLight(ShaderServices &services) {
    services[Service::gatherlight] = [](void *, const ServiceCall &call) {
        for (int k = 0; k < call.laneCount; ++k)
            call.result(1, k) = float(lamps.size());
    };
    services[Service::lightsample] = [](void *, const ServiceCall &call) {
        for (int k = 0; k < call.laneCount; ++k) {
            const ShaderRun::Sample &lamp = lamps[std::size_t(call.operand(1, k).number)];
            const std::uint8_t *accepts = call.args->categoryAccepts;
            const bool heard = call.operand(2, k).number < 0 || !accepts || accepts[lamp.light];
            call.result(0, k) = heard && lamp.Cl[1] != 0;
            for (int c = 0; c < 3; ++c)
                call.result(1 + c, k) = lamp.L[c], call.result(4 + c, k) = lamp.Cl[c];
            call.result(7, k) = float(lamp.light);
        }
    };
}

/// Loops that ask are loops that are given light, in every form and whatever stands in them.
TEST(Volumes, HearLightAsSurfacesDo) {
    const char *bodies[] = {
        "illuminance (P) Ci += Cl * u;",
        "illuminance (P, vector (0, 0, 1), PI / 2) Ci += Cl * length(L);",
        "illuminance (P, vector (0, 0, 1), PI) Ci += Cl;",
        "illuminance (\"second\", P) Ci += Cl;",
        "float k; for (k = 0; k < 3; k += 1) illuminance (P + k * I) { if (u > 0) Ci += Cl; else "
        "Oi += k; }",
        "illuminance (P) { if (comp(Cl, 0) > .9) break; Ci += Cl; }",
        "illuminance (P) { if (comp(Cl, 0) > .9) continue; Ci += Cl; }",
        "color c = diffuse(N) + specular(N, normalize(-I), .1); Ci += c;",
        "illuminance (P, 1, vector (0, 0, 1), 90, 1, 1) Ci += Cl;",
    };
    for (const char *body : bodies) {
        ShaderRun run("volume v() { Ci = 0; " + std::string(body) + " }", 40);
        ASSERT_TRUE(run.lowered) << body << run.diagnostics.text();
        run.setSamples(lamps);
        if (std::string(body).find("second") != std::string::npos)
            run.batch->samples.categoryAccepts = {0, 0, 1};
        run.batch->samples.lightCount = 2;
        answerLight(run.batch->services);
        const Function asking = slice(run.lowered->whole, Question::Volume);
        const Planes expected = ask(run, run.lowered->whole), found = ask(run, asking);
        for (std::size_t plane = 0; plane < expected.size(); ++plane)
            EXPECT_EQ(found[plane], expected[plane]) << body << " " << plane;
    }
}

} // namespace
} // namespace candela::ir
