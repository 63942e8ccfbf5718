// SPDX-License-Identifier: Apache-2.0
// Light that reaches vertices straight from lights: one sample a vertex, combined with the
// sampling of directions by the power heuristic.
#pragma once

#include "light/transport/cone_mixture.h"
#include "light/transport/scattering_event.h"
#include "light/transport/surface_vertices.h"

namespace candela {

/// A shadow ray stops short of the light by a share of its length, lest it hit the light.
inline constexpr float shadowRayEnd = 1 - 1e-4f;

/// One ray a lane, packed, with the lane it came from.
struct ShadowRays {
    explicit ShadowRays(int capacity)
        : rays(capacity), lane(1, capacity), transmittance(colorSamples, capacity) {
        for (int c = 0; c < colorSamples; ++c)
            transmittancePlanes[c] = transmittance[c];
    }
    /// From vertex i along L, up to the light (tMax in multiples of L).
    void add(SurfaceVertices &, int i, Vec3 L, float tMax);

    RayBatch rays;
    Planes<int> lane;
    Planes<float> transmittance;
    std::array<float *, colorSamples> transmittancePlanes;
};

/// The light samples of a chunk: storage for Scene::sampleLights.
struct LightSampleStorage {
    explicit LightSampleStorage(int capacity);
    Planes<float> floats;
    Planes<std::int32_t> integers;
    Planes<std::uint8_t> bytes;
    LightSamples samples;
};

class DirectLight {
public:
    explicit DirectLight(int capacity);

    /// contribution[c][i] = direct light that vertex i sends to its viewer, for uniform samples
    /// (choice, (u,v)); 0 in lanes where `wanted` is 0. `finiteProbability` is the share of
    /// directions drawn from the mixture. Returns the number of shadow rays traced.
    int gather(SurfaceVertices &, ConeMixture &, const float *finiteProbability,
               const float *wanted, const float *choice, const float *u, const float *v,
               float *const *contribution);

private:
    LightSampleStorage light_;
    ShadowRays shadow_;
    Planes<float> unit_, pdf_, g_;
    Planes<std::int32_t> answered_;
};

} // namespace candela
