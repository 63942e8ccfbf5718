// SPDX-License-Identifier: Apache-2.0
#include "image/flip.h"

#include <cmath>
#include <gtest/gtest.h>

namespace candela {

namespace {

Picture flat(std::array<float, 3> color, bool display, int width = 40, int height = 30) {
    Picture picture;
    picture.window = {width, height, 0, width, 0, height};
    for (int c = 0; c < 3; ++c)
        picture.channels.push_back(
            {std::string(1, "RGB"[c]), std::vector<float>(picture.window.pixels(), color[c])});
    picture.hasDisplayValues = display;
    return picture;
}

void set(Picture &picture, int x, int y, float value) {
    for (PictureChannel &channel : picture.channels)
        channel.values[std::size_t(y) * picture.window.columns() + x] = value;
}

} // namespace

TEST(Flip, EndsOfTheScale) {
    const Picture green = flat({0, 1, 0}, true), blue = flat({0, 0, 1}, true);
    EXPECT_EQ(flipOf(green, green)->mean, 0);
    EXPECT_NEAR(flipOf(green, blue)->mean, 1, 1e-5); // By definition.
    EXPECT_NEAR(flipOf(blue, green)->mean, 1, 1e-5);
}

/// Flat pictures have no edges and filters leave them alone: of black and white the lightness
/// differs by 100. HyAB of green (L 87.735, a -86.183, b 83.180) and blue (32.303, 79.188,
/// -107.857) under Hunt's fading: a, b times L / 100.
TEST(Flip, FlatPicturesByHand) {
    const double green[3] = {87.735, -.87735 * 86.183, .87735 * 83.180};
    const double blue[3] = {32.303, .32303 * 79.188, -.32303 * 107.857};
    const double largest =
        std::pow(green[0] - blue[0] + std::hypot(green[1] - blue[1], green[2] - blue[2]), .7);
    const double error = std::pow(100, .7);
    ASSERT_GT(error, .4 * largest);
    const double expected = .95 + .05 * (error - .4 * largest) / (.6 * largest);
    EXPECT_NEAR(flipOf(flat({0, 0, 0}, true), flat({1, 1, 1}, true))->mean, expected, 1e-3);
    // A lightness of 50 and one of 51, as sRGB has them.
    const double small = .95 / (.4 * largest);
    EXPECT_NEAR(flipOf(flat({.466327f, .466327f, .466327f}, true),
                       flat({.476219f, .476219f, .476219f}, true))
                    ->mean,
                small, .01 * small);
}

/// A pixel that sparkles is worse than its smoothed colour says, and near the eye worse still.
TEST(Flip, PointsAreSeen) {
    const Picture grey = flat({.4f, .4f, .4f}, true);
    Picture sparkling = grey;
    set(sparkling, 20, 15, 1);
    const FlipMap far = *flipOf(sparkling, grey), near = *flipOf(sparkling, grey, 20);
    EXPECT_GT(far.values[15 * 40 + 20], .1f);
    EXPECT_GT(near.values[15 * 40 + 20], far.values[15 * 40 + 20]);
    EXPECT_EQ(far.values[0], 0);
}

TEST(Flip, LightIsLookedAtAtAllExposures) {
    Picture reference = flat({1, 1, 1}, false);
    for (int x = 0; x < 10; ++x)
        for (int y = 0; y < 30; ++y)
            set(reference, x, y, 1000);
    Picture test = reference;
    EXPECT_EQ(flipOf(test, reference)->mean, 0);
    EXPECT_EQ(flipOf(test, reference)->exposures, 10); // log2(1000), rounded up.
    set(test, 3, 15, 500); // White at most exposures, but not at the first.
    EXPECT_GT(flipOf(test, reference)->values[15 * 40 + 3], .05f);
    // A factor for both pictures changes nothing.
    Picture a = test, b = reference;
    for (Picture *picture : {&a, &b})
        for (PictureChannel &channel : picture->channels)
            for (float &value : channel.values)
                value *= 64;
    EXPECT_NEAR(flipOf(a, b)->mean, flipOf(test, reference)->mean, 1e-4);
}

TEST(Flip, StrangePictures) {
    const Picture black = flat({0, 0, 0}, false);
    Picture strange = black;
    set(strange, 0, 0, NAN);
    set(strange, 1, 0, -1);
    EXPECT_EQ(flipOf(strange, black)->mean, 0);
    Picture grey = black;
    grey.channels.resize(1);
    EXPECT_FALSE(flipOf(grey, black));
    EXPECT_FALSE(flipOf(flat({1, 1, 1}, false, 1, 1), black));
    EXPECT_TRUE(flipOf(flat({1, 1, 1}, true, 1, 1), flat({0, 1, 1}, true, 1, 1)));
}

} // namespace candela
