// SPDX-License-Identifier: Apache-2.0
// Area lights made of a few flat triangles, as most are: sampled from a table, in vector loops,
// without going through the surfaces.
#pragma once

#include "world/scene/light_table.h"
#include "world/scene/lights.h"

namespace candela {

struct SceneState;

/// The table of a light that can be sampled so; empty if it can't: if it has too many triangles,
/// curved surfaces or normals of the user's, if its surfaces emit besides, or if its shader reads
/// more than position, normal and time.
FlatLight flatLight(const SceneState &, const SceneLight &);

/// As Scene::sampleLights, for at most lightBatchSize points that have all drawn the light with
/// index `index`. `chosen`: the density counts that lights were chosen by power.
void sampleFlatLight(const SceneState &, int index, const LightQuery &, bool chosen,
                     LightSamples &);

} // namespace candela
