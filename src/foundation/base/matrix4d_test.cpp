// SPDX-License-Identifier: Apache-2.0
#include "foundation/base/matrix4d.h"

#include <gtest/gtest.h>
#include <limits>

namespace candela {

namespace {

void expectIdentity(const Matrix4 &matrix, const std::string &what) {
    constexpr float ulp = std::numeric_limits<float>::epsilon();
    for (int entry = 0; entry < 16; ++entry)
        EXPECT_NEAR(matrix.m[entry], Matrix4{}.m[entry], ulp) << what << ", entry " << entry;
}

} // namespace

TEST(Matrix4d, LongChainsAndTheirInversesMeetAtTheIdentity) {
    for (double distance : {0.0, 1.0, 1e4, 1e7}) {
        Matrix4d there, back;
        for (int i = 1; i <= 1000; ++i) {
            const double angle = 7.3 * i, step = i == 1 ? distance : 0.125 * (i % 3);
            const Vec3 axis{float(i % 5), 1, float(i % 7)};
            there = rotationInDouble(angle, axis) * translationInDouble(step, -step, 1) * there;
            back = back * translationInDouble(-step, step, -1) * rotationInDouble(-angle, axis);
        }
        expectIdentity((there * back).rounded(), "chain at " + std::to_string(distance));
        expectIdentity((there * *inverse(there)).rounded(), "inverse");
    }
}

TEST(Matrix4d, RightAnglesAreExact) {
    for (int quarter = -9; quarter <= 9; ++quarter) {
        const Matrix4d turned = rotationInDouble(90.0 * quarter, {0, 0, 1});
        for (double entry : turned.m)
            EXPECT_TRUE(entry == 0 || entry == 1 || entry == -1) << quarter;
        EXPECT_EQ(turned.at(0, 1), (quarter % 4 + 4) % 4 == 1   ? 1
                                   : (quarter % 4 + 4) % 4 == 3 ? -1
                                                                : 0);
    }
}

TEST(Matrix4d, SingularAndInfiniteMatricesHaveNoInverse) {
    EXPECT_FALSE(inverse(scalingInDouble(1, 0, 1)));
    EXPECT_FALSE(inverse(scalingInDouble(1, std::numeric_limits<double>::infinity(), 1)));
    EXPECT_FALSE(inverse(translationInDouble(0, 0, std::nan(""))));
    EXPECT_TRUE(inverse(scalingInDouble(1e-100, 1, 1)));
    EXPECT_FALSE(inverse(Matrix4(scalingInDouble(1e-40, 1, 1).rounded())));
}

TEST(Matrix4d, SkewTurnsOneAxisTowardsTheOther) {
    const Matrix4d skewed = skewInDouble(45, {0, 1, 0}, {1, 0, 0});
    EXPECT_NEAR(skewed.at(1, 0), 1, 1e-15);
    EXPECT_NEAR(determinant3(skewed), 1, 1e-15);
}

} // namespace candela
