// SPDX-License-Identifier: Apache-2.0
// The runtime functions as compiled shaders call them: with numbers in registers.
#pragma once

#include "language/runtime/runtime_functions.h"

namespace candela::runtime {

/// Floats in the widest register of a level.
constexpr int registerLanes(IsaLevel level) { return 4 << int(level); }

/// Code for single floats (width 1) or for vectors of registerLanes(), by the platform's calling
/// convention: inputs come in registers, and the first output goes so. Functions of several outputs
/// take a pointer as their last argument, to which they write the others one after another.
/// code() is the same code through memory.
const void *registerCode(RuntimeFunction, int width, IsaLevel);

} // namespace candela::runtime
