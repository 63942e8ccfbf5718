// SPDX-License-Identifier: Apache-2.0
// The one place where shadow rays are made and traced.
#pragma once

#include "light/vertex/light_samples.h"

#include <limits>

namespace candela {

/// Where a shadow ray ends, as a share of its way: rounding short of the sample. Samples of finite
/// lights end before the zone of the light itself already (LightSamples::L).
inline constexpr float shadowRayEnd = 1 - 4 * 0x1p-23f;
/// Distant light (LightSamples::distance) is away from everywhere.
inline float shadowRayEndFor(float distance) {
    return distance == std::numeric_limits<float>::infinity() ? distance : shadowRayEnd;
}

/// Points in volumes, which light is sampled for.
struct FreePoints {
    const Scene &scene;
    int count;
    ConstVec3Planes P;
    const float *time;
    /// What each is in, and the atmosphere there; see ShadowMedia.
    const std::uint32_t *inner, *outer;
    const std::int32_t *atmosphere;
};

/// Rays from some of the vertices to their light samples, packed.
class ShadowRays {
public:
    explicit ShadowRays(int capacity);

    /// Traces from the vertices lanes[0..count) along their L and multiplies what each has in
    /// `light` by what comes through. Returns the number of rays.
    int attenuate(SurfaceVertices &, const LightSamples &, int count, const int *lanes,
                  float *const *light);
    /// The same from points that lie on no surface.
    int attenuate(const FreePoints &, const LightSamples &, int count, const int *lanes,
                  float *const *light);

private:
    /// Takes the rays of those lanes, whose origins, directions and ends are there.
    void take(int count, const int *lanes, const float *time);
    void enter(int ray, MediaAround, const Scene &, const LightSamples &, int i,
               std::int32_t atmosphere);
    void multiply(const Scene &, int all, int count, const int *lanes, bool inMedia,
                  float *const *light);

    RayBatch rays_;
    Planes<float> origin_, direction_, end_, factor_, transmittance_;
    Planes<std::uint32_t> around_;
    Planes<std::int32_t> atmosphere_;
};

} // namespace candela
