// SPDX-License-Identifier: Apache-2.0
#include "foundation/base/hot.h"
#include "foundation/base/lanes.h"
#include "light/path/stages.h"
#include "light/path/steps.h"

#include <algorithm>

namespace candela {

namespace {

CANDELA_HOT void leaveOutOpenLanes(int count, const float *__restrict fullSphere,
                                   const float *__restrict facing, float *__restrict N) {
    for (int i = 0; i < count; ++i)
        N[i] = fullSphere[i] > 0 ? 0.0f : facing[i];
}

} // namespace

void stateLightNormals(VertexChunk &chunk, const ConeMixture &mixture) {
    const int count = chunk.count();
    const ConstVec3Planes facing = chunk.vertices.facingPlanes();
    chunk.N = facing;
    if (lanes::allEqual(count, mixture.fullSphere(), 0))
        return;
    for (int c = 0; c < 3; ++c) {
        leaveOutOpenLanes(count, mixture.fullSphere(), facing[c], chunk.normals[c]);
        chunk.N[c] = chunk.normals[c];
    }
}

void stateLobes(PathWave &wave) {
    VertexChunk &chunk = wave.chunk;
    chunk.events.look(chunk.vertices);
    stateFiniteLobes(chunk.count(), chunk.vertices.prepared().cones, chunk.vertices.facingPlanes(),
                     chunk.events.transmission(),
                     wave.frame.settings.hemisphereOnly ? &chunk.hemisphere : nullptr,
                     chunk.mixture);
    stateLightNormals(chunk, chunk.mixture);
}

} // namespace candela
