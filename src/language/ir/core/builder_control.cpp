// SPDX-License-Identifier: Apache-2.0
#include "language/ir/core/builder_control.h"

#include "language/ir/core/builder_arithmetic.h"
#include "language/ir/core/builder_sources.h"

namespace candela::ir {

Values ifElse(Builder &b, ValueId condition, const std::function<Values()> &then,
              const std::function<Values()> &otherwise) {
    if (auto known = constantBool(b, condition))
        return *known ? then() : otherwise();
    int line = b.line();
    Region yes = b.region({}, then);
    Region no = b.region({}, otherwise);
    bool empty = yes.body.empty() && no.body.empty();
    Values results;
    Instruction instruction{Op::If, {condition}, {}, {}, 0, 0, line};
    Region yesKept{{}, std::move(yes.body), {}}, noKept{{}, std::move(no.body), {}};
    for (std::size_t k = 0; k < yes.yields.size(); ++k) {
        ValueId x = yes.yields[k], y = no.yields[k];
        if (x == y) { // The same value in both: it stands outside.
            results.push_back(x);
        } else if (empty) {
            results.push_back(select(b, condition, x, y));
        } else {
            bool varying = b.uniformity(condition) == Uniformity::Varying ||
                           b.uniformity(x) == Uniformity::Varying ||
                           b.uniformity(y) == Uniformity::Varying;
            results.push_back(
                b.newValue(b.type(x), varying ? Uniformity::Varying : Uniformity::Uniform));
            instruction.results.push_back(results.back());
            b.unitVectors.note(Op::Select, {condition, x, y}, results.back());
            yesKept.yields.push_back(x);
            noKept.yields.push_back(y);
        }
    }
    if (!empty) {
        instruction.regions.push_back(std::move(yesKept));
        instruction.regions.push_back(std::move(noKept));
        b.append(std::move(instruction));
    }
    return results;
}

void ifThen(Builder &b, ValueId condition, const std::function<void()> &then) {
    ifElse(
        b, condition,
        [&] {
            then();
            return Values{};
        },
        [] { return Values{}; });
}

Values loop(Builder &b, const Values &initial, const std::function<Values(const Values &)> &body) {
    if (constantBool(b, initial[0]) == false)
        return initial;
    Instruction instruction{Op::Loop, initial, {}, {}, 0, 0, b.line(), b.file()};
    Values arguments;
    for (ValueId v : initial)
        arguments.push_back(b.newValue(b.type(v), b.uniformity(v)));
    instruction.regions.push_back(b.region(arguments, [&] { return body(arguments); }));
    const Values &yields = instruction.regions[0].yields;
    for (std::size_t k = 0; k < initial.size(); ++k) {
        bool varying = b.uniformity(initial[k]) == Uniformity::Varying ||
                       b.uniformity(yields[k]) == Uniformity::Varying ||
                       b.uniformity(yields[0]) == Uniformity::Varying;
        instruction.results.push_back(
            b.newValue(b.type(initial[k]), varying ? Uniformity::Varying : Uniformity::Uniform));
    }
    Values results = instruction.results;
    b.append(std::move(instruction));
    return results;
}

} // namespace candela::ir
