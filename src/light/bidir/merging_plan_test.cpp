// SPDX-License-Identifier: Apache-2.0
#include "light/path/settings.h"

#include <gtest/gtest.h>

namespace candela {
namespace {

/// The bias, as r^2, goes to nothing; the variance of the mean of n rounds, the mean of 1/(r^2 n),
/// does, too.
TEST(MergingPlan, ShrinksDiscsAndStillConverges) {
    MergingPlan plan;
    plan.radius = .3f, plan.samplesOfRound = 4;
    EXPECT_FLOAT_EQ(plan.radiusAt(0), .3f);
    EXPECT_FLOAT_EQ(plan.radiusAt(3), .3f);
    EXPECT_FLOAT_EQ(plan.radiusAt(4 * 255), .15f);
    EXPECT_FLOAT_EQ(plan.radiusAt(4 * 65535), .075f);
    double variance = 0;
    constexpr int rounds = 1 << 16;
    for (int round = 0; round < rounds; ++round) {
        const double radius = plan.radiusAt(4 * round);
        variance += 1 / (radius * radius) / rounds / rounds;
    }
    EXPECT_LT(variance, .01 / (.3 * .3));
}

/// Rounds are where they are, wherever a frame goes on.
TEST(MergingPlan, KnowsItsRounds) {
    MergingPlan plan;
    plan.samplesOfRound = 4;
    EXPECT_EQ(plan.roundEnd(0), 4);
    EXPECT_EQ(plan.roundEnd(3), 4);
    EXPECT_EQ(plan.roundEnd(16), 20);
}

} // namespace
} // namespace candela
