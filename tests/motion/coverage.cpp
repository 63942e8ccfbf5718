// SPDX-License-Identifier: Apache-2.0
#include "tests/motion/coverage.h"

#include <cmath>
#include <gtest/gtest.h>

namespace candela::test {

namespace {

/// The mean over the pixel and the interval.
double coverageOf(int column, int row, const Covers &covers) {
    constexpr int across = 3, moments = 960;
    int covered = 0;
    for (int moment = 0; moment < moments; ++moment) {
        // The grid wanders, so that edges fall anywhere in its cells.
        const double shiftX = std::fmod(.7548777 * moment, 1);
        const double shiftY = std::fmod(.5698403 * moment, 1);
        for (int i = 0; i < across * across; ++i) {
            const double x = (column + (i % across + shiftX) / across) / 8 - 2;
            const double y = 1 - (row + (i / across + shiftY) / across) / 8;
            covered += covers(x, y, (moment + .5) / moments);
        }
    }
    return double(covered) / (across * across * moments);
}

} // namespace

void expectCoverage(const FramePixels &picture, int samples, const Covers &covers) {
    ASSERT_EQ(picture.red.size(), std::size_t(coverageWidth * coverageHeight));
    double found = 0, expected = 0, variance = 0;
    for (int row = 0; row < coverageHeight; ++row)
        for (int column = 0; column < coverageWidth; ++column) {
            const double wanted = coverageOf(column, row, covers);
            const double seen = picture.red[std::size_t(row * coverageWidth + column)];
            const double own = wanted * (1 - wanted) / samples;
            EXPECT_NEAR(seen, wanted, 5 * std::sqrt(own) + 1.0 / 240 + 1.0 / samples)
                << "at " << column << ' ' << row;
            found += seen, expected += wanted, variance += own;
        }
    EXPECT_GT(expected, 1);
    EXPECT_NEAR(found, expected, 5 * std::sqrt(variance) + .002 * expected);
}

} // namespace candela::test
