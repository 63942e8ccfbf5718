// SPDX-License-Identifier: Apache-2.0
// What the light stage works with: one light sample a vertex.
#pragma once

#include "light/vertex/shadow_rays.h"

namespace candela {

struct DirectLight {
    explicit DirectLight(int capacity);

    LightSampleStorage sample;
    ShadowRays shadow;
    Planes<float> unit; ///< Directions of the samples.
    Planes<float> response, contribution;
    Planes<float> floats;
    float *directionPdf, *wanted, *factor, *scattered;
    Planes<std::int32_t> integers;
    std::int32_t *answered;         ///< finiteRequests in all lanes.
    std::int32_t *inShadow, *lanes; ///< Those in need of shadow rays.
};

} // namespace candela
