// SPDX-License-Identifier: Apache-2.0
// Light paths begin: points on lights and directions from them, in batches, and the densities with
// which they are drawn.
#pragma once

#include "foundation/base/planes.h"
#include "foundation/units/color.h"

#include <array>
#include <cstdint>

namespace candela {

/// Uniform numbers in [0,1), one a path: which light, where on it, in which direction.
struct LightStartNumbers {
    const float *choice = nullptr;
    std::array<const float *, 2> position{}, direction{};
};

struct LightStarts {
    explicit LightStarts(int capacity);

    Planes<float> floats;
    Planes<std::int32_t> integers;
    std::int32_t *light; ///< Index + 1; 0 = no path begins.
    /// Where in the scene's tables the place is: for Lights::densityOf().
    std::int32_t *source, *element;
    std::array<float *, 3> origin, direction; ///< Of the ray, off the surface; unit direction.
    std::array<float *, 3> normal;            ///< Of the surface, unit; 0 without one.
    /// Of surfaces the radiance sent, times the cosine, over both densities (W). Of other lights 1
    /// over both: what arrives is asked where it does (Lights::sampleGiven).
    std::array<float *, colorSamples> flux;
    float *positionPdf;  ///< Choice included: per m^2, or without extent a probability.
    float *directionPdf; ///< Per steradian; of distant lights of the place, per m^2.
    float *skyPdf; ///< Of distant lights that rays meet, of the direction, per steradian; else 0.
    std::array<float *, 2> lightSample; ///< What the shader was given as such.
};

/// Densities with which paths would begin, in planes.
struct LightStartDensities {
    float *position, *direction; ///< As LightStarts has them.
};

} // namespace candela
