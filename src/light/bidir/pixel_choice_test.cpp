// SPDX-License-Identifier: Apache-2.0
#include "light/bidir/pixel_choice.h"

#include <cmath>
#include <gtest/gtest.h>
#include <map>

namespace candela {
namespace {

class SplatsUnder : public testing::TestWithParam<PixelFilterRecord> {};

/// Light that is the same everywhere splats as much into each pixel as a pixel's area of it is.
TEST_P(SplatsUnder, giveEachPixelItsShare) {
    const PixelChoice choice(GetParam());
    constexpr int steps = 60, reach = 4;
    double into = 0;
    for (int i = 0; i < steps * 2 * reach; ++i)
        for (int k = 0; k < steps * 2 * reach; ++k) {
            // Splats all around pixel (20, 30), whose number a golden ratio spreads.
            const float x = 20.5f - reach + (float(i) + .5f) / steps;
            const float y = 30.5f - reach + (float(k) + .5f) / steps;
            const double number = std::fmod((i * 977 + k) * 0.6180339887498949, 1);
            const SplatPlace place = choice.choose(x, y, float(number));
            if (place.x == 20.5f && place.y == 30.5f)
                into += place.weight;
        }
    EXPECT_NEAR(into / (steps * steps), 1, 2e-2);
}

/// What a splat gives each pixel in the mean over numbers is the kernel's value there.
TEST_P(SplatsUnder, areSharedAsTheKernelHasIt) {
    const PixelChoice choice(GetParam());
    const float x = 20.3f, y = 30.8f;
    std::map<std::pair<float, float>, double> shares;
    constexpr int numbers = 20000;
    for (int k = 0; k < numbers; ++k) {
        const SplatPlace place = choice.choose(x, y, (float(k) + .5f) / numbers);
        shares[{place.x, place.y}] += place.weight / numbers;
    }
    double kernelSum = 0, sum = 0;
    for (const auto &[pixel, share] : shares) {
        kernelSum +=
            pixelFilterKernel(GetParam(), x - double(pixel.first), y - double(pixel.second));
        sum += share;
    }
    for (const auto &[pixel, share] : shares)
        EXPECT_NEAR(
            share / sum,
            pixelFilterKernel(GetParam(), x - double(pixel.first), y - double(pixel.second)) /
                kernelSum,
            1e-3);
}

INSTANTIATE_TEST_SUITE_P(All, SplatsUnder,
                         testing::Values(PixelFilterRecord{"box", 1, 1},
                                         PixelFilterRecord{"gaussian", 2, 2},
                                         PixelFilterRecord{"triangle", 3, 2},
                                         PixelFilterRecord{"mitchell", 4, 4},
                                         PixelFilterRecord{"catmull-rom", 4, 4}),
                         [](const auto &info) {
                             std::string name = info.param.name;
                             std::erase(name, '-');
                             return name;
                         });

} // namespace
} // namespace candela
