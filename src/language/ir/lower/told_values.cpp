// SPDX-License-Identifier: Apache-2.0
#include "language/ir/lower/told_values.h"

#include "language/ir/core/builder_arithmetic.h"
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

int numbersTold(const sl::Type &type) {
    return componentCount(type.base, 3) * std::max(1, type.length);
}

void assignTold(BuiltinCall &call, ValueId isThere, const Values &told) {
    const Components value = fromTold(call.b, call.expr.operands[1]->type, told);
    Components now;
    for (size_t k = 0; k < value.size(); ++k)
        now.push_back(select(call.b, isThere, value[k], call.arguments[1][k]));
    call.assign(1, now);
}

} // namespace candela::ir
