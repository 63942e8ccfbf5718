// SPDX-License-Identifier: Apache-2.0
// Texts lowered for colours of 1, 3, 4 and 8 samples: what is said in RGB, and what sample by
// sample.
#include "language/ir/lower/test_support.h"

#include <cmath>

namespace candela::ir {
namespace {

using Rgb = std::array<double, 3>;

class ColorSamples : public testing::TestWithParam<int> {
protected:
    int samples() const { return GetParam(); }
    const ColorBasis basis_ = evenBasis(GetParam());

    LoweringOptions options() const {
        LoweringOptions options;
        options.colors = basis_;
        return options;
    }

    std::vector<ShaderRun::Plane> evaluate(const std::string &type, const std::string &body) {
        ShaderRun run(surfaceWith(type, body), 5, {}, {}, options());
        EXPECT_TRUE(run.lowered) << body << "\n" << run.diagnostics.text();
        return run.lowered ? run.run().at("result") : std::vector<ShaderRun::Plane>{};
    }

    double uplifted(const Rgb &rgb, int sample) const {
        if (basis_.isRgb())
            return rgb[sample];
        const auto &weights = basis_.samplesFromRgb[sample];
        return weights[0] * rgb[0] + weights[1] * rgb[1] + weights[2] * rgb[2];
    }

    void expectColor(const std::string &body, const Rgb &rgb) {
        const auto result = evaluate("color", body);
        ASSERT_EQ(int(result.size()), samples()) << body;
        for (int k = 0; k < samples(); ++k)
            EXPECT_NEAR(result[k][0], uplifted(rgb, k), 2e-6) << body << ", sample " << k;
    }
    void expectFloat(const std::string &body, double expected) {
        const auto result = evaluate("float", body);
        ASSERT_EQ(result.size(), 1u);
        EXPECT_NEAR(result[0][0], expected, 2e-6 * std::max(1.0, std::abs(expected))) << body;
    }
};

TEST_P(ColorSamples, ColoursOfTheTextAreUplifted) {
    expectColor("result = color(.2, .7, .4);", {.2, .7, .4});
    expectColor("result = .3;", {.3, .3, .3});
    expectColor("result = color \"hsv\" (0, 1, .8);", {.8, 0, 0});
    expectColor("float h = 1 / 3; result = color \"hsl\" (h, 1, .5);", {0, 1, 0});
    expectColor("vector v = vector(.1, .2, .9); result = (color v);", {.1, .2, .9});
}

TEST_P(ColorSamples, ArithmeticIsBySamples) {
    const auto product = evaluate("color", "color c = color(.2, .7, .4); result = c * c + Cs * 0;");
    for (int k = 0; k < samples(); ++k)
        EXPECT_NEAR(product[k][0], std::pow(uplifted({.2, .7, .4}, k), 2), 2e-6);
    expectFloat("result = ncomps;", samples());
    expectFloat("color c = color(.2, .7, .4); result = comp(c, ncomps - 1);",
                uplifted({.2, .7, .4}, samples() - 1));
    const auto set = evaluate("color", "color c = 0; setcomp(c, ncomps - 1, 5); result = c;");
    for (int k = 0; k < samples(); ++k)
        EXPECT_EQ(set[k][0], k == samples() - 1 ? 5 : 0);
}

TEST_P(ColorSamples, PhotometryIsThatOfTheColour) {
    const double Y = luminanceWeights[0] * .2 + luminanceWeights[1] * .7 + luminanceWeights[2] * .4;
    expectFloat("result = totalluminance(color(.2, .7, .4));", luminousEfficacy * Y);
    expectFloat("result = totalradiance(color .5);", .5);
    if (samples() >= 3) {
        expectFloat("result = totalradiance(color(.2, .7, .4));", 1.3 / 3);
        expectColor("result = ctransform(\"XYZ\", \"rgb\","
                    "                    ctransform(\"XYZ\", color(.2, .7, .4)));",
                    {.2, .7, .4});
        expectFloat("color c = color(.2, .7, .4); result = c . c;", .69); // As vectors.
        expectFloat("vector v = vector(color(.2, .7, .4)); result = v[1];", .7);
    }
}

TEST_P(ColorSamples, NoiseIsAColourOfRgb) {
    const auto colour = evaluate("color", "result = noise(P);");
    const auto numbers = evaluate("vector", "result = vector(noise(P));");
    ASSERT_EQ(int(colour.size()), samples());
    for (int k = 0; k < samples(); ++k)
        EXPECT_NEAR(colour[k][2], uplifted({numbers[0][2], numbers[1][2], numbers[2][2]}, k), 2e-6);
}

TEST_P(ColorSamples, LightIsSampleBySample) {
    ShaderRun run("surface s() { Ci = diffuse(N) + .5 * ambient(); Oi = 1; }", 3, {}, {},
                  options());
    ASSERT_TRUE(run.lowered) << run.diagnostics.text();
    run.setInput(ShaderInput::N, {0, 0, 1});
    run.setSamples({{{0, 3, 4}, {1, 1, 1}}});
    for (int k = 0; k < samples(); ++k)
        run.batch->samples.Cl[k].assign(run.batch->samples.Cl[k].size(), float(k + 1));
    for (int k = 0; k < samples(); ++k)
        run.batch->answers.ambient[k].assign(run.batch->answers.ambient[k].size(), float(10 * k));
    run.batch->answers.givesAmbient = true;
    const auto Ci = run.run().at("Ci");
    ASSERT_EQ(int(Ci.size()), samples());
    for (int k = 0; k < samples(); ++k)
        EXPECT_NEAR(Ci[k][0], .8 * (k + 1) + 5 * k, 1e-5);
}

TEST_P(ColorSamples, ParametersHaveTheirDefaultsUplifted) {
    const ShaderRun run("surface s(color c = color(.2, .7, .4);) { Ci = c; Oi = 1; }", 3, {}, {},
                        options());
    ASSERT_TRUE(run.lowered) << run.diagnostics.text();
    const auto &defaults = run.lowered->parameters.at(0).defaults;
    ASSERT_EQ(int(defaults.size()), samples());
    for (int k = 0; k < samples(); ++k)
        EXPECT_NEAR(defaults[k], uplifted({.2, .7, .4}, k), 2e-6);
}

INSTANTIATE_TEST_SUITE_P(All, ColorSamples, testing::Values(1, 3, 4, 8));

} // namespace
} // namespace candela::ir
