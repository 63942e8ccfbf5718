// SPDX-License-Identifier: Apache-2.0
#include "foundation/units/color_basis.h"

#include <gtest/gtest.h>

namespace candela {
namespace {

std::vector<float> uplift(const ColorBasis &basis, const Color &rgb) {
    if (basis.isRgb())
        return {rgb.c.begin(), rgb.c.end()};
    std::vector<float> samples;
    for (const auto &weights : basis.samplesFromRgb)
        samples.push_back(weights[0] * rgb[0] + weights[1] * rgb[1] + weights[2] * rgb[2]);
    return samples;
}

Color back(const ColorBasis &basis, const std::vector<float> &samples) {
    if (basis.isRgb())
        return {samples[0], samples[1], samples[2]};
    Color rgb;
    for (int primary = 0; primary < 3; ++primary)
        for (int k = 0; k < basis.samples; ++k)
            rgb[primary] += basis.rgbFromSamples[primary][k] * samples[k];
    return rgb;
}

class EvenBasis : public testing::TestWithParam<int> {};

TEST_P(EvenBasis, WhiteIsOneInAllSamplesAndComesBack) {
    const ColorBasis basis = evenBasis(GetParam());
    ASSERT_EQ(basis.samples, GetParam());
    for (float sample : uplift(basis, Color(1)))
        EXPECT_NEAR(sample, 1, 1e-6);
    for (float primary : back(basis, std::vector<float>(GetParam(), 1.0f)).c)
        EXPECT_NEAR(primary, 1, 1e-6);
}

TEST_P(EvenBasis, ColoursComeBack) {
    if (GetParam() < 3)
        return; // Luminance alone.
    const ColorBasis basis = evenBasis(GetParam());
    for (const Color &rgb : {Color(1, 0, 0), Color(0, 1, 0), Color(0, 0, 1), Color(.2f, .7f, .4f)})
        for (int primary = 0; primary < 3; ++primary)
            EXPECT_NEAR(back(basis, uplift(basis, rgb))[primary], rgb[primary], 1e-6);
}

TEST_P(EvenBasis, UpliftMakesNothingNegative) {
    for (const auto &weights : evenBasis(GetParam()).samplesFromRgb)
        for (float weight : weights)
            EXPECT_GE(weight, 0);
}

TEST_P(EvenBasis, LuminanceIsThatOfTheColour) {
    const ColorBasis basis = evenBasis(GetParam());
    const std::vector<float> weights = basis.luminance();
    const Color rgb(.2f, .7f, .4f);
    float sum = 0;
    const std::vector<float> samples = uplift(basis, rgb);
    for (int k = 0; k < basis.samples; ++k)
        sum += weights[k] * samples[k];
    EXPECT_NEAR(sum, luminance(rgb), 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Samples, EvenBasis, testing::Values(1, 3, 4, 5, 8));

} // namespace
} // namespace candela
