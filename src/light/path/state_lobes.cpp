// SPDX-License-Identifier: Apache-2.0
#include "foundation/base/hot.h"
#include "foundation/base/lanes.h"
#include "light/path/stages.h"
#include "light/path/steps.h"

#include <algorithm>

namespace candela {

namespace {

/// All finite cones of the shader, or under --sampling hemisphere a cosine lobe about the facing
/// normal that is as important as all of them together.
void stateMixture(VertexChunk &chunk, bool hemisphereOnly) {
    const int count = chunk.count();
    SurfaceVertices &vertices = chunk.vertices;
    const ConstVec3Planes facing = vertices.facingPlanes();
    const float *transmits = chunk.events.transmission();
    chunk.mixture.state(count, vertices.prepared().cones, facing, transmits);
    if (!hemisphereOnly)
        return;
    HemisphereCone &cone = chunk.hemisphere;
    std::copy_n(chunk.mixture.total(), count, cone.importance);
    std::fill_n(cone.angle, count, 180.0f);
    std::fill_n(cone.exponent, count, 1.0f);
    chunk.mixture.state(count,
                        {{facing, cone.angle, cone.exponent, cone.importance, cone.angle, 0, true}},
                        facing, transmits);
}

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
    stateMixture(chunk, wave.frame.settings.hemisphereOnly);
    stateLightNormals(chunk, chunk.mixture);
}

} // namespace candela
