// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "language/ir/lower/lower.h"

#include <vector>

namespace candela::ir {

/// Drops what no effect needs, and the parameter slots, planes and spaces that nothing reads.
void removeUnused(Function &, std::vector<ShaderParameter> &);

} // namespace candela::ir
