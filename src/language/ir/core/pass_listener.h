// SPDX-License-Identifier: Apache-2.0
// Looking over the compiler's shoulder.
#pragma once

#include "language/ir/core/ir.h"

#include <functional>

namespace candela::ir {

/// Is told of a function as each pass has left it, by the pass's name (docs/compiler.md).
using PassListener = std::function<void(const char *pass, const Function &)>;

} // namespace candela::ir
