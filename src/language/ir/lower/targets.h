// SPDX-License-Identifier: Apache-2.0
// What can be assigned to: variables, elements of arrays, components of values.
#pragma once

#include "language/ir/lower/lowering.h"

#include <optional>

namespace candela::ir {

/// A place to assign to, its indices evaluated.
struct Target {
    Storage storage;
    std::optional<ValueId> element, component; ///< Float indices.
};

Target resolve(Lowering &, const sl::Expr &);
Components load(Lowering &, const Target &, const sl::Place &);
void store(Lowering &, const Target &, const Components &, const sl::Place &);

} // namespace candela::ir
