// SPDX-License-Identifier: Apache-2.0
// What a lamp hides of itself, where it casts no shadows.
#pragma once

#include "world/scene/scene_state.h"

namespace candela {

/// Samples of light `index`, if no shadow rays are due for them, become black where shapes of the
/// very same light stand in their way: those on the far walls of a body, and on inner ones. Lamps
/// that are not opaque hide nothing.
void hideBehindItself(const SceneState &, int index, const LightQuery &, LightSamples &);

} // namespace candela
