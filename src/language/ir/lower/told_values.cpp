// SPDX-License-Identifier: Apache-2.0
#include "language/ir/lower/told_values.h"

#include "language/ir/core/builder_arithmetic.h"
#include "language/ir/core/builder_sources.h"
#include "language/ir/lower/color.h"

#include <algorithm>

namespace candela::ir {
namespace {

Components fromTold(Builder &b, const sl::Type &type, const Values &told) {
    if (type.base != sl::BaseType::Color)
        return told;
    Components all;
    for (size_t k = 0; k + 2 < told.size(); k += 3) {
        const Components color = colorOf(b, {told[k], told[k + 1], told[k + 2]});
        all.insert(all.end(), color.begin(), color.end());
    }
    return all;
}

} // namespace

Values toldSlots(Builder &b, const std::string &hidden, int numbers) {
    std::vector<ParameterSlot> &slots = b.function().parameters;
    const int first = int(std::ranges::find(slots, hidden, &ParameterSlot::name) - slots.begin());
    if (first == int(slots.size()))
        for (int k = 0; k < numbers; ++k)
            slots.push_back({hidden, k});
    Values told;
    for (int k = 0; k < numbers; ++k)
        told.push_back(parameter(b, first + k));
    return told;
}

int numbersTold(const sl::Type &type) {
    return componentCount(type.base, 3) * std::max(1, type.length);
}

ValueId takeTold(BuiltinCall &call, size_t argument, const Values &told) {
    Builder &b = call.b;
    const ValueId isThere = notEqual(b, told[0], number(b, 0));
    const Components value =
        fromTold(b, call.expr.operands[argument]->type, {told.begin() + 1, told.end()});
    Components now;
    for (size_t k = 0; k < value.size(); ++k)
        now.push_back(select(b, isThere, value[k], call.arguments[argument][k]));
    call.assign(argument, now);
    return told[0];
}

} // namespace candela::ir
