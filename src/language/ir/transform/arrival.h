// SPDX-License-Identifier: Apache-2.0
// What a volume makes of anything at the end of a segment, when it is affine in it.
#pragma once

#include "language/ir/core/ir.h"

namespace candela::ir {

/// Of a volume that proveAffineInArrival() holds of: the function whose outputs Ci and Oi are those
/// of a black and clear end, and CiOfCi, CiOfOi and OiOfOi what they grow by with a unit of Ci or
/// Oi there. Factors are computed for themselves, not as differences, so that they lose no bits
/// beside a bright volume, and need none of the light that the volume scatters.
Function affineParts(const Function &whole);

} // namespace candela::ir
