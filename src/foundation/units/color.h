// SPDX-License-Identifier: Apache-2.0
// Colour as radiometric samples. Nothing outside this room assumes how many there are: loops run
// to `colorSamples`. One RGB unit is 1 W m^-2 sr^-1 (radiance) over the visible band, primaries
// linear Rec.709.
#pragma once

#include <array>

namespace candela {

inline constexpr int colorSamples = 3;

struct Color {
    std::array<float, colorSamples> c{};

    Color() = default;
    explicit Color(float grey) { c.fill(grey); }
    Color(float red, float green, float blue) : c{red, green, blue} {}

    float &operator[](int i) { return c[i]; }
    float operator[](int i) const { return c[i]; }
    friend bool operator==(const Color &, const Color &) = default;
};

/// Weights of the samples in luminance relative to equal-energy white (CIE Y of Rec.709).
inline constexpr std::array<float, colorSamples> luminanceWeights{0.2126f, 0.7152f, 0.0722f};

inline float luminance(const Color &color) {
    float y = 0;
    for (int i = 0; i < colorSamples; ++i)
        y += luminanceWeights[i] * color[i];
    return y;
}

/// Luminous efficacy of the RGB mode in lm/W: the K of photometric().
inline constexpr float luminousEfficacy = 179;

} // namespace candela
