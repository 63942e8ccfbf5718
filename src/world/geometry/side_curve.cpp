// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/side_curve.h"

namespace candela {

/// A Bernstein function's value, by the shares of the way that are passed and left.
static double bernstein(int degree, int i, double passed, double left) {
    double value = 1;
    for (int k = 1; k <= i; ++k)
        value *= passed * (degree - i + k) / k;
    for (int k = 0; k < degree - i; ++k)
        value *= left;
    return value;
}

/// The same sums whichever end comes first.
static double ordinateAt(const SideCurve &side, int component, double passed, double left) {
    const auto c = [&](int i) { return double(side.ordinates[std::size_t(i)][component]); };
    const int degree = int(side.ordinates.size()) - 1;
    if (degree == 1)
        return c(0) * left + c(1) * passed;
    if (degree == 3)
        return (c(0) * (left * left * left) + c(3) * (passed * passed * passed)) +
               3 * (c(1) * (left * left * passed) + c(2) * (passed * passed * left));
    double sum = 0;
    for (int i = 0; 2 * i < degree; ++i)
        sum += c(i) * bernstein(degree, i, passed, left) +
               c(degree - i) * bernstein(degree, i, left, passed);
    if (degree % 2 == 0) {
        const double middle = bernstein(degree, degree / 2, passed, left);
        sum += c(degree / 2) * ((middle + bernstein(degree, degree / 2, left, passed)) / 2);
    }
    return sum;
}

Vec3 SideCurve::at(int step, int steps) const {
    double passed = double(step) / steps, left = double(steps - step) / steps;
    double place[4];
    for (int c = 0; c < 4; ++c)
        place[c] = ordinateAt(*this, c, passed, left);
    return {float(place[0] / place[3]), float(place[1] / place[3]), float(place[2] / place[3])};
}

} // namespace candela
