// SPDX-License-Identifier: Apache-2.0
#include "language/ir/transform/short_loops.h"

#include "language/ir/core/builder_arithmetic.h"
#include "language/ir/core/builder_control.h"
#include "language/ir/core/builder_effects.h"
#include "language/ir/core/builder_sources.h"

#include <gtest/gtest.h>

namespace candela::ir {
namespace {

/// for (i = from; i < to; i += step), or downwards.
ValueId countTo(Builder &b, float from, ValueId to, float step,
                const std::function<ValueId(ValueId)> &body) {
    return loop(b, {boolean(b, true), number(b, from), number(b, 0)}, [&](const Values &carried) {
        const ValueId sum = add(b, carried[2], body(carried[1]));
        const ValueId next = add(b, carried[1], number(b, step));
        return Values{step > 0 ? less(b, next, to) : less(b, to, next), next, sum};
    })[2];
}

void collect(const Region &region, std::string &marks) {
    for (const Instruction &i : region.body) {
        if (i.op == Op::Loop)
            marks += i.immediate ? 's' : 'c';
        for (const Region &inner : i.regions)
            collect(inner, marks);
    }
}

/// 's' for each loop that is short, 'c' for each that is counted, from outside inwards.
std::string marksOf(const std::function<ValueId(Builder &)> &write) {
    Function function;
    Builder b(function);
    output(b, "x", 0, write(b));
    b.finish();
    markShortLoops(function);
    std::string marks;
    collect(function.body, marks);
    return marks;
}

TEST(ShortLoops, CountFromConstantToConstant) {
    const auto simple = [](float from, float to, float step) {
        return marksOf([=](Builder &b) {
            return countTo(b, from, number(b, to), step, [](ValueId i) { return i; });
        });
    };
    EXPECT_EQ(simple(0, 10, 1), "s");
    EXPECT_EQ(simple(10, 0, -1), "s");
    EXPECT_EQ(simple(0, 1, 0.05f), "s");
    EXPECT_EQ(simple(0, 10000, 1), "c");
    EXPECT_EQ(simple(0, 1, 1e-9f), "c");
    EXPECT_EQ(simple(1e7f, 1e7f + 8, 0.25f), "c"); // Where such steps vanish in rounding.
    EXPECT_EQ(marksOf([](Builder &b) {
                  return countTo(b, 0, parameter(b, 0), 1, [](ValueId i) { return i; });
              }),
              "c");
}

TEST(ShortLoops, MultiplyWhereTheyNest) {
    const auto nested = [](float turns, int depth) {
        return marksOf([=](Builder &b) {
            std::function<ValueId(int)> write = [&](int level) {
                return countTo(b, 0, number(b, turns), 1, [&, level](ValueId i) {
                    return level + 1 == depth ? i : write(level + 1);
                });
            };
            return write(0);
        });
    };
    EXPECT_EQ(nested(3, 2), "ss");
    EXPECT_EQ(nested(3, 3), "ssc"); // 8^3 turns at most, by the bound that is proved.
    EXPECT_EQ(nested(60, 2), "sc");
    EXPECT_EQ(nested(60, 3), "scs"); // Within one that is counted begins another sum.
}

} // namespace
} // namespace candela::ir
