// SPDX-License-Identifier: Apache-2.0
// Derivatives by u and v, forward: beside each value that reaches a Du() or Dv() stand its two
// derivatives, made by the chain rule from those of the renderer's inputs. While the text is being
// lowered, Du() is a placeholder; placeholders are replaced once the whole text stands.
#pragma once

#include "language/ir/lower/components.h"

namespace candela::ir {

inline constexpr int derivativeByU = -1, derivativeByV = -2;
/// Placeholders for the derivatives of the values.
Components derivative(Builder &, const Components &, int direction);
void expandDerivatives(Function &);

} // namespace candela::ir
