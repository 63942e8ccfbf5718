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

/// (ux,uy,uz) = (x,y,z) / its length.
void unitDirections(int count, const float *x, const float *y, const float *z, float *ux, float *uy,
                    float *uz);
/// What Cl is worth a unit of `value`: L_i / (pi pdf), weighted against the chance of finding
/// the same direction through the mixture; delta lights come as they are. 0 where not wanted.
void lightWeights(int count, const float *lightPdf, const float *mixturePdf,
                  const float *finiteProbability, const float *wanted, float *weight);

/// Rays from some of the vertices to their light samples, packed.
class ShadowRays {
public:
    explicit ShadowRays(int capacity);

    /// Traces from the vertices lanes[0..count) along their L and multiplies what each has in
    /// `light` by what comes through. Returns the number of rays.
    int attenuate(SurfaceVertices &, const LightSamples &, int count, const int *lanes,
                  float *const *light);

private:
    RayBatch rays_;
    Planes<float> planes_; ///< Origins, then what the step at hand needs.
    Planes<float> transmittance_;
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
    Planes<std::int32_t> answered_, lanes_;
};

} // namespace candela
