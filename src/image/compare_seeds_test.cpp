// SPDX-License-Identifier: Apache-2.0
#include "image/compare_seeds.h"
#include "image/difference_picture.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace candela {

namespace {

const FrameWindow window{40, 30, 4, 36, 6, 30}; // 32 x 24 pixels.

/// Noise about 1 of this spread; a square of 8 x 8 pixels from (20, 14) on is `brighter`.
Picture noisy(std::mt19937 &random, double spread, double brighter = 0) {
    Picture picture;
    picture.window = window;
    std::normal_distribution<double> noise(1, spread);
    std::vector<float> values;
    for (int y = window.y0; y < window.y1; ++y)
        for (int x = window.x0; x < window.x1; ++x) {
            const bool inside = x >= 20 && x < 28 && y >= 14 && y < 22;
            values.push_back(float(noise(random) + (inside ? brighter : 0)));
        }
    for (const char *name : {"R", "G", "B"})
        picture.channels.push_back({name, values});
    return picture;
}

std::vector<Picture> several(int count, std::mt19937 &random, double spread, double brighter = 0) {
    std::vector<Picture> pictures;
    for (int k = 0; k < count; ++k)
        pictures.push_back(noisy(random, spread, brighter));
    return pictures;
}

} // namespace

TEST(CompareSeeds, WhatIsTheSameIsFoundSo) {
    std::mt19937 random(7);
    int different = 0;
    double squares = 0;
    constexpr int trials = 100;
    for (int trial = 0; trial < trials; ++trial) {
        // Unequal noise, unequal numbers.
        const SeedComparison c =
            compareSeeds(several(4, random, .1), several(3, random, .5), {8, {}});
        ASSERT_EQ(c.problem, "");
        ASSERT_EQ(c.channels.size(), 1u);
        EXPECT_EQ(c.channels[0].regions.size(), 12u);
        different += exitCodeOf(c);
        squares += c.channels[0].meanSquareZ / trials;
    }
    EXPECT_LE(different, 2); // At a level of 1e-3.
    EXPECT_NEAR(squares, 1, .25);
}

TEST(CompareSeeds, ADifferenceIsFoundWhereItIs) {
    std::mt19937 random(8);
    const SeedComparison c =
        compareSeeds(several(8, random, .1, .2), several(8, random, .1), {8, {}});
    ASSERT_EQ(c.problem, "");
    EXPECT_EQ(exitCodeOf(c), 1);
    const ChannelScores &scores = c.channels[0];
    const RegionScore &worst = scores.regions[std::size_t(scores.worst)];
    EXPECT_EQ(worst.x0, 20);
    EXPECT_EQ(worst.y0, 14);
    EXPECT_EQ(worst.x1, 28);
    EXPECT_NEAR(worst.meanA - worst.meanB, .2, .03);
    EXPECT_GT(worst.z, 4);
    EXPECT_NE(reportOf(c).find("different"), std::string::npos);
    const Picture shown = shownDifference(c, window), map = differenceOf(c, window);
    const std::size_t there = std::size_t(16 - 6) * 32 + (22 - 4);
    EXPECT_EQ(shown.find("R")->values[there], 1);
    EXPECT_LT(shown.find("G")->values[there], .3f);
    EXPECT_FLOAT_EQ(map.find("z")->values[there], float(worst.z));
}

TEST(CompareSeeds, OneReferenceIsExact) {
    std::mt19937 random(9);
    const std::vector<Picture> a = several(6, random, .1);
    const SeedComparison same = compareSeeds(a, several(1, random, 0));
    EXPECT_TRUE(same.referenceIsExact);
    EXPECT_EQ(exitCodeOf(same), 0) << reportOf(same);
    EXPECT_EQ(exitCodeOf(compareSeeds(a, several(1, random, 0, 1))), 1);
    // Nothing varies: any difference is one.
    EXPECT_EQ(exitCodeOf(compareSeeds(several(2, random, 0), several(2, random, 0))), 0);
    EXPECT_EQ(exitCodeOf(compareSeeds(several(2, random, 0, 1e-3), several(2, random, 0))), 1);
}

TEST(CompareSeeds, WhatCannotBeCompared) {
    std::mt19937 random(10);
    std::vector<Picture> a = several(2, random, .1), b = several(2, random, .1);
    EXPECT_EQ(exitCodeOf(compareSeeds(std::span(a).first(1), b)), 2);
    EXPECT_EQ(exitCodeOf(compareSeeds(a, b, {16, {"Z"}})), 2);
    b[1].channels.pop_back();
    EXPECT_EQ(exitCodeOf(compareSeeds(a, b)), 2);
    b[1].window.width = 99;
    EXPECT_EQ(exitCodeOf(compareSeeds(a, b)), 2);
}

TEST(DifferencePicture, OfTwoPictures) {
    std::mt19937 random(11);
    const Picture a = noisy(random, 0, 1), b = noisy(random, 0);
    const Picture values = differenceOf(a, b, std::nullopt);
    const std::size_t inside = std::size_t(16 - 6) * 32 + (22 - 4);
    EXPECT_EQ(values.find("G")->values[inside], 1);
    EXPECT_EQ(values.find("G")->values[0], 0);
    const Picture shown = shownDifference(a, b, std::nullopt, .1f);
    EXPECT_EQ(shown.find("R")->values[inside], 1);
    EXPECT_EQ(shown.find("B")->values[inside], 0);
    EXPECT_EQ(shown.find("B")->values[0], 1);
    const std::optional<FlipMap> flip = flipOf(a, b);
    ASSERT_TRUE(flip);
    EXPECT_EQ(differenceOf(a, b, flip).find("flip")->values[inside], flip->values[inside]);
}

} // namespace candela
