// SPDX-License-Identifier: Apache-2.0
// The builder's structured control flow.
#include "foundation/units/color.h"
#include "language/ir/builder.h"

#include <optional>

namespace candela::ir {

Builder::Values Builder::ifElse(ValueId condition, const std::function<Values()> &then,
                                const std::function<Values()> &otherwise) {
    if (auto known = constantBool(condition))
        return *known ? then() : otherwise();
    int line = line_;
    Region yes = region({}, then);
    Region no = region({}, otherwise);
    bool empty = yes.body.empty() && no.body.empty();
    Values results;
    Instruction instruction{Op::If, {condition}, {}, {}, 0, 0, line};
    Region yesKept{{}, std::move(yes.body), {}}, noKept{{}, std::move(no.body), {}};
    for (std::size_t k = 0; k < yes.yields.size(); ++k) {
        ValueId a = yes.yields[k], b = no.yields[k];
        if (a == b) { // The same value in both: it stands outside.
            results.push_back(a);
        } else if (empty) {
            results.push_back(select(condition, a, b));
        } else {
            bool varying = rate(condition) == Rate::Varying || rate(a) == Rate::Varying ||
                           rate(b) == Rate::Varying;
            results.push_back(newValue(type(a), varying ? Rate::Varying : Rate::Uniform));
            instruction.results.push_back(results.back());
            yesKept.yields.push_back(a);
            noKept.yields.push_back(b);
        }
    }
    if (!empty) {
        instruction.regions.push_back(std::move(yesKept));
        instruction.regions.push_back(std::move(noKept));
        append(std::move(instruction));
    }
    return results;
}

void Builder::ifThen(ValueId condition, const std::function<void()> &then) {
    ifElse(
        condition,
        [&] {
            then();
            return Values{};
        },
        [] { return Values{}; });
}

Builder::Values Builder::loop(const Values &initial,
                              const std::function<Values(const Values &)> &body) {
    if (constantBool(initial[0]) == false)
        return initial;
    Instruction instruction{Op::Loop, initial, {}, {}, 0, 0, line_};
    Values arguments;
    for (ValueId v : initial)
        arguments.push_back(newValue(type(v), rate(v)));
    instruction.regions.push_back(region(arguments, [&] { return body(arguments); }));
    const Values &yields = instruction.regions[0].yields;
    for (std::size_t k = 0; k < initial.size(); ++k) {
        bool varying = rate(initial[k]) == Rate::Varying || rate(yields[k]) == Rate::Varying ||
                       rate(yields[0]) == Rate::Varying;
        instruction.results.push_back(
            newValue(type(initial[k]), varying ? Rate::Varying : Rate::Uniform));
    }
    Values results = instruction.results;
    append(std::move(instruction));
    return results;
}

Builder::Values Builder::lightLoop(
    int request, const Triple &position, const Values &cones, const Values &initial,
    const std::function<Values(const Triple &, const Values &, const Values &)> &body) {
    Instruction instruction{Op::LightLoop, {position.begin(), position.end()}, {}, {}, request, 0,
                            line_};
    instruction.operands.insert(instruction.operands.end(), cones.begin(), cones.end());
    instruction.operands.insert(instruction.operands.end(), initial.begin(), initial.end());
    Triple L;
    Values Cl, carried, arguments;
    for (ValueId &v : L)
        arguments.push_back(v = newValue(Type::Float, Rate::Varying));
    for (int k = 0; k < colorSamples; ++k) {
        Cl.push_back(newValue(Type::Float, Rate::Varying));
        arguments.push_back(Cl.back());
    }
    for (ValueId v : initial) {
        carried.push_back(newValue(type(v), Rate::Varying));
        arguments.push_back(carried.back());
    }
    instruction.regions.push_back(region(arguments, [&] { return body(L, Cl, carried); }));
    for (ValueId v : initial)
        instruction.results.push_back(newValue(type(v), Rate::Varying));
    Values results = instruction.results;
    append(std::move(instruction));
    return results;
}

Builder::Values Builder::trace(int request, const Triple &position, const Triple &direction) {
    Values operands(position.begin(), position.end());
    operands.insert(operands.end(), direction.begin(), direction.end());
    return emit(Op::Answer, operands, request);
}
Builder::Values Builder::ambient() { return emit(Op::Ambient, {}); }
Builder::Values Builder::irradiance(const Triple &position, const Triple &omega) {
    Values operands(position.begin(), position.end());
    operands.insert(operands.end(), omega.begin(), omega.end());
    return emit(Op::Irradiance, operands);
}

} // namespace candela::ir
