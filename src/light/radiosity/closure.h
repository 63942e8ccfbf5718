// SPDX-License-Identifier: Apache-2.0
// No face gets more of a uniform field than all of it. Links that say otherwise are put right as a
// whole: what they get wrong at single nodes is up and down, what they get wrong in all, white
// rooms have ten times.
#pragma once

#include "light/radiosity/fields.h"

#include <vector>

namespace candela::radiosity {

/// By node: what its irradiance is to be multiplied by, the same all over a face. `unit` is what
/// links that nothing stands between bring to nodes where every surface has an exitance of 1. All 1
/// where light passes straight through things.
std::vector<float> closureFactors(const Mesh &, const std::vector<Color> &unit);

} // namespace candela::radiosity
