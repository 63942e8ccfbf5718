// SPDX-License-Identifier: Apache-2.0
#include "language/ir/core/builder.h"
#include "language/ir/core/builder_arithmetic.h"
#include "language/ir/core/builder_control.h"
#include "language/ir/core/builder_effects.h"
#include "language/ir/core/builder_light.h"
#include "language/ir/core/builder_services.h"
#include "language/ir/core/builder_sources.h"
#include "language/ir/core/test_services.h"

#include <gtest/gtest.h>

#include <functional>

namespace candela::ir {
namespace {

/// Holds one of everything that the corruptions below spoil.
Function sample() {
    Function function;
    function.parameters = {{"Kd", 0}};
    Builder b(function);
    ValueId u = input(b, ShaderInput::u);
    auto chosen = ifElse(
        b, less(b, u, parameter(b, 0)), [&] { return Values{mul(b, u, u)}; },
        [&] { return Values{number(b, 2)}; });
    auto counted = loop(b, {boolean(b, true), number(b, 0)}, [&](const Values &carried) {
        ValueId next = add(b, carried[1], number(b, 1));
        return Values{less(b, next, u), next};
    });
    auto lit = lightLoop(b, addRequest(b, {}), input3(b, ShaderInput::P), {}, {chosen[0]},
                         [&](const LoopLight &light, const Values &carried) {
                             return Values{add(b, carried[0], mul(b, light.Cl[0], light.L[2]))};
                         });
    output(b, "Ci", 0, add(b, lit[0], counted[1]));
    query(b, info(Service::option), {"Shutter", "float[2]"}, {}, 3);
    query(b, testObject, {"Sides"}, {}, 2);
    printValues(b, "%f", {u});
    b.finish();
    return function;
}

Instruction &find(Function &function, Op op) {
    for (Instruction &i : function.body.body)
        if (i.op == op)
            return i;
    throw std::logic_error("no such instruction");
}

TEST(Verify, AcceptsWhatTheBuilderMakes) {
    Function function = sample();
    EXPECT_EQ(verify(function), "") << print(function);
}

TEST(Verify, CatchesCorruptions) {
    const std::vector<std::pair<const char *, std::function<void(Function &)>>> corruptions = {
        {"undefined operand", [](Function &f) { find(f, Op::Less).operands[0] = 9999; }},
        {"use before definition",
         [](Function &f) { std::swap(f.body.body.front(), f.body.body.back()); }},
        {"wrong arity", [](Function &f) { find(f, Op::Less).operands.pop_back(); }},
        {"wrong type",
         [](Function &f) { find(f, Op::If).operands[0] = find(f, Op::Add).results[0]; }},
        {"defined twice",
         [](Function &f) { find(f, Op::Add).results[0] = find(f, Op::Input).results[0]; }},
        {"value of a region used outside",
         [](Function &f) {
             find(f, Op::Output).operands[0] = find(f, Op::If).regions[0].body[0].results[0];
         }},
        {"yields missing", [](Function &f) { find(f, Op::Loop).regions[0].yields.pop_back(); }},
        {"arguments missing",
         [](Function &f) { find(f, Op::LightLoop).regions[0].arguments.pop_back(); }},
        {"region missing", [](Function &f) { find(f, Op::If).regions.pop_back(); }},
        {"no such parameter", [](Function &f) { find(f, Op::Parameter).immediate = 5; }},
        {"no such output", [](Function &f) { find(f, Op::Output).immediate = -1; }},
        {"no such request", [](Function &f) { f.requests.clear(); }},
        {"no such service", [](Function &f) { find(f, Op::Query).immediate = 3; }},
        {"a query with effects", [](Function &f) { find(f, Op::Command).op = Op::Query; }},
        {"a command without", [](Function &f) { find(f, Op::Query).op = Op::Command; }},
        {"constant string missing", [](Function &f) { f.services[0].texts.pop_back(); }},
        {"no such constant string", [](Function &f) { f.services[0].texts[1] = 99; }},
        {"a first string of run time that is no operand",
         [](Function &f) { f.services[0].texts[0] = ServiceUse::atRunTime; }},
        {"another number of answers", [](Function &f) { f.services[0].results = 2; }},
        {"operands that nobody takes",
         [](Function &f) { find(f, Op::Query).operands = find(f, Op::Input).results; }},
        {"answers that vary by themselves",
         [](Function &f) {
             for (Instruction &i : f.body.body)
                 if (i.op == Op::Query && i.immediate == 1)
                     f.values[i.results[0]].uniformity = Uniformity::Uniform;
         }},
        {"spill slot out of range", [](Function &f) { find(f, Op::Output).op = Op::FrameStore; }},
        {"uniformity too low",
         [](Function &f) {
             f.values[find(f, Op::Input).results[0]].uniformity = Uniformity::Uniform;
         }},
        {"uniformity of what diverges",
         [](Function &f) {
             f.values[find(f, Op::Loop).results[1]].uniformity = Uniformity::Uniform;
         }},
    };
    for (const auto &[name, corrupt] : corruptions) {
        Function function = sample();
        corrupt(function);
        EXPECT_NE(verify(function), "") << name;
    }
}

TEST(Print, ShowsStructureAndNames) {
    std::string text = print(sample());
    for (const char *part :
         {"LightLoop 0", "Parameter 0 \"Kd\".0", "Input u", "yields", "Output \"Ci\".0", "$f",
          "Query option \"Shutter\" \"float[2]\"", "Command print \"%f\" %f"})
        EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
}

TEST(Builder, FoldsOnlyWhatChangesNoBit) {
    Function function;
    Builder b(function);
    ValueId u = input(b, ShaderInput::u);
    EXPECT_EQ(mul(b, u, number(b, 1)), u);
    EXPECT_EQ(sub(b, u, number(b, 0)), u);
    EXPECT_NE(add(b, u, number(b, 0)), u) << "-0 + 0 is 0";
    EXPECT_NE(number(b, 0), number(b, -0.0f));
    EXPECT_EQ(add(b, number(b, 1), number(b, 2)), number(b, 3));
    EXPECT_EQ(input(b, ShaderInput::u), u);
    EXPECT_EQ(select(b, less(b, number(b, 1), number(b, 2)), u, number(b, 0)), u);
    auto branch = ifElse(
        b, boolean(b, false), [] { return Values{0}; }, [&] { return Values{u}; });
    EXPECT_EQ(branch[0], u);
}

} // namespace
} // namespace candela::ir
