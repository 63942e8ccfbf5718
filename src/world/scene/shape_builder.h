// SPDX-License-Identifier: Apache-2.0
// Declared primitives and objects become shapes, diced within one budget, and instances.
#pragma once

#include "world/scene/declared_world.h"
#include "world/scene/ray_geometry.h"

namespace candela {

/// Fills SceneState::points, the light sets, the scene's extent and the statistics. Instances and
/// records are let go as soon as they have become what the scene has.
RayGeometry buildShapes(DeclaredWorld &, SceneState &, ShaderLibrary &, DiagnosticSink &);

} // namespace candela
