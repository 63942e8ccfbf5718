// SPDX-License-Identifier: Apache-2.0
// Which parameters decide control flow.
#pragma once

#include "language/ir/core/ir.h"

#include <vector>

namespace candela::ir {

/// The parameter slots that decide uniform control flow (branches, trip counts, array indices,
/// delta or finite cones): worth folding, since then lanes need no masks. Strings are always
/// folded, by the lowering.
std::vector<int> controlRelevantParameters(const Function &whole);

} // namespace candela::ir
