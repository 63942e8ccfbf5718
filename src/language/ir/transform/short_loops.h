// SPDX-License-Identifier: Apache-2.0
// Which loops end soon, provably: nobody needs to count their turns.
#pragma once

#include "language/ir/core/ir.h"

namespace candela::ir {

/// Sets the immediate of loops that count from a constant to a constant in few turns, those of the
/// marked loops around them included, to 1; of all others to 0.
void markShortLoops(Function &);

} // namespace candela::ir
