// SPDX-License-Identifier: Apache-2.0
// The one place where shadow rays are made and traced.
#pragma once

#include "light/vertex/light_samples.h"

namespace candela {

/// Where a shadow ray ends, as a share of its way: rounding short of the sample. Samples of finite
/// lights end before the zone of the light itself already (LightSamples::L).
inline constexpr float shadowRayEnd = 1 - 4 * 0x1p-23f;

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
    Planes<float> origin_, direction_, end_, factor_, transmittance_;
};

} // namespace candela
