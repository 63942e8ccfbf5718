// SPDX-License-Identifier: Apache-2.0
#include "language/ir/core/evaluate.h"
#include "language/ir/core/op_info.h"
#include "language/runtime/runtime_functions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace candela::ir {
namespace {

std::vector<Op> allOperations() {
    std::vector<Op> all;
    for (int op = 0; op < opCount; ++op)
        all.push_back(Op(op));
    return all;
}

TEST(OpInfo, ArithmeticHasAValue) {
    for (Op op : allOperations())
        EXPECT_EQ(std::isnan(evaluateFloat(op, 0.5f, 0.25f)), !isFloatArithmetic(op))
            << info(op).name;
}

TEST(OpInfo, RangesOfMonotoneOperationsEndAtTheirOperandsEnds) {
    for (Op op : allOperations()) {
        const BoundRule rule = info(op).bound;
        if (!isFloatArithmetic(op) ||
            (rule != BoundRule::Increasing && rule != BoundRule::Decreasing))
            continue;
        ASSERT_EQ(info(op).operands, "f") << info(op).name;
        const float sign = rule == BoundRule::Increasing ? 1 : -1;
        for (int k = 0; k < 64; ++k) { // Above 0, for the logarithm.
            const float x = float(k + 1) / 32, y = x + 1.0f / 32;
            EXPECT_LE(sign * evaluateFloat(op, x, 0), sign * evaluateFloat(op, y, 0))
                << info(op).name << " " << x;
        }
    }
}

/// The slope of a step is 0 between its jumps; that of a smooth operation is not everywhere.
TEST(OpInfo, OnlyStepsHaveNoSlope) {
    for (Op op : allOperations()) {
        if (!isFloatArithmetic(op))
            continue;
        const float before = evaluateFloat(op, 0.3f, 0.7f), after = evaluateFloat(op, 0.31f, 0.73f);
        EXPECT_EQ(before == after, info(op).slope == SlopeRule::Step) << info(op).name;
    }
}

TEST(OpInfo, FactsAgreeWithEachOther) {
    for (Op op : allOperations()) {
        const OpInfo &i = info(op);
        EXPECT_EQ(i.regions > 0, i.kind == OpClass::Control) << i.name;
        EXPECT_EQ(i.kind == OpClass::Control, i.purity == Purity::Regions) << i.name;
        if (op != Op::PixelLoop) { // It sets maps, and sums.
            EXPECT_EQ(i.results.empty(), i.purity == Purity::Effect) << i.name;
        }
        if (i.speculation == Speculation::Always) {
            EXPECT_TRUE(i.purity == Purity::Pure && i.cost <= 1) << i.name;
        }
        if (i.purity == Purity::Effect) {
            EXPECT_EQ(i.speculation, Speculation::Never) << i.name;
        }
        if (i.results == "b" || i.results == "s") {
            EXPECT_TRUE(i.slope == SlopeRule::None || i.slope == SlopeRule::Step) << i.name;
        }
        if (i.kind == OpClass::Constant) {
            EXPECT_EQ(i.uniformity, ResultUniformity::Uniform) << i.name;
        }
    }
}

TEST(OpInfo, CallsArePureAsAllRuntimeFunctionsAre) {
    ASSERT_TRUE(isPure(Op::Call));
    for (int f = 0; f < int(runtime::RuntimeFunction::Count); ++f) {
        const auto &known = runtime::info(runtime::RuntimeFunction(f));
        EXPECT_EQ(known.purity, runtime::RuntimePurity::Pure) << known.name;
        EXPECT_GT(known.cost, 1) << known.name;
        Instruction call{Op::Call, {}, {}, {}, f};
        EXPECT_EQ(costOf(Function(), call), known.cost);
    }
}

TEST(OpInfo, FunctionsWithSlopesGiveOneForEachValueAndCoordinate) {
    for (int f = 0; f < int(runtime::RuntimeFunction::Count); ++f) {
        const auto &known = runtime::info(runtime::RuntimeFunction(f));
        if (known.slopes == runtime::RuntimeFunction::NoSlopes)
            continue;
        const auto &slopes = runtime::info(known.slopes);
        EXPECT_EQ(slopes.inputs, known.inputs) << known.name;
        EXPECT_EQ(slopes.coordinates, known.coordinates) << known.name;
        EXPECT_EQ(slopes.outputs, known.outputs * (1 + known.coordinates)) << known.name;
    }
}

} // namespace
} // namespace candela::ir
