// SPDX-License-Identifier: Apache-2.0
// Light sets without the lights that shaders refuse.
#pragma once

#include "world/scene/scene_state.h"

namespace candela {

/// Gives surfaces whose shaders refuse some lights by category light sets of their own, without
/// these: their points do not draw samples of light that no loop would hear. Lights are declared
/// and categories bound.
void leaveOutRefusedLights(SceneState &);

} // namespace candela
