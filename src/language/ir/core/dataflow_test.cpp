// SPDX-License-Identifier: Apache-2.0
#include "language/ir/core/builder.h"
#include "language/ir/core/builder_arithmetic.h"
#include "language/ir/core/builder_control.h"
#include "language/ir/core/builder_effects.h"
#include "language/ir/core/builder_light.h"
#include "language/ir/core/builder_sources.h"
#include "language/ir/core/dataflow.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace candela::ir {
namespace {

/// Which values Input u may have come to, by whatever way.
struct Reach : ForwardAnalysis<bool> {
    using ForwardAnalysis::ForwardAnalysis;

    bool any(std::span<const ValueId> all) const {
        return std::any_of(all.begin(), all.end(), [&](ValueId v) { return at(v); });
    }
    bool result(const Instruction &i, std::size_t, const Enclosing *) const {
        const bool isU = i.op == Op::Input && i.immediate == int(ShaderInput::u);
        return isU || any(i.operands) || (isArrayAccess(i.op) && arrayOf(i));
    }
    bool array(const Instruction &i, const Enclosing *around) const {
        deepest = std::max(deepest, depth(around));
        return arrayOf(i) || (hasEffect(i.op) && any(i.operands));
    }
    bool flow(const ValueFlow &flow, const Enclosing *) const { return any(flow.from); }
    bool given(const Instruction &, std::size_t) const { return false; }

    static int depth(const Enclosing *around) { return around ? 1 + depth(around->outer) : 0; }
    mutable int deepest = 0;
};

bool reaches(const Function &function) {
    Reach reach(function);
    solve(reach);
    return anyInstruction(
        function.body, [&](const Instruction &i) { return i.op == Op::Output && reach.at(i, 0); });
}

/// A value that needs as many turns of a loop as it has steps: the engine must sweep again.
TEST(Dataflow, FollowsCarriedValuesThroughManyTurns) {
    for (bool throughU : {false, true}) {
        Function function;
        Builder b(function);
        const ValueId x = input(b, throughU ? ShaderInput::u : ShaderInput::v);
        const Values made =
            loop(b, {less(b, x, number(b, 1)), x, number(b, 0), number(b, 0), number(b, 0)},
                 [&](const Values &c) {
                     return Values{c[0], c[1], c[1], c[2], c[3]};
                 });
        output(b, "result", 0, made[4]);
        b.finish();
        EXPECT_EQ(reaches(function), throughU);
    }
}

TEST(Dataflow, FollowsBranchesLightLoopsAndArrays) {
    Function function;
    Builder b(function);
    const ValueId u = input(b, ShaderInput::u);
    const int array = addArray(b, Type::Float, 2);
    const auto lit = lightLoop(b, addRequest(b, {}), input3(b, ShaderInput::P), {}, {number(b, 0)},
                               [&](const LoopLight &, const Values &carried) {
                                   const Values chosen = ifElse(
                                       b, less(b, carried[0], number(b, 1)),
                                       [&] {
                                           arrayStore(b, array, integer(b, 0), u);
                                           return Values{number(b, 1)};
                                       },
                                       [&] { return Values{number(b, 2)}; });
                                   return chosen;
                               });
    output(b, "result", 0, lit[0]);
    b.finish();
    Reach reach(function);
    solve(reach);
    EXPECT_FALSE(reach.at(lit[0]));
    EXPECT_TRUE(reach.arrays[array].fact);
    EXPECT_EQ(reach.deepest, 2);
}

TEST(Regions, FlowsAreThoseOfTheOwner) {
    Function function;
    Builder b(function);
    const ValueId u = input(b, ShaderInput::u);
    const Values counted = loop(b, {boolean(b, true), u}, [&](const Values &c) {
        return Values{less(b, c[1], u), add(b, c[1], u)};
    });
    output(b, "result", 0, counted[1]);
    b.finish();
    int seen = 0;
    forEachInstruction(function.body, [&](const Instruction &i) {
        if (i.op != Op::Loop)
            return;
        forEachFlowIn(i, [&](const ValueFlow &flow) {
            EXPECT_EQ(flow.to, i.regions[0].arguments[flow.index]);
            EXPECT_EQ(flow.from[0], i.operands[flow.index]);
            EXPECT_EQ(flow.from[1], i.regions[0].yields[flow.index]);
            ++seen;
        });
        forEachFlowOut(i, [&](const ValueFlow &flow) {
            EXPECT_EQ(flow.to, i.results[flow.index]);
            EXPECT_EQ(flow.from[0], i.regions[0].arguments[flow.index]);
            ++seen;
        });
        EXPECT_EQ(conditionOf(i), i.regions[0].arguments[0]);
    });
    EXPECT_EQ(seen, 4);
}

} // namespace
} // namespace candela::ir
