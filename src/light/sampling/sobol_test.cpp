// SPDX-License-Identifier: Apache-2.0
#include "light/sampling/sobol.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numeric>
#include <set>
#include <vector>

namespace candela {
namespace {

struct Points {
    std::vector<float> x, y;
};

Points pointsOf(int count, std::uint32_t key, std::uint32_t pair, int first = 0,
                decltype(&sobolPairs) draw = sobolPairs) {
    std::vector<std::uint32_t> keys(count, key), samples(count);
    std::iota(samples.begin(), samples.end(), first);
    Points points{std::vector<float>(count), std::vector<float>(count)};
    draw(count, keys.data(), samples.data(), pair, points.x.data(), points.y.data());
    return points;
}

TEST(Sobol, everyElementaryBoxOf64SamplesHoldsOne) {
    for (std::uint32_t key = 1; key < 40; ++key)
        for (int block = 0; block < 3; ++block) {
            Points p = pointsOf(64, pixelKey(key, 3, 7), key % 5, 64 * block);
            for (int logX = 0; logX <= 6; ++logX) {
                std::set<int> boxes;
                for (int i = 0; i < 64; ++i)
                    boxes.insert(int(p.x[i] * (1 << logX)) << 8 | int(p.y[i] * (64 >> logX)));
                EXPECT_EQ(boxes.size(), 64u) << "key " << key << " logX " << logX;
            }
        }
}

/// The first four dimensions have quality parameter t = 3: of 64 points, every elementary box of
/// an eighth of the volume holds eight. Two independent pairs do not have that.
TEST(Sobol, followingPairsAreStratifiedTogether) {
    for (std::uint32_t key = 1; key < 40; ++key) {
        Points first = pointsOf(64, pixelKey(key, 3, 7), 1);
        Points next = pointsOf(64, pixelKey(key, 3, 7), 1, 0, sobolFollowingPairs);
        const std::vector<float> *axes[4] = {&first.x, &first.y, &next.x, &next.y};
        for (int left = 0; left < 4; ++left) {
            std::vector<int> octants(8);
            for (int i = 0; i < 64; ++i) {
                int octant = 0;
                for (int axis = 0; axis < 4; ++axis)
                    if (axis != left)
                        octant = 2 * octant + ((*axes[axis])[i] >= 0.5f);
                ++octants[octant];
            }
            EXPECT_EQ(octants, std::vector<int>(8, 8)) << "key " << key << " without " << left;
        }
        for (const std::vector<float> &axis : {next.x, next.y}) {
            std::set<int> cells;
            for (float value : axis)
                cells.insert(int(value * 64));
            EXPECT_EQ(cells.size(), 64u);
        }
    }
}

TEST(Sobol, followingPairsDoNotRepeat) {
    Points first = pointsOf(64, pixelKey(5, 3, 7), 1, 0, sobolFollowingPairs);
    Points later = pointsOf(64, pixelKey(5, 3, 7), 1, 1 << 16, sobolFollowingPairs);
    std::set<float> x(first.x.begin(), first.x.end()), y(first.y.begin(), first.y.end());
    int common = 0;
    for (int i = 0; i < 64; ++i)
        common += int(x.count(later.x[i]) + y.count(later.y[i]));
    EXPECT_EQ(common, 0);
}

TEST(Sobol, valuesAreUniformOverPixels) {
    // Owen scrambling: each single point is uniform over keys. Chi-square over 16 x 16 cells;
    // 255 degrees of freedom, 1e-4 quantile 345.
    std::vector<int> cells(256);
    const int n = 64000;
    for (int key = 0; key < n; ++key) {
        Points p = pointsOf(1, pixelKey(key % 320, key / 320, 1), 2, 5);
        ++cells[int(p.x[0] * 16) * 16 + int(p.y[0] * 16)];
    }
    double chiSquare = 0;
    for (int c : cells)
        chiSquare += (c - n / 256.0) * (c - n / 256.0) / (n / 256.0);
    EXPECT_LT(chiSquare, 345);
}

TEST(Sobol, pairsAreUncorrelated) {
    double sum = 0;
    const int n = 20000;
    for (int key = 0; key < n; ++key) {
        Points a = pointsOf(1, pixelKey(key, 0, 1), 0, 3),
               b = pointsOf(1, pixelKey(key, 0, 1), 1, 3);
        sum += (a.x[0] - 0.5) * (b.x[0] - 0.5);
    }
    EXPECT_LT(std::fabs(sum / n), 4 / 12.0 / std::sqrt(n));
}

TEST(Sobol, integratesBetterThanRandomNumbers) {
    // The disc indicator over 256 samples: independent numbers have variance pi/4(1-pi/4)/256.
    double squared = 0;
    for (int key = 0; key < 400; ++key) {
        Points p = pointsOf(256, pixelKey(key, 9, 1), 1);
        int inside = 0;
        for (int i = 0; i < 256; ++i)
            inside += p.x[i] * p.x[i] + p.y[i] * p.y[i] < 1;
        squared += std::pow(inside / 256.0 - M_PI / 4, 2);
    }
    EXPECT_LT(squared / 400, 0.25 * (M_PI / 4) * (1 - M_PI / 4) / 256);
}

} // namespace
} // namespace candela
