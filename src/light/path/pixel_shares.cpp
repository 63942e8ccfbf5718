// SPDX-License-Identifier: Apache-2.0
#include "light/path/pixel_shares.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace candela {

/// `place` sends a number in [0,1) to a distance from the pixel's middle.
template <class Place> static FilterCells cellsOf(int cells, Place place) {
    constexpr int probes = 16;
    FilterCells result;
    for (int cell = 0; cell < cells; ++cell) {
        double sum = 0, squares = 0;
        for (int k = 0; k < probes; ++k) {
            const double x = place((float(cell) + (float(k) + 0.5f) / probes) / float(cells));
            sum += x, squares += x * x;
        }
        const double mean = sum / probes, variance = std::max(0.0, squares / probes - mean * mean);
        result.middle.push_back(float(mean));
        // A box of width w has the variance w^2 / 12; the probes' own cells are part of it.
        result.width.push_back(
            float(std::sqrt(12 * variance * probes * probes / (probes * probes - 1.0))));
    }
    return result;
}

void SampleShares::prepare(const PixelFilterSampler &filter, int samples) {
    x_ = y_ = {};
    if (filter.hasNegativeLobes())
        return;
    const int halvings = std::bit_width(unsigned(std::max(1, samples))) - 1;
    x_ = cellsOf(1 << (halvings + 1) / 2,
                 [&](float number) { return filter.sample(number, 0.5f).dx; });
    y_ = cellsOf(1 << halvings / 2, [&](float number) { return filter.sample(0.5f, number).dy; });
}

void SampleShares::set(int i, float xNumber, float yNumber, float dx, float dy) {
    const int column = x_.at(xNumber), row = y_.at(yNumber);
    planes_[0][i] = x_.middle[std::size_t(column)] - dx;
    planes_[1][i] = y_.middle[std::size_t(row)] - dy;
    planes_[2][i] = x_.width[std::size_t(column)];
    planes_[3][i] = y_.width[std::size_t(row)];
}

} // namespace candela
