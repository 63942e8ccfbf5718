// SPDX-License-Identifier: Apache-2.0
#include "language/ir/lower/strings_at_run_time.h"

#include "language/ir/core/builder_arithmetic.h"
#include "language/ir/core/builder_sources.h"

namespace candela::ir {

StringsAtRunTime::StringsAtRunTime(const sl::TypedShader &shader,
                                   const std::vector<StringValue> &strings) {
    for (const StringValue &given : strings)
        if (given.isLeft())
            left_.insert(given.name);
    if (left_.empty())
        return;
    for (std::string &text : textsOf(shader))
        texts_.insert(std::move(text));
}

Components StringsAtRunTime::read(Builder &b, const StringValue &given) {
    Components result;
    for (size_t k = 0; k < given.value.size(); ++k) {
        if (!given.isLeft(k)) {
            result.push_back(text(b, given.value[k]));
            continue;
        }
        auto &slots = b.function().parameters;
        const int slot = int(slots.size());
        slots.push_back({given.name, int(k)});
        result.push_back(unary(b, Op::StringFromFloat, parameter(b, slot)));
        parameterOf_[result.back()] = given.name;
    }
    return result;
}

bool StringsAtRunTime::need(ValueId string) {
    const auto known = parameterOf_.find(string);
    if (known != parameterOf_.end())
        needed_.insert(known->second);
    else
        needed_.insert(left_.begin(), left_.end()); // Any of them may have been chosen.
    return !left_.empty();
}

bool StringsAtRunTime::differ(Builder &b, ValueId x, ValueId y) {
    const std::string *known = constantText(b, x);
    const ValueId other = known ? y : x;
    known = known ? known : constantText(b, y);
    if (left_.empty() || (known && constantText(b, other)))
        return false;
    if (known && texts_.contains(*known))
        return parameterOf_.contains(other);
    need(other);
    if (!known)
        need(y);
    return false;
}

} // namespace candela::ir
