// SPDX-License-Identifier: Apache-2.0
#include "light/probe/point_estimate.h"

#include "foundation/base/hash.h"

#include <cmath>
#include <gtest/gtest.h>

namespace candela {

namespace {

/// Uniform in [0,1).
double uniform(std::uint64_t &state) {
    state += 0x9e3779b97f4a7c15u;
    return double(mixBits(state) >> 11) * 0x1p-53;
}

} // namespace

TEST(PointEstimate, MeansAreOfAllSamplesAndErrorsOfBatches) {
    PointEstimate estimate;
    for (int batch = 0; batch < PointEstimate::batches; ++batch)
        for (int k = 0; k < 2; ++k)
            estimate.add(batch, Color(float(batch + 1), 0, 2));
    estimate.setSamples(2);
    EXPECT_EQ(estimate.samples(), 32);
    EXPECT_DOUBLE_EQ(estimate.mean()[0], 8.5);
    EXPECT_DOUBLE_EQ(estimate.mean()[2], 2);
    EXPECT_NEAR(estimate.luminance(), .2126 * 8.5 + .0722 * 2, 1e-6);
    // Of 1 to 16: a variance of 22.6667, over 16.
    EXPECT_NEAR(estimate.standardError(), .2126 * std::sqrt(22.6667 / 16), 1e-5);
}

TEST(StoppingRule, LooksComeAtPowersOfTwoAndAtTheLimit) {
    const StoppingRule rule(1000, .01);
    for (int look = 0; look < 6; ++look) {
        EXPECT_EQ(rule.samplesAt(look), 1 << look);
        EXPECT_FALSE(rule.isLast(look));
    }
    EXPECT_EQ(rule.samplesAt(6), 63); // 1000 / 16, rounded up.
    EXPECT_TRUE(rule.isLast(6));
    EXPECT_EQ(StoppingRule(1000, std::nullopt).samplesAt(0), 63);
    EXPECT_TRUE(StoppingRule(1000, std::nullopt).isLast(0));
    EXPECT_EQ(StoppingRule(1, .01).samplesAt(0), 1);
}

TEST(StoppingRule, DarknessIsNoAccuracy) {
    PointEstimate dark, lit;
    for (int batch = 0; batch < PointEstimate::batches; ++batch)
        dark.add(batch, Color(0)), lit.add(batch, Color(1));
    dark.setSamples(1), lit.setSamples(1);
    EXPECT_FALSE(StoppingRule(1 << 20, .01).suffices(dark, 0));
    EXPECT_TRUE(StoppingRule(1 << 20, .01).suffices(lit, 0));
    EXPECT_FALSE(StoppingRule(1 << 20, std::nullopt).suffices(lit, 0));
}

/// Samples that are 1 with a probability of one half: the interval at which they stop is to hold
/// that in 95 cases of 100. A rule of 5 % at every look would hold it in 89.
TEST(StoppingRule, IntervalsHoldTheValueAlthoughSamplesTellWhenToStop) {
    const StoppingRule rule(1 << 16, .05);
    constexpr int trials = 4000;
    int held = 0;
    std::uint64_t state = 1;
    for (int trial = 0; trial < trials; ++trial) {
        PointEstimate estimate;
        for (int look = 0, from = 0;; ++look) {
            for (int k = from; k < rule.samplesAt(look); ++k)
                for (int batch = 0; batch < PointEstimate::batches; ++batch)
                    estimate.add(batch, Color(uniform(state) < .5 ? 1.0f : 0.0f));
            estimate.setSamples(from = rule.samplesAt(look));
            if (!rule.suffices(estimate, look) && !rule.isLast(look))
                continue;
            held += std::fabs(estimate.luminance() - .5) <= rule.halfWidth(estimate, look);
            break;
        }
    }
    EXPECT_GE(held, int(.95 * trials));
}

} // namespace candela
