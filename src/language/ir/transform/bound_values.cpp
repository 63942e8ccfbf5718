// SPDX-License-Identifier: Apache-2.0
#include "language/ir/transform/bound_values.h"

#include "language/ir/core/builder_sources.h"

#include <limits>

namespace candela::ir {

FormParts formOf(Builder &b, const BoundedValue &v) {
    if (v.form)
        return *v.form;
    const ValueId none = number(b, 0);
    return {none, none, none, v.middle, v.middle};
}

FormParts unknownForm(Builder &b) {
    const float endless = std::numeric_limits<float>::infinity();
    const ValueId none = number(b, 0), all = number(b, endless);
    return {none, none, all, number(b, -endless), all};
}

FormParts rangeForm(Builder &b, ValueId middle, ValueId least, ValueId greatest) {
    const ValueId none = number(b, 0);
    return {none, none, max(b, sub(b, greatest, middle), sub(b, middle, least)), least, greatest};
}

FormParts callBound(Builder &b, RuntimeFunction function, const std::vector<BoundedValue> &forms,
                    const Values &behind, const Values &before) {
    Values inputs = before;
    for (const BoundedValue &v : forms) {
        const Values parts = formOf(b, v).inOrder();
        inputs.push_back(v.middle);
        inputs.insert(inputs.end(), parts.begin(), parts.end());
    }
    inputs.insert(inputs.end(), behind.begin(), behind.end());
    return FormParts::of(callRuntime(b, int(function), inputs).data());
}

FormParts settle(Builder &b, ValueId middle, const FormParts &form, ValueId computedWith) {
    return callBound(b, RuntimeFunction::bound_settle, {{middle, form}}, {computedWith});
}

FormParts select(Builder &b, ValueId condition, const FormParts &x, const FormParts &y) {
    const auto part = [&](ValueId p, ValueId q) { return select(b, condition, p, q); };
    return {part(x.alongU, y.alongU), part(x.alongV, y.alongV), part(x.off, y.off),
            part(x.least, y.least), part(x.greatest, y.greatest)};
}

ValueId unsureOf(Builder &b, const BoundedValue &v) { return v.unsure.value_or(boolean(b, false)); }

ValueId maybe(Builder &b, const BoundedValue &truth) {
    return truth.unsure ? either(b, truth.middle, *truth.unsure) : truth.middle;
}

namespace {

/// Whether two values that are no floats differ, or may.
ValueId mayDiffer(Builder &b, const BoundedValue &x, const BoundedValue &y) {
    const ValueId unsure = either(b, unsureOf(b, x), unsureOf(b, y));
    if (x.middle == y.middle)
        return unsure;
    if (b.type(x.middle) != Type::Bool) // Integers and strings: who knows.
        return boolean(b, true);
    return either(
        b, unsure,
        either(b, both(b, x.middle, negate(b, y.middle)), both(b, y.middle, negate(b, x.middle))));
}

} // namespace

BoundedValue choice(Builder &b, const BoundedValue &condition, const BoundedValue &x,
                    const BoundedValue &y) {
    BoundedValue result{select(b, condition.middle, x.middle, y.middle)};
    if (b.type(x.middle) != Type::Float) {
        if (x.unsure || y.unsure)
            result.unsure = select(b, condition.middle, unsureOf(b, x), unsureOf(b, y));
        if (condition.unsure)
            result.unsure =
                either(b, unsureOf(b, result), both(b, *condition.unsure, mayDiffer(b, x, y)));
        return result;
    }
    if (x.form || y.form)
        result.form = select(b, condition.middle, formOf(b, x), formOf(b, y));
    if (condition.unsure && (result.form || x.middle != y.middle)) {
        const FormParts either =
            callBound(b, RuntimeFunction::bound_union, {x, y}, {}, {result.middle});
        result.form = select(b, *condition.unsure, either, formOf(b, result));
    }
    return result;
}

ValueId farthest(Builder &b, const BoundedValue &v) {
    const FormParts f = formOf(b, v);
    return max(b, sub(b, f.greatest, v.middle), sub(b, v.middle, f.least));
}

} // namespace candela::ir
