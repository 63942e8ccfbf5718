// SPDX-License-Identifier: Apache-2.0
// What is known of a value over a box, as values of the function that is being written: the forms
// of runtime/bound_level.h.
#pragma once

#include "language/ir/core/builder_arithmetic.h"
#include "language/runtime/runtime_functions.h"

#include <array>
#include <optional>

namespace candela::ir {

using runtime::RuntimeFunction;

/// What stands beside a float in the middle of the box.
struct FormParts {
    ValueId alongU, alongV, off, least, greatest;

    static constexpr int count = 5;
    Values inOrder() const { return {alongU, alongV, off, least, greatest}; }
    static FormParts of(const ValueId *five) {
        return {five[0], five[1], five[2], five[3], five[4]};
    }
};

struct BoundedValue {
    ValueId middle = 0; ///< The value in the middle of the box: the one that the shader computes.
    /// Of floats; none: it is the same all over the box.
    std::optional<FormParts> form{};
    /// Of bools, integers and strings: a bool, whether it may be another elsewhere in the box;
    /// none: it may not.
    std::optional<ValueId> unsure{};

    bool varies() const { return form || unsure; }
};

/// A float's form, also of one that is the same all over.
FormParts formOf(Builder &, const BoundedValue &);
/// No bound is known.
FormParts unknownForm(Builder &);
/// A float of that value in the middle that lies in a range and may jump there.
FormParts rangeForm(Builder &, ValueId middle, ValueId least, ValueId greatest);
/// A row of runtime/functions.def about bounds: of forms, with further numbers before or behind.
FormParts callBound(Builder &, RuntimeFunction, const std::vector<BoundedValue> &,
                    const Values &behind = {}, const Values &before = {});
/// The form, after rounding of numbers of that size; its plane and its range cut by each other.
FormParts settle(Builder &, ValueId middle, const FormParts &, ValueId computedWith);
/// Parts of two forms, by a condition that is the same all over the box.
FormParts select(Builder &, ValueId condition, const FormParts &, const FormParts &);
/// True where it is, or may be elsewhere in the box.
ValueId maybe(Builder &, const BoundedValue &truth);
ValueId unsureOf(Builder &, const BoundedValue &);
/// `condition` ? x : y. Where the condition is not the same all over, both are in the result.
BoundedValue choice(Builder &, const BoundedValue &condition, const BoundedValue &x,
                    const BoundedValue &y);

inline ValueId size(Builder &b, ValueId x) { return unary(b, Op::Abs, x); }
/// How far a form's value may be from that in the middle.
ValueId farthest(Builder &, const BoundedValue &);

} // namespace candela::ir
