// SPDX-License-Identifier: Apache-2.0
#include "light/bidir/pixel_choice.h"

#include <cmath>

namespace candela {

template <class Body> double PixelChoice::overPixels(double dx, double dy, Body body) const {
    const int columns = int(std::ceil(filter_.xWidth / 2)),
              rows = int(std::ceil(filter_.yWidth / 2));
    double sum = 0;
    for (int row = -rows; row <= rows; ++row)
        for (int column = -columns; column <= columns; ++column) {
            const double worth = pixelFilterKernel(filter_, dx - column - 0.5, dy - row - 0.5);
            sum += worth;
            body(column, row, worth);
        }
    return sum;
}

/// Over a pixel, the sums over all pixels in reach have the kernel's integral as their mean.
PixelChoice::PixelChoice(const PixelFilterRecord &filter) : filter_(filter) {
    constexpr int steps = 32;
    double sum = 0;
    for (int row = 0; row < steps; ++row)
        for (int column = 0; column < steps; ++column)
            sum += overPixels((column + 0.5) / steps, (row + 0.5) / steps, [](int, int, double) {});
    if (sum != 0)
        perKernel_ = double(steps) * steps / sum;
}

SplatPlace PixelChoice::choose(float x, float y, float number) const {
    const double left = std::floor(double(x)), top = std::floor(double(y));
    const double dx = x - left, dy = y - top;
    double all = 0;
    overPixels(dx, dy, [&](int, int, double worth) { all += std::fabs(worth); });
    if (!(all > 0))
        return {};
    double rest = number * all;
    SplatPlace place;
    overPixels(dx, dy, [&](int column, int row, double worth) {
        if (worth == 0 || rest < 0)
            return;
        rest -= std::fabs(worth);
        place = {float(left + column + 0.5), float(top + row + 0.5),
                 float(std::copysign(all, worth) * perKernel_)};
    });
    return place;
}

} // namespace candela
