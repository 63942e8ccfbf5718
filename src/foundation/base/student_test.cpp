// SPDX-License-Identifier: Apache-2.0
#include "foundation/base/student.h"

#include <gtest/gtest.h>

namespace candela {

// Values of the printed tables of Student's distribution (two-sided).
TEST(Student, AgreesWithTheTables) {
    EXPECT_NEAR(studentQuantile(0.05, 15), 2.1314, 5e-5);
    EXPECT_NEAR(studentQuantile(0.001, 15), 4.0728, 5e-5);
    EXPECT_NEAR(studentQuantile(0.05, 1), 12.7062, 5e-5);
    EXPECT_NEAR(studentQuantile(0.01, 2), 9.9248, 5e-5);
    EXPECT_NEAR(studentQuantile(0.02, 30), 2.4573, 5e-5);
}

TEST(Student, MeanAndErrorOfFourNumbers) {
    MeanAndError result = meanAndError({1, 2, 3, 4});
    EXPECT_DOUBLE_EQ(result.mean, 2.5);
    EXPECT_NEAR(result.standardError, 0.6454972244, 1e-9); // sqrt(5/3) / 2
}

} // namespace candela
