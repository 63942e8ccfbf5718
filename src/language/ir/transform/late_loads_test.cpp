// SPDX-License-Identifier: Apache-2.0
#include "language/ir/transform/late_loads.h"

#include "language/ir/core/builder_arithmetic.h"
#include "language/ir/core/builder_control.h"
#include "language/ir/core/builder_effects.h"
#include "language/ir/core/builder_sources.h"
#include "language/ir/core/op_info.h"

#include <gtest/gtest.h>

namespace candela::ir {
namespace {

/// The names of the operations, in order, constants left out.
std::string operationsOf(const std::function<void(Builder &)> &write) {
    Function function;
    function.parameters.resize(100);
    Builder b(function);
    write(b);
    b.finish();
    loadLate(function);
    EXPECT_EQ(verify(function), "");
    std::string names;
    for (const Instruction &i : function.body.body)
        if (!isConstant(i.op))
            names += (names.empty() ? "" : " ") + std::string(info(i.op).name);
    return names;
}

TEST(LateLoads, StandWhereTheyAreFirstUsed) {
    EXPECT_EQ(operationsOf([](Builder &b) {
                  const ValueId s = input(b, ShaderInput::s), t = input(b, ShaderInput::t);
                  const ValueId sine = unary(b, Op::Sin, t);
                  output(b, "x", 0, add(b, mul(b, sine, s), t));
              }),
              "Input Sin Input Mul Add Output");
}

TEST(LateLoads, ParametersWaitWhereThereAreMany) {
    for (const int count : {64, 65}) {
        const std::string names = operationsOf([&](Builder &b) {
            std::vector<ValueId> parameters;
            for (int slot = 0; slot < count; ++slot)
                parameters.push_back(parameter(b, slot));
            const ValueId sine = unary(b, Op::Sin, input(b, ShaderInput::t));
            output(b, "x", 0, add(b, sine, parameters[0]));
        });
        EXPECT_EQ(names.starts_with("Input Sin"), count > 64) << names;
    }
}

TEST(LateLoads, StandBeforeTheRegionThatUsesThem) {
    EXPECT_EQ(operationsOf([](Builder &b) {
                  const ValueId s = input(b, ShaderInput::s), t = input(b, ShaderInput::t),
                                u = input(b, ShaderInput::u);
                  const ValueId below = less(b, unary(b, Op::Sin, u), number(b, 0));
                  const Values chosen = ifElse(
                      b, below, [&] { return Values{unary(b, Op::Cos, t)}; },
                      [&] { return Values{s}; });
                  output(b, "x", 0, chosen[0]);
              }),
              "Input Sin Less Input Input If Output");
}

TEST(LateLoads, StandBeforeWhatLeavesSomething) {
    EXPECT_EQ(operationsOf([](Builder &b) {
                  const ValueId s = input(b, ShaderInput::s), t = input(b, ShaderInput::t);
                  output(b, "x", 0, number(b, 1));
                  output(b, "y", 0, t);
                  output(b, "z", 0, s);
              }),
              "Input Input Output Output Output");
}

/// The sine stands for all that values should not be alive across.
TEST(LateLoads, TakeAlongWhatIsMadeOfThem) {
    EXPECT_EQ(operationsOf([](Builder &b) {
                  const ValueId product =
                      mul(b, input(b, ShaderInput::s), input(b, ShaderInput::t));
                  const ValueId scaled = mul(b, parameter(b, 0), product);
                  const ValueId sine = unary(b, Op::Sin, input(b, ShaderInput::u));
                  output(b, "x", 0, add(b, scaled, sine));
              }),
              "Parameter Input Sin Input Input Mul Mul Add Output");
}

TEST(LateLoads, LeaveWhereItIsWhatNeedsNoneOrMuch) {
    EXPECT_EQ(operationsOf([](Builder &b) {
                  const ValueId sum = add(b, parameter(b, 0), parameter(b, 1));
                  const ValueId s = input(b, ShaderInput::s), cosine = unary(b, Op::Cos, s);
                  const ValueId twice = add(b, s, s);
                  const ValueId sine = unary(b, Op::Sin, input(b, ShaderInput::u));
                  output(b, "x", 0, add(b, add(b, add(b, sum, cosine), twice), sine));
              }),
              "Parameter Parameter Add Input Cos Add Input Sin Add Add Add Output");
}

TEST(LateLoads, TakeAlongLittle) {
    EXPECT_EQ(operationsOf([](Builder &b) {
                  const ValueId s = input(b, ShaderInput::s);
                  const ValueId fourth = mul(b, mul(b, s, s), mul(b, s, s));
                  const ValueId eighth = mul(b, fourth, fourth);
                  const ValueId sine = unary(b, Op::Sin, input(b, ShaderInput::u));
                  output(b, "x", 0, add(b, eighth, sine));
              }),
              "Input Mul Mul Mul Input Sin Add Output");
}

TEST(LateLoads, KeepWhatNobodyUses) {
    EXPECT_EQ(operationsOf([](Builder &b) { input(b, ShaderInput::s); }), "Input");
}

} // namespace
} // namespace candela::ir
