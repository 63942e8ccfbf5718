// SPDX-License-Identifier: Apache-2.0
// Which operands the infix operators take, and what they make of them.
#pragma once

#include <optional>

#include "language/semantics/conversion.h"

namespace candela::sl {

struct OperatorForm {
    BaseType left, right, result;
    int cost; ///< Against other forms of the operator: by components costs more than scaling.
};

/// The cheapest form for operands of these types in a context that wants a certain type; null if
/// the operator cannot be applied.
const OperatorForm *chooseForm(BinaryOp, const TypeSet &left, const TypeSet &right,
                               std::optional<BaseType> wanted);
/// All types that the operator may result in.
TypeSet resultsOf(BinaryOp, const TypeSet &left, const TypeSet &right);

} // namespace candela::sl
