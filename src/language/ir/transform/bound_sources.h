// SPDX-License-Identifier: Apache-2.0
// Over a box: what the renderer gives.
#pragma once

#include "language/ir/transform/bound_values.h"

namespace candela::ir {

/// May it differ over a box?
bool inputVaries(int plane);
/// Its form; of one that varies.
FormParts inputForm(Builder &, int plane);

} // namespace candela::ir
