// SPDX-License-Identifier: Apache-2.0
// Light loops that ask for light where they stand, rather than being given the light of one point.
#pragma once

#include "language/ir/core/ir.h"

namespace candela::ir {

/// Makes every LightLoop a Loop over the samples that the services gatherlight and lightsample
/// tell, at the position that the text names: a volume shader may ask at any, and as often as it
/// likes. Samples that a category or the cone of a classic loop refuses are skipped, as by
/// LightLoop.
void askServicesForLight(Function &);

} // namespace candela::ir
