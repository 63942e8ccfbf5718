// SPDX-License-Identifier: Apache-2.0
#include "world/scene/cone_samples.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace candela {

namespace {
constexpr float pi = std::numbers::pi_v<float>;
}

int sampleCount(float wanted) { return wanted > 1 ? int(std::min(wanted, 4096.0f)) : 1; }

ConeSample coneSample(int turn, float shiftX, float shiftY) {
    const auto fraction = [](double value) {
        return std::min(float(value - std::floor(value)), 0x1.fffffep-1f);
    };
    return {fraction(shiftX + turn * 0.7548776662466927),
            fraction(shiftY + turn * 0.5698402909980532)};
}

Vec3 directionAbout(Vec3 axis, float cosine, float turn) {
    const float sign = axis.z < 0 ? -1.0f : 1.0f, a = -1 / (sign + axis.z), b = axis.x * axis.y * a;
    const Vec3 x{1 + sign * axis.x * axis.x * a, sign * b, -sign * axis.x};
    const Vec3 y{b, sign + axis.y * axis.y * a, -axis.y};
    const float sine = std::sqrt(std::max(0.0f, 1 - cosine * cosine));
    return axis * cosine + x * (sine * std::cos(2 * pi * turn)) +
           y * (sine * std::sin(2 * pi * turn));
}

float cosineInCone(float x, float angle, bool weighted) {
    if (!weighted)
        return 1 - x * (1 - std::cos(angle));
    const float rim = std::sin(std::min(angle, pi / 2));
    return std::sqrt(std::max(0.0f, 1 - x * rim * rim));
}

} // namespace candela
