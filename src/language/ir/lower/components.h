// SPDX-License-Identifier: Apache-2.0
// Values of the language as the scalars they consist of.
#pragma once

#include "language/ir/core/builder.h"
#include "language/semantics/typed_ast.h"

namespace candela::ir {

/// The scalar components of a value; an array's elements one after another.
using Components = Values;

/// Scalars in a value of the type, where colours have `samples`.
int componentCount(sl::BaseType, int samples);
inline int componentCount(const Builder &b, sl::BaseType base) {
    return componentCount(base, b.colors().samples);
}
Triple tripleOf(const Components &);
Matrix matrixOf(const Components &);
Components componentsOf(const Triple &);
Components componentsOf(const Matrix &);

/// Zeros or empty strings; of an array if it has a length.
Components zero(Builder &, sl::BaseType, int length = 0);
/// Component `index` (a float, clamped) of a value.
ValueId component(Builder &, const Components &, ValueId index);
Components replaceComponent(Builder &, Components, ValueId index, ValueId value);

} // namespace candela::ir
