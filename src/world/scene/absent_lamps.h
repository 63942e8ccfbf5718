// SPDX-License-Identifier: Apache-2.0
// Points are drawn on all of the shapes of lamps, and send nothing where rays would not meet them:
// what solids or clipping planes have cut away, and what is dissolved for the path that asks.
#pragma once

#include "world/scene/scene_state.h"
#include "world/scene/source_points.h"

namespace candela {

/// isThere[i] = 0 where the drawn point i is not met at that time, else 1. False if all are there:
/// isThere need not be filled.
bool findAbsent(const SceneState &, const ElementRows &, const SourcePoints &, const float *time,
                std::uint8_t *isThere);

/// Lights in classic units are means over what is left of their shapes: finds how much of their
/// area that is.
void measureCutLamps(SceneState &);

} // namespace candela
