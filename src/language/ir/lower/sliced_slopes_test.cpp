// SPDX-License-Identifier: Apache-2.0
// Derivatives of what slices answer.
#include "language/ir/lower/patch_points.h"
#include "language/ir/questions/questions.h"
#include "language/ir/transform/jet.h"

#include <cmath>

namespace candela::ir {
namespace {

struct Case {
    const char *name, *text;
    Question question;
    std::vector<const char *> outputs;
};

const Case cases[] = {
    {"Light",
     "light lamp(float intensity = 3;) {"
     "  illuminate(P) Cl = intensity * noise(4 * u, v) / (1 + L . L); }",
     Question::Light,
     {"L", "Cl"}},
    {"Opacity",
     "surface glassy(float sharp = 2;) { float a = 0, i;"
     "  for (i = 0; i < 3; i += 1) a = a * u + noise(sharp * P);"
     "  Oi = Os * smoothstep(-1, 3, a); Ci = Oi * diffuse(normalize(N)); }",
     Question::Opacity,
     {"Oi"}},
    {"Prepare",
     "surface cones(float Kd = .5;) { color C = Kd * Cs * noise(3 * s, t);"
     "  if (u > .31) C *= 1 + v;"
     "  Oi = Os; Ci = Oi * (C * diffuse(normalize(N)) + .1 * C); }",
     Question::Prepare,
     {"cone 0 axis", "cone 0 importance", "Ce", "Oi"}},
    {"Emit",
     "surface glows() { Oi = 1; Ci = color(sin(3 * u), noise(P), u * v) + Du(noise(.4 * s)); }",
     Question::Emit,
     {"Ce"}},
};

class SlicedSlopes : public testing::TestWithParam<int> {};

TEST_P(SlicedSlopes, AgreeWithCentralDifferences) {
    const Case &c = cases[size_t(GetParam())];
    const double h = 1.0 / 1024;
    constexpr int points = 9;
    ShaderRun at(c.text, points), beside(c.text, 4 * points);
    ASSERT_TRUE(at.lowered && beside.lowered) << at.diagnostics.text();
    const Function plain = slice(at.lowered->whole, c.question);
    Function sloped = plain;
    const SlopeReport report = addOutputSlopes(sloped, {Direction::U, Direction::V});
    ASSERT_FALSE(report.fault) << report.fault->text;
    ASSERT_EQ(verify(sloped), "") << print(sloped);
    for (ShaderRun *run : {&at, &beside})
        for (int c = 0; c < 3; ++c) // The lit point stays.
            run->batch->inputs[size_t(ShaderInput::Ps) + size_t(c)].assign(
                size_t(run->batch->padded()), float(3 + c));
    for (int k = 0; k < points; ++k) {
        const double u = 0.09 + 0.31 * (k % 3), v = 0.12 + 0.27 * (k / 3);
        placeOnPatch(at, k, u, v);
        placeOnPatch(beside, 4 * k, u + h, v), placeOnPatch(beside, 4 * k + 1, u - h, v);
        placeOnPatch(beside, 4 * k + 2, u, v + h), placeOnPatch(beside, 4 * k + 3, u, v - h);
    }
    const auto run = [](const Function &f, const ShaderArgs &args) { interpret(f, args); };
    const auto found = at.batch->run(sloped, run), near = beside.batch->run(plain, run);
    const auto plane = [](const Function &f, const std::string &name, int component) {
        for (size_t k = 0; k < f.outputs.size(); ++k)
            if (f.outputs[k].name == name && f.outputs[k].component == component)
                return k;
        ADD_FAILURE() << name;
        return size_t(0);
    };
    double largest = 0;
    for (const std::string name : c.outputs)
        for (int component = 0; component < (name == "cone 0 importance" ? 1 : 3); ++component)
            for (int d = 0; d < 2; ++d) {
                const auto &x = near[plane(plain, name, component)];
                const auto &slope = found[plane(sloped, "d" + name + (d ? "dv" : "du"), component)];
                for (int k = 0; k < points; ++k) {
                    const double expected =
                        (double(x[4 * k + 2 * d]) - x[4 * k + 2 * d + 1]) / (2 * h);
                    EXPECT_NEAR(slope[k], expected, 4e-3 * std::max(1.0, std::fabs(expected)))
                        << name << " " << component << " by " << (d ? "v" : "u");
                    largest = std::max(largest, std::abs(expected));
                }
            }
    EXPECT_GT(largest, 0.5);
}

INSTANTIATE_TEST_SUITE_P(Questions, SlicedSlopes, testing::Range(0, int(std::size(cases))),
                         [](const auto &info) { return std::string(cases[info.param].name); });

/// What a frame holds has lost where it came from.
TEST(SlicedSlopesOfFrames, AreRefused) {
    ShaderRun run("surface s() { Ci = Cs * noise(P) * diffuse(normalize(N)); Oi = 1; }");
    ASSERT_TRUE(run.lowered);
    Function scatter = slice(run.lowered->whole, Question::Scatter);
    ASSERT_GT(scatter.surfaceSlots, 0);
    const std::string before = print(scatter);
    const SlopeReport report = addOutputSlopes(scatter, {Direction::U});
    ASSERT_TRUE(report.fault);
    EXPECT_NE(report.fault->text.find("frame"), std::string::npos);
    EXPECT_EQ(print(scatter), before);
}

} // namespace
} // namespace candela::ir
