// SPDX-License-Identifier: Apache-2.0
#include "image/compare.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace candela {
namespace {

Picture flat(const std::vector<std::string> &names, float value,
             FrameWindow w = {4, 3, 0, 4, 0, 3}) {
    Picture picture;
    picture.window = w;
    for (const std::string &name : names)
        picture.channels.push_back({name, std::vector<float>(w.pixels(), value)});
    return picture;
}

TEST(Compare, EqualPictures) {
    const Picture a = flat({"R", "G", "B", "A"}, 0.5f);
    const Comparison same = comparePictures(a, a);
    EXPECT_EQ(exitCodeOf(same), 0);
    ASSERT_EQ(same.channels.size(), 4u);
    EXPECT_EQ(same.channels[0].largest, 0);
    EXPECT_FALSE(same.channels[0].psnr);
    EXPECT_EQ(same.relMseOfLuminance, 0);
    EXPECT_NE(reportOf(same).find("the same"), std::string::npos);
}

TEST(Compare, NumbersByHand) {
    const FrameWindow window{20, 20, 5, 9, 10, 13};
    Picture a = flat({"Y"}, 2, window);
    const Picture b = flat({"Y"}, 2, window);
    a.channels[0].values[6] = 5;  // At (7, 11).
    a.channels[0].values[11] = 1; // At (8, 12).
    const Comparison c = comparePictures(a, b);
    const ChannelComparison &y = c.channels[0];
    EXPECT_EQ(exitCodeOf(c), 1);
    EXPECT_EQ(y.largest, 3);
    EXPECT_EQ(y.x, 7);
    EXPECT_EQ(y.y, 11);
    EXPECT_EQ(y.valueA, 5);
    EXPECT_EQ(y.valueB, 2);
    EXPECT_DOUBLE_EQ(y.mean, 4.0 / 12);
    EXPECT_DOUBLE_EQ(y.meanDifference, 2.0 / 12);
    EXPECT_DOUBLE_EQ(y.relMse, 10 / 4.01 / 12);
    EXPECT_DOUBLE_EQ(*y.psnr, 10 * std::log10(4 * 12 / 10.0));
    EXPECT_EQ(y.beyond, 2u);
    EXPECT_NE(reportOf(c).find("at (7, 11): 5 and 2"), std::string::npos) << reportOf(c);
}

TEST(Compare, Tolerances) {
    const Picture a = flat({"Y"}, 100), b = flat({"Y"}, 101);
    EXPECT_EQ(exitCodeOf(comparePictures(a, b, {0.5f, 0, {}})), 1);
    EXPECT_EQ(exitCodeOf(comparePictures(a, b, {1, 0, {}})), 0);
    EXPECT_EQ(exitCodeOf(comparePictures(a, b, {0, 0.02f, {}})), 0);
    EXPECT_EQ(exitCodeOf(comparePictures(a, b, {0, 0.002f, {}})), 1);
}

TEST(Compare, ChannelsByName) {
    const Picture a = flat({"R", "A"}, 1), b = flat({"Z", "R"}, 1);
    const Comparison all = comparePictures(a, b);
    EXPECT_EQ(exitCodeOf(all), 1);
    EXPECT_EQ(all.onlyInA, std::vector<std::string>{"A"});
    EXPECT_EQ(all.onlyInB, std::vector<std::string>{"Z"});
    EXPECT_EQ(exitCodeOf(comparePictures(a, b, {0, 0, {"R"}})), 0);
    EXPECT_EQ(exitCodeOf(comparePictures(a, b, {0, 0, {"Q"}})), 2);
    EXPECT_EQ(exitCodeOf(comparePictures(a, flat({"Q"}, 1))), 2);
}

TEST(Compare, OtherSizesAreNotComparable) {
    const Comparison c = comparePictures(flat({"Y"}, 1), flat({"Y"}, 1, {4, 3, 1, 4, 0, 3}));
    EXPECT_EQ(exitCodeOf(c), 2);
    EXPECT_NE(reportOf(c).find("4 x 3"), std::string::npos);
}

TEST(Compare, ValuesThatAreNoNumbers) {
    Picture a = flat({"Y"}, 1), b = a;
    a.channels[0].values[2] = b.channels[0].values[2] = NAN;
    a.channels[0].values[3] = b.channels[0].values[3] = INFINITY;
    EXPECT_EQ(exitCodeOf(comparePictures(a, b)), 0);
    b.channels[0].values[2] = 1;
    const Comparison c = comparePictures(a, b, {1e30f, 1, {}});
    EXPECT_EQ(exitCodeOf(c), 1);
    EXPECT_TRUE(std::isinf(c.channels[0].largest));
    EXPECT_EQ(c.channels[0].x, 2);
    b.channels[0].values[2] = NAN;
    b.channels[0].values[3] = -INFINITY;
    EXPECT_EQ(exitCodeOf(comparePictures(a, b, {1e30f, 1, {}})), 1);
    b.channels[0].values[3] = 0;
    EXPECT_EQ(exitCodeOf(comparePictures(a, b, {1e30f, 1, {}})), 1);
}

/// Two noisy pictures of mean 1 and 1 + offset, with a true variance of 0.04 and 0.09.
Comparison noisy(double offset) {
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    const FrameWindow window{100, 100, 0, 100, 0, 100};
    Picture a = flat({"R", "variance.R"}, 0.04f, window);
    Picture b = flat({"R", "variance.R"}, 0.09f, window);
    for (std::size_t i = 0; i < window.pixels(); ++i) {
        a.channels[0].values[i] = float(1 + 0.2 * normal(random));
        b.channels[0].values[i] = float(1 + offset + 0.3 * normal(random));
    }
    return comparePictures(a, b);
}

TEST(Compare, ConfidenceTellsNoiseFromBias) {
    const auto noise = noisy(0).channels[0].confidence;
    ASSERT_TRUE(noise);
    EXPECT_EQ(noise->pixels, 10000u);
    EXPECT_NEAR(noise->reduced, 1, 4 * std::sqrt(2.0 / 10000));
    EXPECT_LT(std::abs(noise->zOfMean), 4);
    EXPECT_GT(noise->probability, 1e-4);
    // A bias of 0.05 is hidden in every pixel, but 14 standard deviations of the mean.
    const auto bias = noisy(0.05).channels[0].confidence;
    EXPECT_NEAR(bias->zOfMean, -0.05 * 100 / std::sqrt(0.13), 4);
    EXPECT_LT(bias->probability, 1e-12);
}

TEST(Compare, ConfidenceOnlyForLinearRadiance) {
    Picture a = flat({"R", "radiance.R", "variance.R"}, 0.5f);
    EXPECT_TRUE(comparePictures(a, a).channels[0].confidence);
    a.metadata["exposure"] = "1 2.2";
    const Comparison exposed = comparePictures(a, a);
    EXPECT_FALSE(exposed.channels[0].confidence);
    EXPECT_TRUE(exposed.channels[1].confidence);
    a = flat({"R", "variance.R"}, INFINITY);
    EXPECT_FALSE(comparePictures(a, a).channels[0].confidence);
}

} // namespace
} // namespace candela
