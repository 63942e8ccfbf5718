// SPDX-License-Identifier: Apache-2.0
// What is proved of a surface's opacity.
#pragma once

#include "language/ir/core/ir.h"

namespace candela::ir {

/// Of a function that answers Opacity: each Oi is that component of Os, or 1.
bool opaqueIfOsIs1(const Function &opacity);

} // namespace candela::ir
