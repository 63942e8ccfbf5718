// SPDX-License-Identifier: Apache-2.0
// How a light falls off.
#pragma once

#include "language/ir/core/builder.h"

#include <optional>

namespace candela::ir {

/// The power of |L| that output Cl is proportional to if only the distance changes, the direction
/// of L kept; nothing if that cannot be proved.
std::optional<float> powerOfDistance(const Function &, const Triple &L);

} // namespace candela::ir
