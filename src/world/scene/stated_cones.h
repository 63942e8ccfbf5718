// SPDX-License-Identifier: Apache-2.0
// The cones into which a light shader says that it shines (paper 5.4), asked for the light as such.
#pragma once

#include "world/lights/emission_lobes.h"
#include "world/scene/light_sources.h"

#include <optional>
#include <vector>

namespace candela {

struct SceneState;

struct StatedCones {
    Vec3 place; ///< Of all cones; of solar() the origin.
    std::vector<EmissionCone> cones;
};

/// When the shutter opens. Nothing if the shader states none, or others to other points, or from
/// several places.
std::optional<StatedCones> statedCones(const SceneState &, const SceneLight &);

} // namespace candela
