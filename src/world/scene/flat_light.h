// SPDX-License-Identifier: Apache-2.0
// Area lights made of a few flat triangles, as most are: sampled from a table, in vector loops,
// without going through the surfaces.
#pragma once

#include "world/scene/light_table.h"
#include "world/scene/lights.h"

#include <cstdint>

namespace candela {

struct SceneState;

/// The table of a light that can be sampled so; empty if it can't: if it has too many triangles,
/// curved surfaces or normals of the user's, if its surfaces emit besides, or if its shader reads
/// more than position, normal and time.
FlatLight flatLight(const SceneState &, const SceneLight &);

/// As Scene::sampleLights, for points lanes[0..count) (null = 0, 1, ...) that have drawn the light
/// with index `index`; choice[k] is uniform and chooses the triangle. `chosen`: the density
/// counts that lights were chosen by power.
void sampleFlatLight(const SceneState &, int index, const LightQuery &, const std::int32_t *lanes,
                     const float *choice, int count, bool chosen, LightSamples &);

} // namespace candela
