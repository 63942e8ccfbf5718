// SPDX-License-Identifier: Apache-2.0
// The RI imaging pipeline behind the filter (RI 3.2, 4.1.4): exposure, then quantisation.
#pragma once

#include "interface/ri/options.h"

namespace candela {

/// RiExposure. Negative light, which filters with negative lobes can give, keeps its sign, so that
/// gamma 1 is linear throughout.
float exposed(float value, const ExposureRecord &);

/// The curve of sRGB, from linear light; negative light keeps its sign.
float srgbCurve(float value);

/// Back from it to linear light.
float linearOfSrgb(float value);

/// The color of what covers the pixel, of that of the whole pixel, as PNG wants it ("straight"
/// alpha) and RI does not. Where nothing covers it the color stays, as light without a body.
inline float straightColor(float color, float alpha) {
    return alpha > 0 && alpha < 1 ? color / alpha : color;
}
/// Back from it.
inline float wholeColor(float color, float alpha) {
    return alpha > 0 && alpha < 1 ? color * alpha : color;
}

/// Uniform in [-1, 1): a hash of the pixel and the component, so that a picture does not depend on
/// the order of the work.
float ditherNoise(int x, int y, int component);

/// RiQuantize: round(one * value + ditherAmplitude * noise), clamped to minimum..maximum.
/// With one == 0 the value as it is.
float quantized(float value, const QuantizeRecord &, float noise);

/// What 8-bit file displays use unless told otherwise (RI 3.2, 4.1.4).
inline constexpr QuantizeRecord eightBitQuantize{255, 0, 255, 0.5f};

} // namespace candela
