// SPDX-License-Identifier: Apache-2.0
#include "tests/filter_library/support/kernels.h"

#include <algorithm>
#include <cmath>

namespace candela::filters {

namespace {

double sinc(double x) {
    const double angle = 3.14159265358979324 * x;
    return x == 0 ? 1 : std::sin(angle) / angle;
}

/// Of half-width 2.
double catmullRom(double t) {
    if (t < 1)
        return 1.5 * t * t * t - 2.5 * t * t + 1;
    return t < 2 ? -.5 * t * t * t + 2.5 * t * t - 4 * t + 2 : 0;
}

} // namespace

double kernelAt(const std::string &name, double distance, double width) {
    if (name == "box") {
        const double left = std::max(distance - .5, -width / 2);
        return std::max(std::min(distance + .5, width / 2) - left, 0.);
    }
    const double x = std::abs(distance) / (width / 2);
    if (x >= 1)
        return 0;
    if (name == "triangle")
        return 1 - x;
    if (name == "gaussian")
        return std::exp(-2 * x * x);
    return name == "lanczos" ? sinc(3 * x) * sinc(x) : catmullRom(2 * x);
}

double usualWidth(const std::string &name) {
    return name == "box" ? 1 : name == "catmull-rom" ? 4 : name == "lanczos" ? 6 : 2;
}

} // namespace candela::filters
