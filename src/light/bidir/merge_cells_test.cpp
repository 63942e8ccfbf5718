// SPDX-License-Identifier: Apache-2.0
#include "light/bidir/merge_cells.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <random>

namespace candela {
namespace {

std::vector<Vec3> cloud(int count, float size, const Vec3 &centre, unsigned seed) {
    std::mt19937 bits(seed);
    std::uniform_real_distribution<float> along(-size, size);
    std::vector<Vec3> points;
    for (int k = 0; k < count; ++k)
        points.push_back(centre + Vec3{along(bits), along(bits), along(bits)});
    return points;
}

/// Each point within the radius once, and no other, whatever shares a bucket.
TEST(MergeCells, FindWhatIsNearOnce) {
    const float sizes[] = {1e-3f, 1, 1e4f};
    for (float size : sizes)
        for (const Vec3 &centre : {Vec3{}, Vec3{-3 * size, 7 * size, 0}})
            for (float share : {.03f, .4f, 3.0f}) {
                const std::vector<Vec3> points = cloud(500, size, centre, 1);
                const float radius = share * size;
                const MergeCells cells(points, radius);
                std::vector<std::int32_t> found, wanted;
                for (const Vec3 &P : cloud(50, size, centre, 2)) {
                    cells.findNear(P, found);
                    for (std::int32_t &k : found)
                        k = cells.order()[std::size_t(k)];
                    wanted.clear();
                    for (std::size_t k = 0; k < points.size(); ++k)
                        if (dot(points[k] - P, points[k] - P) <= radius * radius)
                            wanted.push_back(std::int32_t(k));
                    std::ranges::sort(found);
                    EXPECT_EQ(found, wanted);
                }
            }
}

TEST(MergeCells, MayBeEmpty) {
    std::vector<std::int32_t> found{7};
    MergeCells().findNear({}, found);
    EXPECT_TRUE(found.empty());
    MergeCells({}, 1).findNear({1, 2, 3}, found);
    EXPECT_TRUE(found.empty());
}

TEST(MergeCells, BearPointsThatAreFarAway) {
    const std::vector<Vec3> points{{1e30f, 0, 0}, {0, 0, 0}};
    std::vector<std::int32_t> found;
    const MergeCells cells(points, 1e-20f);
    cells.findNear({1e30f, 0, 0}, found);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(cells.order()[std::size_t(found[0])], 0);
}

} // namespace
} // namespace candela
