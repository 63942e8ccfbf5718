// SPDX-License-Identifier: Apache-2.0
// What the samples of a colour stand for, in terms of linear Rec.709 (RI 3.2, ColorSamples).
#pragma once

#include "foundation/units/color.h"

#include <array>
#include <vector>

namespace candela {

/// The most samples that a colour can have: as many planes are reserved in shaders' inputs.
inline constexpr int maximumColorSamples = 8;

struct ColorBasis {
    int samples = colorSamples;
    /// The samples are red, green and blue themselves; both tables are empty then.
    bool isRgb() const { return samplesFromRgb.empty(); }
    /// By sample: the weights of red, green and blue in it (the uplift; RI's RGBn).
    std::vector<std::array<float, 3>> samplesFromRgb;
    /// For red, green and blue: the weight of each sample in it (RI's nRGB).
    std::array<std::vector<float>, 3> rgbFromSamples;

    /// Of each sample in luminance, relative to equal-energy white.
    std::vector<float> luminance() const;
};

/// Samples from blue to red at even steps, each between its neighbours among the primaries; white
/// is 1 in all of them, and colours made of RGB come back as they were. One sample is luminance.
/// `samples` is 1, or 3 to maximumColorSamples; 3 are RGB.
ColorBasis evenBasis(int samples);

} // namespace candela
