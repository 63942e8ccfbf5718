// SPDX-License-Identifier: Apache-2.0
// The RI 3.1 way to light a surface: every light at once, and the whole shader run on them. What
// the stages of `classic` work with.
#pragma once

#include "light/vertex/shadow_rays.h"

namespace candela {

struct ClassicLight {
    explicit ClassicLight(int capacity)
        : sample(capacity), shadow(capacity), Ci(colorSamples, capacity),
          Oi(colorSamples, capacity), none(1, capacity), floats(2, capacity),
          integers(2, capacity) {
        wanted = floats[0], factor = floats[1];
        inShadow = integers[0], lanes = integers[1];
    }

    LightSampleStorage sample;
    ShadowRays shadow;
    LightRows rows; ///< A light each.
    Planes<float> Ci, Oi;
    Planes<float> none; ///< Zeros.
    Planes<float> floats;
    float *wanted, *factor;
    Planes<int> integers;
    int *inShadow, *lanes; ///< Those in need of shadow rays.
};

} // namespace candela
