// SPDX-License-Identifier: Apache-2.0
// Light for surfaces that are not affine in it: toon shaders and their kin. What such a shader
// sends of many samples is not the sum of what it sends of each, so no path can carry it on;
// instead it is given a stated number of samples at once, and asked for Ci (DESIGN section 3).
#pragma once

#include "light/transport/cone_mixture.h"
#include "light/transport/direct_light.h"
#include "light/transport/surface_vertices.h"

#include <memory>
#include <vector>

namespace candela {

class PathWave;

/// What gathering must know of the paths that met the vertices, lane by lane.
struct GatherQuery {
    const std::uint32_t *pixelKey = nullptr, *sampleIndex = nullptr;
    const int *x = nullptr, *y = nullptr; ///< The pixel, for messages.
    const int *depth = nullptr;
    int maxDepth = 0;                      ///< Vertices this deep get no light.
    int vertex = 0;                        ///< Number of the vertex along its path.
    bool hemisphereOnly = false;           ///< Ignore the shader's cones.
    const float *transmits = nullptr;      ///< As ConeMixture::state() has it.
    const float *const *ambient = nullptr; ///< The answer to ambient(); null = black.
};

class GatheredLight {
public:
    /// Light comes from so many directions, and from lights as many times.
    static constexpr int rounds = 16;

    /// `wave` finds the light that comes along directions; null = light comes straight from
    /// lights alone, as it does to the gathered shaders that gathering meets.
    GatheredLight(int capacity, std::unique_ptr<PathWave> wave);
    ~GatheredLight();

    /// What the vertices send to their viewers of the light gathered, without what they emit by
    /// themselves. Returns the number of shadow rays traced.
    int gather(SurfaceVertices &, const GatherQuery &, float *const *Ci);

private:
    void address(const GatherQuery &, int count);
    void stateMixture(SurfaceVertices &, const GatherQuery &);
    int addLightRow(SurfaceVertices &);
    void addDirectionRow(SurfaceVertices &, const GatherQuery &);
    void shade(SurfaceVertices &, int rows, const float *const *ambient, float *const *Ci);
    void subtractEmission(SurfaceVertices &, float *const *Ci);
    MutableVec3Planes rowL() const;
    std::array<float *, colorSamples> rowCl() const;
    std::int32_t *rowLight() const;

    std::unique_ptr<PathWave> wave_;
    ConeMixture mixture_;
    LightSampleStorage light_;
    ShadowRays shadow_;
    Planes<std::uint32_t> keys_; ///< Of the rounds: pixel key, sample index.
    Planes<float> random_;       ///< Position on the light, direction, choice of light.
    Planes<float> importance_;   ///< Of each cone, and what a cosine lobe states besides.
    Planes<float> weights_;      ///< wanted, always 1, mixture density, weight.
    Planes<float> vectors_;      ///< Unit direction, ray origin.
    Planes<float> black_;        ///< Ci in darkness, Oi.
    Planes<float> rows_;         ///< L and Cl, each a plane of (row, lane).
    Planes<std::int32_t> rowLights_;
    std::vector<int> lanes_; ///< Those that want light.
    std::vector<int> shadowed_;
    int row_ = 0;
};

} // namespace candela
