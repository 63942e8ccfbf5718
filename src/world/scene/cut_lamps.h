// SPDX-License-Identifier: Apache-2.0
// Lamps that are parts of solids shine where the solids have surfaces: points are drawn on all of
// their shapes, and those that have been cut away send nothing.
#pragma once

#include "world/scene/scene_state.h"
#include "world/scene/source_points.h"

namespace candela {

/// isThere[i] = 0 where the drawn point i has been cut away, else 1. False if all are there, as
/// without solids: isThere is not filled.
bool findCutAway(const SceneState &, const ElementRows &, const SourcePoints &, const float *time,
                 std::uint8_t *isThere);

/// Lights in classic units are means over what is left of their shapes: finds how much of their
/// area that is.
void measureCutLamps(SceneState &);

} // namespace candela
