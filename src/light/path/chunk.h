// SPDX-License-Identifier: Apache-2.0
// The vertices that stages work on: up to 512 hits on surfaces of one shader, and what each stage
// hands to the next. Planes that one stage alone uses are its own record.
#pragma once

#include "light/path/direct_light.h"
#include "light/path/numbers.h"
#include "light/path/paths.h"
#include "light/sampling/cone_mixture.h"
#include "light/vertex/finite_lobes.h"
#include "light/vertex/scattering_event.h"
#include "light/vertex/surface_vertices.h"

#include <span>

namespace candela {

/// The paths that met the vertices.
struct PathsAtVertices {
    explicit PathsAtVertices(int capacity)
        : throughput(colorSamples, capacity), light(colorSamples, capacity), integers(4, capacity),
          keys(2, capacity) {
        slot = integers[0], depth = integers[1], seen = integers[2], heldOut = integers[3];
        pixelKey = keys[0], sampleIndex = keys[1];
        veil = Planes<float>(colorSamples, capacity), cover = Planes<float>(colorSamples, capacity);
    }
    Planes<float> throughput;
    Planes<float> veil, cover; ///< As PathMedia has them.
    Planes<float> light;       ///< Gathered at this vertex, times throughput.
    Planes<int> integers;
    int *slot, *depth, *seen;
    /// Of what the camera sees and is matte: nothing is to be seen of it. Filled where the scene
    /// has such.
    int *heldOut;
    Planes<std::uint32_t> keys;
    std::uint32_t *pixelKey, *sampleIndex;
};

/// What the emit stage works with; `left` and `origin` are of the rays that met lamps.
struct EmissionPlanes {
    explicit EmissionPlanes(int capacity)
        : left(capacity), origin(3, capacity), met(3, capacity), radiance(colorSamples, capacity),
          lightPdf(1, capacity), weight(1, capacity), heard(1, capacity) {}
    RayOrigins left;
    Planes<float> origin;
    Planes<float> met; ///< Where the rays met the lamps' elements.
    Planes<float> radiance, lightPdf, weight, heard;
};

/// What the scatter stage works with.
struct ScatterPlanes {
    explicit ScatterPlanes(int capacity)
        : sampled(3, capacity), origin(3, capacity), response(colorSamples, capacity),
          throughput(colorSamples, capacity), floats(5, capacity), integers(2, capacity),
          sample(1, capacity) {
        mixturePdf = floats[0], scale = floats[1], pdf = floats[2], brightest = floats[3];
        gain = floats[4];
        survives = integers[0], lane = integers[1];
    }
    Planes<float> sampled, origin, response, throughput, floats;
    float *mixturePdf, *scale, *pdf, *brightest, *gain;
    Planes<int> integers;
    int *survives, *lane;         ///< Of those that go on.
    Planes<std::uint32_t> sample; ///< Numbers before the path splits.
};

struct VertexChunk {
    static constexpr int capacity = 512;
    VertexChunk();

    int count() const { return vertices.count(); }
    /// throughput * contribution joins the light gathered.
    void gather(const std::array<const float *, colorSamples> &contribution);

    int code = 0;              ///< Of the vertices' shader, as Scene numbers it.
    std::span<const int> rays; ///< The vertices' rays in PathWave::active and ::hits, increasing.
    SurfaceVertices vertices;
    PathsAtVertices paths;
    VertexNumbers numbers;
    const float *const *ambient = nullptr; ///< The answer to ambient(); null = black.
    std::array<const float *, colorSamples> ambientTable{};
    const float *const *irradiance = nullptr; ///< The answer to irradiance(); null = black.
    Planes<float> ambientLight;
    ScatteringEvents events;
    ConeMixture mixture; ///< Of the finite lobes; not stated where all their light is given.
    ConstVec3Planes N{}; ///< LightQuery::N.
    Planes<float> normals;
    HemisphereCone hemisphere;
    EmissionPlanes emission;
    DirectLight direct;
    ScatterPlanes way;
};

} // namespace candela
