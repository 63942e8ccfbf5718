// SPDX-License-Identifier: Apache-2.0
// The choice of sources for points of any light sets, and its probability: the two sides of one
// function.
#pragma once

#include "world/scene/lights.h"
#include "world/scene/scene_state.h"

namespace candela {

/// Among the lights of a group. `u` is uniform in [0,1) before and after; source -1, probability 0:
/// nothing shines there.
void chooseSources(const SceneState &, LightGroup, const LightQuery &, double *u,
                   std::int32_t *source, float *probability);
/// The probability with which source[i] is chosen within its group. Of the query count, P, N,
/// lightSet and scattered are read.
void sourceProbabilities(const SceneState &, const LightQuery &, const std::int32_t *source,
                         float *probability);

} // namespace candela
