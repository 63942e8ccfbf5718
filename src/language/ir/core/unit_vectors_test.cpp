// SPDX-License-Identifier: Apache-2.0
#include "language/ir/core/builder_arithmetic.h"
#include "language/ir/core/builder_control.h"
#include "language/ir/core/builder_sources.h"
#include "language/ir/core/builder_vectors.h"

#include <gtest/gtest.h>

namespace candela::ir {
namespace {

struct UnitVectorsOfText : ::testing::Test {
    Function function;
    Builder b{function};
    Triple N = input3(b, ShaderInput::N), I = input3(b, ShaderInput::I),
           Ng = input3(b, ShaderInput::Ng);
    Triple unit = normalize(b, N), other = normalize(b, I);
    ValueId condition = less(b, N[0], I[0]), another = less(b, N[1], I[1]);

    bool staysAsItIs(const Triple &vector) { return normalize(b, vector) == vector; }
};

TEST_F(UnitVectorsOfText, AreNotNormalizedAgain) {
    EXPECT_FALSE(staysAsItIs(N));
    EXPECT_TRUE(staysAsItIs(unit));
    EXPECT_TRUE(staysAsItIs(neg(b, unit)));
    EXPECT_TRUE(staysAsItIs(select(b, condition, unit, other)));
    EXPECT_TRUE(staysAsItIs(faceforward(b, unit, I, Ng)));
    EXPECT_TRUE(staysAsItIs(neg(b, faceforward(b, neg(b, other), I, unit))));
}

TEST_F(UnitVectorsOfText, AreWholeVectors) {
    EXPECT_FALSE(staysAsItIs({unit[1], unit[0], unit[2]}));
    EXPECT_FALSE(staysAsItIs({unit[0], unit[1], other[2]}));
    EXPECT_FALSE(staysAsItIs({neg(b, unit[0]), unit[1], unit[2]}));
    EXPECT_FALSE(staysAsItIs(neg(b, N)));
    EXPECT_FALSE(staysAsItIs(add(b, unit, other)));
    EXPECT_FALSE(staysAsItIs(scale(b, unit, N[0])));
}

TEST_F(UnitVectorsOfText, AreChosenByOneCondition) {
    EXPECT_FALSE(staysAsItIs(select(b, condition, unit, I)));
    EXPECT_FALSE(staysAsItIs(select(b, condition, N, other)));
    Triple mixed = select(b, condition, unit, other);
    mixed[1] = select(b, another, unit[1], other[1]);
    EXPECT_FALSE(staysAsItIs(mixed));
}

/// A choice of choices and so on is one vector: looking it through ends, and soon.
TEST_F(UnitVectorsOfText, AreForgottenWhereTheyAreFarOff) {
    Triple chosen = unit;
    for (int depth = 0; depth < 64; ++depth)
        chosen = select(b, less(b, I[0], number(b, float(depth))), chosen, neg(b, chosen));
    EXPECT_FALSE(staysAsItIs(chosen));
}

} // namespace
} // namespace candela::ir
