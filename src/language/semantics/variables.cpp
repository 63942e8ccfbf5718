// SPDX-License-Identifier: Apache-2.0
#include "language/semantics/variables.h"

#include <cmath>

#include "language/semantics/constant_value.h"

namespace candela::sl {

std::optional<int> arrayLength(const ast::Variable &v, Reporter &reporter) {
    if (!v.length) {
        if (v.initialised && v.braced && !v.initial.empty())
            return int(v.initial.size());
        reporter.error(v.where, "array " + v.name + " needs a length or initial values");
        return std::nullopt;
    }
    std::optional<double> length = constantValue(*v.length);
    if (length && *length >= 1 && *length <= arrayLimit && *length == std::floor(*length))
        return int(*length);
    reporter.error(v.length->where, "the length of array " + v.name +
                                        " must be a whole number from 1 to " +
                                        std::to_string(arrayLimit) + ", known at compile time");
    return std::nullopt;
}

Type declaredType(const ast::Variable &v, Detail natural, Reporter &reporter) {
    int length = v.isArray ? arrayLength(v, reporter).value_or(1) : 0;
    return {v.type, v.detail.value_or(natural), length};
}

std::vector<ExprPtr> initialValues(const ast::Variable &v, const Type &type,
                                   ExpressionChecker &expressions, Reporter &reporter) {
    std::vector<ExprPtr> result;
    if (!v.initialised)
        return result;
    if (v.isArray != v.braced)
        reporter.error(v.where, v.isArray
                                    ? "the initial values of array " + v.name + " must stand in { }"
                                    : "only arrays take initial values in { }");
    size_t count = v.initial.size();
    if (v.isArray && count > size_t(type.length)) {
        count = size_t(type.length);
        reporter.warning(v.initial[count]->where,
                         "more initial values than array " + v.name + " has elements (" +
                             std::to_string(type.length) + "): those from here on are left out");
    }
    for (size_t i = 0; i < count; ++i)
        if (ExprPtr value =
                expressions.checkAs(*v.initial[i], v.type, "the initial value of " + v.name))
            result.push_back(std::move(value));
    return result;
}

} // namespace candela::sl
