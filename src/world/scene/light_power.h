// SPDX-License-Identifier: Apache-2.0
// How much lights send into the scene, from where and whither, roughly: what they are chosen by.
#pragma once

#include "world/scene/scene_state.h"

namespace candela {

/// Asks all lights, those of one shader together, and fills in SceneLight::power, place, axis,
/// spread and sides. Of many lights each is asked less often.
void estimateLights(SceneState &);

} // namespace candela
