// SPDX-License-Identifier: Apache-2.0
// A wave of camera paths whose vertices are connected with those of light paths.
#pragma once

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
    Planes<float> transmittance;
};

struct EyeWave : PathWave {
    EyeWave(FrameContext &, const TechniqueCounts &, const LightVertices &, int connections);

    const LightVertices &lightVertices;
    int connections; ///< Light vertices that each vertex is connected with.
    Connections own;
};

/// The stages of such camera paths.
std::span<const Stage> stagesOfEye(const PathWave &, const ShaderCode &);

/// Stage: each vertex with some light vertices, drawn from all of the pass alike.
void connect(PathWave &);

} // namespace candela
