// SPDX-License-Identifier: Apache-2.0
// Lights at infinity that rays meet which escape: solar() over cones, in si units.
#pragma once

namespace candela {

struct SceneState;

/// Gives SceneLight::sky to the lights whose shaders draw their directions as their cones say,
/// alike for all points and times; such a light is asked for a direction by what would have drawn
/// it.
void findSkies(SceneState &);

} // namespace candela
