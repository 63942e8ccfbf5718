// SPDX-License-Identifier: Apache-2.0
#include "language/runtime/scalar_math.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace candela::runtime {
namespace {

/// Within `ulps` units in the last place of the double-precision result.
void expectClose(float found, double expected, double ulps, float x) {
    const double unit = std::abs(std::nextafter(float(expected), INFINITY) - float(expected));
    EXPECT_NEAR(found, expected, ulps * unit) << "at " << x;
}

TEST(ScalarMath, IsWithinAnUlpOfDoublePrecision) {
    std::mt19937 bits(1);
    std::uniform_real_distribution<float> number(-30, 30), unit(-1, 1);
    for (int i = 0; i < 20000; ++i) {
        const float x = number(bits), y = number(bits), u = unit(bits);
        expectClose(sin(x), std::sin(double(x)), 1.1, x);
        expectClose(cos(x), std::cos(double(x)), 1.1, x);
        expectClose(tan(x), std::tan(double(x)), 1.1, x);
        expectClose(asin(u), std::asin(double(u)), 1.1, u);
        expectClose(acos(u), std::acos(double(u)), 1.1, u);
        expectClose(atan(x), std::atan(double(x)), 1.1, x);
        expectClose(atan2(y, x), std::atan2(double(y), double(x)), 1.1, x);
        expectClose(exp(x), std::exp(double(x)), 1.1, x);
        expectClose(log(std::fabs(x)), std::log(double(std::fabs(x))), 1.1, x);
        expectClose(pow(std::fabs(x), u), std::pow(double(std::fabs(x)), double(u)), 1.1, x);
    }
}

TEST(ScalarMath, ClampsTheArgumentsOfInverses) {
    EXPECT_EQ(asin(1.5f), asin(1.0f));
    EXPECT_EQ(asin(-INFINITY), asin(-1.0f));
    EXPECT_EQ(acos(2.0f), 0.0f);
    EXPECT_EQ(acos(NAN), acos(-1.0f));
}

TEST(ScalarMath, RaisesNegativeBasesToIntegersOnly) {
    EXPECT_EQ(pow(-2.0f, 3.0f), -8.0f);
    EXPECT_EQ(pow(-2.0f, 0.5f), 0.0f);
    EXPECT_EQ(pow(-2.0f, -1.5f), 0.0f);
    EXPECT_EQ(pow(-1.0f, NAN), 0.0f);
    EXPECT_EQ(pow(0.0f, 0.0f), 1.0f);
}

} // namespace
} // namespace candela::runtime
