// SPDX-License-Identifier: Apache-2.0
#include "light/sampling/mis.h"

#include <cmath>
#include <gtest/gtest.h>
#include <vector>

namespace candela {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float densities[] = {1e-45f, 1e-38f, 1e-30f, 1e-10f, 0.25f,   1,
                               3,      1e10f,  1e30f,  3e38f,  infinity};

TEST(MisWeight, IsThePowerHeuristic) {
    EXPECT_FLOAT_EQ(misWeight(1, 1), 0.5f);
    EXPECT_FLOAT_EQ(misWeight(3, 1), 0.9f);
    EXPECT_FLOAT_EQ(misWeight(1, 3), 0.1f);
    EXPECT_FLOAT_EQ(misWeight(1e30f, 3e30f), 0.1f);
    EXPECT_FLOAT_EQ(misWeight(1e-30f, 3e-30f), 0.1f);
}

TEST(MisWeight, OfAnyTwoDensitiesIsAShareOfOne) {
    for (float a : densities)
        for (float b : densities) {
            const float weight = misWeight(a, b);
            EXPECT_GE(weight, 0) << a << ' ' << b;
            EXPECT_LE(weight, 1) << a << ' ' << b;
            EXPECT_FLOAT_EQ(weight + misWeight(b, a), 1) << a << ' ' << b;
        }
}

TEST(MisWeight, OfWhatTheOtherCannotFindIsOne) {
    for (float a : densities) {
        EXPECT_EQ(misWeight(a, 0), 1) << a;
        EXPECT_EQ(misWeight(0, a), 0) << a;
    }
    EXPECT_EQ(misWeight(0, 0), 0);
}

TEST(LightSampleFactors, AreFiniteAtExtremesAndPartnersOfEmissionWeights) {
    for (float pl : densities)
        for (float pd : densities) {
            const float wanted = 1;
            float factor, weight;
            lightSampleFactors(1, &pl, &pd, &wanted, &factor);
            emissionWeights(1, &pd, &pl, &weight);
            EXPECT_TRUE(std::isfinite(weight));
            if (pl > 1e-38f && pl < 1e38f) {
                EXPECT_NEAR(factor * float(M_PI) * pl + weight, 1, 1e-5) << pl << ' ' << pd;
            }
        }
}

TEST(LightSampleFactors, LeaveDeltaLightsAndUnwantedLanesAlone) {
    const std::vector<float> lightPdf{0, 0, 2}, directionPdf{5, 0, 5};
    const std::vector<float> wanted{1, 1, 0};
    std::vector<float> factor(3);
    lightSampleFactors(3, lightPdf.data(), directionPdf.data(), wanted.data(), factor.data());
    EXPECT_EQ(factor, (std::vector<float>{1, 1, 0}));
}

TEST(EmissionWeights, CountInFullWhereThereWasNoChoice) {
    const float none = 0, lightPdf = 7;
    float weight;
    emissionWeights(1, &none, &lightPdf, &weight);
    EXPECT_EQ(weight, 1);
}

} // namespace
} // namespace candela
