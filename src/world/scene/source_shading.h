// SPDX-License-Identifier: Apache-2.0
// Points drawn on lights, as shading points.
#pragma once

#include "world/scene/scene_state.h"
#include "world/scene/source_points.h"

namespace candela {

/// Makes shading points of the drawn points of lanes[0..count) (null: of the first `count`), which
/// all lie on elements. I is the caller's to set, before.
void meetDrawn(const SceneState &, const SurfaceCode &, const SourcePoints &, int count,
               const std::int32_t *lanes, ShadingPoints &);

} // namespace candela
