// SPDX-License-Identifier: Apache-2.0
// Declared primitives and objects become shapes, diced within one budget, and instances.
#pragma once

#include "world/scene/declared_world.h"
#include "world/scene/scene_state.h"

namespace candela {

/// What rays are to meet: RayWorld's arguments.
struct RayGeometry {
    RayObject world;
    std::vector<RayObject> objects;
    std::vector<RayInstance> instances;
};

/// Fills SceneState::points, the light sets, the scene's extent and the statistics.
RayGeometry buildShapes(const DeclaredWorld &, SceneState &, ShaderLibrary &, DiagnosticSink &);

} // namespace candela
