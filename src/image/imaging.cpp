// SPDX-License-Identifier: Apache-2.0
#include "image/imaging.h"

#include "foundation/base/hash.h"

#include <algorithm>
#include <cmath>

namespace candela {

float exposed(float value, const ExposureRecord &exposure) {
    const float light = value * exposure.gain;
    return exposure.gamma == 1
               ? light
               : std::copysign(std::pow(std::abs(light), 1 / exposure.gamma), light);
}

float srgbCurve(float value) {
    const float light = std::abs(value);
    const float curved =
        light <= 0.0031308f ? 12.92f * light : 1.055f * std::pow(light, 1 / 2.4f) - 0.055f;
    return std::copysign(curved, value);
}

float linearOfSrgb(float value) {
    const float size = std::abs(value);
    const float light =
        size <= 12.92f * .0031308f ? size / 12.92f : std::pow((size + .055f) / 1.055f, 2.4f);
    return std::copysign(light, value);
}

float ditherNoise(int x, int y, int component) {
    const std::uint64_t pixel = std::uint64_t(std::uint32_t(y)) << 32 | std::uint32_t(x);
    const std::uint64_t bits = mixBits(mixBits(pixel) + std::uint64_t(component) + 1);
    return float(bits >> 40) * 0x1p-23f - 1;
}

float quantized(float value, const QuantizeRecord &quantize, float noise) {
    if (quantize.one == 0)
        return value;
    const float scaled = quantize.zero + (quantize.one - quantize.zero) * value;
    const float level = std::floor(scaled + quantize.ditherAmplitude * noise + 0.5f);
    return std::min(std::max(level, quantize.minimum), quantize.maximum);
}

} // namespace candela
