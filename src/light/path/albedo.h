// SPDX-License-Identifier: Apache-2.0
// What the first surface makes of light that comes from everywhere alike: the channel "albedo".
#pragma once

#include "light/sampling/cone_mixture.h"
#include "light/vertex/light_samples.h"
#include "light/vertex/scattering_event.h"

#include <array>

namespace candela {

struct PathWave;

/// What seeAlbedo() works with: of its own, so that asking changes no picture.
struct AlbedoPlanes {
    explicit AlbedoPlanes(int capacity);

    ConeMixture mixture;
    ScatteringEvents events;
    LightRows rows; ///< For shaders that take all light at once.
    Planes<std::uint32_t> keys;
    std::uint32_t *pixelKey, *sampleIndex; ///< The address of the directions' numbers.
    Planes<float> numbers, direction, pdf;
    Planes<float> cosineLobe; ///< Its angle, then its exponent and importance.
    Planes<float> response, opacity, darkness;
    Planes<std::int32_t> answered;
    Planes<float> sum; ///< The albedo.
};

/// Of each vertex of the chunk, the share of a uniform field of light that its finite lobes send
/// back, emission left out, in [0,1]; 1 where light only goes on in single directions (mirrors,
/// glass). A surface whose answer follows its cones (ConePlanes::exact) has no noise, others are
/// asked along a few directions a sample. Needs what ask() has stated. The planes stay good until
/// the next call.
std::array<const float *, colorSamples> seeAlbedo(PathWave &);

} // namespace candela
