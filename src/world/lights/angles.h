// SPDX-License-Identifier: Apache-2.0
// Sine, cosine and arc tangent of doubles, in plain arithmetic that compilers vectorise.
#pragma once

#include <cmath>
#include <numbers>

namespace candela {

/// sin and cos of x in [-pi/4, pi/4]; errors below 1e-15.
[[gnu::always_inline]] inline void sinCosEighth(double x, double &sine, double &cosine) {
    double z = x * x, s = 1, c = 1;
#pragma GCC unroll 8
    for (int k = 8; k > 0; --k) { // Taylor, innermost term first.
        s = 1 - z * s * (1.0 / (2 * k * (2 * k + 1)));
        c = 1 - z * c * (1.0 / (2 * k * (2 * k - 1)));
    }
    sine = x * s, cosine = c;
}

/// sin and cos of x >= 0, a few turns at most; errors below 1e-15.
[[gnu::always_inline]] inline void sinCosOf(double x, double &sine, double &cosine) {
    int quarter = int(x * (2 / std::numbers::pi) + 0.5);
    double s, c;
    sinCosEighth(x - quarter * (std::numbers::pi / 2), s, c);
    double a = quarter & 1 ? c : s, b = quarter & 1 ? s : c;
    sine = quarter & 2 ? -a : a;
    cosine = (quarter + 1) & 2 ? -b : b;
}

/// The angle in [0, pi] of the direction (x, y) with the x axis, for y >= 0; error below 1e-14.
[[gnu::always_inline]] inline double angleOf(double y, double x) {
    double ax = std::fabs(x);
    bool steep = y > ax;
    double low = steep ? ax : y, high = steep ? y : ax;
    // What lies beyond pi/8 is measured from pi/4.
    bool beyond = low > (std::numbers::sqrt2 - 1) * high;
    double t = (beyond ? low - high : low) / (beyond ? low + high : high);
    double z = t * t, sum = 0;
#pragma GCC unroll 18
    for (int k = 17; k >= 0; --k)
        sum = 1.0 / (2 * k + 1) - z * sum;
    double angle = t * sum + (beyond ? std::numbers::pi / 4 : 0);
    angle = steep ? std::numbers::pi / 2 - angle : angle;
    return x < 0 ? std::numbers::pi - angle : angle;
}

} // namespace candela
