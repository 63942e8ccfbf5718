// SPDX-License-Identifier: Apache-2.0
// Where planes are read.
#pragma once

#include "language/ir/core/ir.h"

namespace candela::ir {

/// Moves what is read from planes, which texts name at their head, and the little that is made of
/// nothing else, to where it is first used: a value that is alive across a call to the runtime or
/// a loop costs a store and a load for nothing. Never past an instruction that leaves something
/// behind.
void loadLate(Function &);

} // namespace candela::ir
