// SPDX-License-Identifier: Apache-2.0
// How much a light sends into the scene, roughly: what lights are chosen by.
#pragma once

#include "world/scene/scene_state.h"

namespace candela {

/// Mean over 256 quasi-random points and directions, all color samples added up; in W, for
/// classic units what would be W if Cl were E / pi. Never negative or not finite.
double estimatePower(const SceneState &, const SceneLight &);
/// Where a light without geometry stands, as its shader tells points all around; empty if it lights
/// none of them.
Box3 placeOf(const SceneState &, const SceneLight &);

} // namespace candela
