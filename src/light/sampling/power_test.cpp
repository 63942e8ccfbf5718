// SPDX-License-Identifier: Apache-2.0
#include "light/sampling/power.h"

#include <gtest/gtest.h>

using namespace candela;

TEST(Power, LogarithmsAndExponentialsAreThoseOfTheLibrary) {
    for (double x = 1e-300; x < 1e300; x *= 1.37)
        EXPECT_NEAR(logOf(x), std::log(x), 1e-14 + 1e-15 * std::fabs(std::log(x))) << x;
    for (double tau = 1; tau > 1e-12; tau *= 0.7) {
        EXPECT_NEAR(logOf(1 - tau / 2), std::log(1 - tau / 2), 1e-15) << tau;
        EXPECT_NEAR(logOf(1 + tau), std::log(1 + tau), 1e-15) << tau;
    }
    EXPECT_EQ(logOf(1), 0);
    for (double x = -700; x <= 700; x += 0.73)
        EXPECT_NEAR(expOf(x) / std::exp(x), 1, 1e-13) << x;
    EXPECT_EQ(expOf(0), 1);
}
