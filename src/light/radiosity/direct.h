// SPDX-License-Identifier: Apache-2.0
// The irradiance of light sources at points: what the solution starts from.
#pragma once

#include "light/vertex/shadow_rays.h"

namespace candela::radiosity {

/// Light samples of a batch of points. One a thread.
class DirectQuestion {
public:
    static constexpr int capacity = 512;
    DirectQuestion();

    /// E[c], W m^-2, of all lights that shine on the points, without ambient ones; by so many
    /// samples of each group of lights. `Ng` is the unit normal on the side that is asked about,
    /// `key` addresses the samples: points of one key are sampled alike. Lights of which
    /// leftOut[index] is not 0 do not count.
    void ask(const Scene &, int code, const SurfacePlaces &, const Vec3Planes &Ng,
             const std::uint32_t *key, int samples, std::span<const std::uint8_t> leftOut,
             float *const *E);

private:
    void addSample(LightGroup, float share, std::span<const std::uint8_t> leftOut, float *const *E);

    SurfaceVertices vertices_;
    LightSampleStorage sample_;
    ShadowRays shadow_;
    Planes<float> I_, numbers_, light_;
    Planes<std::int32_t> needed_;
    Planes<std::uint32_t> index_;
};

} // namespace candela::radiosity
