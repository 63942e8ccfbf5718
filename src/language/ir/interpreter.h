// SPDX-License-Identifier: Apache-2.0
// The oracle: runs an IR function lane by lane on the very arguments that compiled code takes.
// Slow and plain; code generation tests compare every lane with it.
#pragma once

#include "language/ir/ir.h"
#include "language/runtime/shader_abi.h"

namespace candela::ir {

void interpret(const Function &, const ShaderArgs &);

} // namespace candela::ir
