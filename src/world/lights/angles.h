// SPDX-License-Identifier: Apache-2.0
// Sine, cosine and arc tangent, in plain arithmetic that compilers vectorise.
#pragma once

#include <cmath>
#include <numbers>

namespace candela {

/// sin and cos of x in [-pi/4, pi/4]; errors below 1e-15, of floats below 1e-7.
template <class Real>
[[gnu::always_inline]] inline void sinCosEighth(Real x, Real &sine, Real &cosine) {
    constexpr int terms = sizeof(Real) == sizeof(float) ? 4 : 8;
    Real z = x * x, s = 1, c = 1;
#pragma GCC unroll 8
    for (int k = terms; k > 0; --k) { // Taylor, innermost term first.
        s = 1 - z * s * Real(1.0 / (2 * k * (2 * k + 1)));
        c = 1 - z * c * Real(1.0 / (2 * k * (2 * k - 1)));
    }
    sine = x * s, cosine = c;
}

/// sin and cos of x >= 0, a few turns at most; errors below 2e-7.
[[gnu::always_inline]] inline void sinCosOf(float x, float &sine, float &cosine) {
    constexpr double halfPi = std::numbers::pi / 2;
    // Quarters of a turn are taken off in two steps: the first is exact.
    constexpr float coarse = 0x1.92p+0f, fine = float(halfPi - coarse);
    const int quarter = int(x * float(1 / halfPi) + 0.5f);
    float s, c;
    sinCosEighth(x - float(quarter) * coarse - float(quarter) * fine, s, c);
    const float a = quarter & 1 ? c : s, b = quarter & 1 ? s : c;
    sine = quarter & 2 ? -a : a;
    cosine = (quarter + 1) & 2 ? -b : b;
}

/// The angle in [0, pi] of the direction (x, y) with the x axis, for y >= 0; error below 3e-7, and
/// as a share of small angles, too.
[[gnu::always_inline]] inline float angleOf(float y, float x) {
    constexpr float pi = std::numbers::pi_v<float>;
    const float ax = std::fabs(x);
    const bool steep = y > ax;
    const float low = steep ? ax : y, high = steep ? y : ax;
    // What lies beyond pi/8 is measured from pi/4.
    const bool beyond = low > (std::numbers::sqrt2_v<float> - 1) * high;
    const float t = (beyond ? low - high : low) / (beyond ? low + high : high);
    float z = t * t, sum = 0;
#pragma GCC unroll 8
    for (int k = 7; k >= 0; --k)
        sum = float(1.0 / (2 * k + 1)) - z * sum;
    float angle = t * sum + (beyond ? pi / 4 : 0);
    angle = steep ? pi / 2 - angle : angle;
    return x < 0 ? pi - angle : angle;
}

} // namespace candela
