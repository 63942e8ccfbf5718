// SPDX-License-Identifier: Apache-2.0
// A wave of camera paths whose vertices are connected and merged with those of light paths.
#pragma once

#include "light/bidir/far_media.h"
#include "light/bidir/light_vertices.h"
#include "light/path/wave.h"

namespace candela {

/// What the connect stage works with: a light vertex for each vertex of the chunk.
struct Connections {
    explicit Connections(int capacity);

    Planes<std::uint32_t> bits;
    Planes<std::int32_t> integers;
    std::int32_t *vertex;   ///< Which light vertex; -1 = none.
    std::int32_t *lane;     ///< Those that are connected, by the code of their light vertex.
    std::int32_t *answered; ///< finiteRequests in all lanes.
    Planes<float> floats;
    MutableVec3Planes direction; ///< Unit vector to the light vertex,
    float *distance;             ///< and how far it is.
    float *eyePdf, *eyeReversePdf;
    MutableVec3Planes origin, end; ///< Of the shadow ray.
    Planes<float> response, value;

    // The light vertices of one code.
    SurfaceVertices far;
    RayBatch farRays;
    HitBatch farHits;
    VertexView fromEye, fromLight; ///< How they are seen.
    Planes<float> farFloats, farResponse;
    Planes<std::int32_t> farIntegers;
    RayBatch shadow;
    FarMedia media;
    Planes<float> transmittance;
};

/// What the merge stage works with: pairs of a vertex of the chunk and a light vertex, packed.
struct Merging {
    explicit Merging(int capacity);

    std::vector<std::int32_t> found; ///< Light vertices around one of the chunk's.
    int count = 0;                   ///< Of the pairs.
    Planes<std::int32_t> integers;
    std::int32_t *lane, *row;          ///< Of the chunk and of the light vertices.
    std::int32_t *light, *answered;    ///< What the light vertex has; finiteRequests.
    std::int32_t *unlike, *unlikeLane; ///< Pairs that more techniques find, and lanes of those.
    Planes<float> floats;
    MutableVec3Planes direction; ///< Against the light that has met the light vertex.
    MutableVec3Planes along, toPrevious;
    float *eyePdf, *eyeReversePdf, *reversePdf;
    Planes<float> response, value; ///< Of pairs; of the chunk's vertices.
    ConeMixture mixture;
    bool approached = false;
    VertexView fromLight;
};

struct EyeWave : PathWave {
    EyeWave(FrameContext &, const TechniqueCounts &, const LightVertices &, int connections);

    const LightVertices *lightVertices;
    int connections; ///< Light vertices that each vertex is connected with.
    Connections own;
    Merging merging;
};

/// The stages of such camera paths.
std::span<const Stage> stagesOfEye(const PathWave &, const ShaderCode &);

/// Stage: each vertex with some light vertices, drawn from all of the pass alike.
void connect(PathWave &);
/// Stage: each vertex with all light vertices around it.
void merge(PathWave &);

} // namespace candela
