// SPDX-License-Identifier: Apache-2.0
// random() is another number for each call, pixel, sample and seed, uniform over [0, 1).
#include "tests/support/frames.h"

#include <cmath>
#include <gtest/gtest.h>

namespace candela::test {
namespace {

using Values = std::vector<float>;

double mean(const Values &a) {
    double sum = 0;
    for (float value : a)
        sum += value;
    return sum / double(a.size());
}

/// Of numbers that are uniform over [0, 1): their covariance, 1 for a number with itself.
double correlation(const Values &a, const Values &b, std::size_t shift = 0) {
    double sum = 0;
    for (std::size_t i = 0; i + shift < a.size(); ++i)
        sum += (a[i] - .5) * (b[i + shift] - .5);
    return 12 * sum / double(a.size() - shift);
}

/// A square that fills the view: an intensity of 1 gives it a radiance of 1 (classic units).
std::vector<FramePixels> throwDice(int samples, int seed) {
    std::vector<Frame> frames;
    for (const char *integrator : {"path", "classic"})
        for (const char *shining : {"1", "0"})
            frames.push_back(
                {integrator,
                 "Option \"render\" \"string integrator\" [\"" + std::string(integrator) +
                     "\"]\nFormat 64 64 1\nProjection \"orthographic\"\n",
                 "Attribute \"light\" \"string units\" [\"classic\"]\n"
                 "LightSource \"distantlight\" 1 \"point from\" [0 0 0] \"point to\" [0 0 1]\n"
                 "Surface \"dice\" \"float shining\" [" +
                     std::string(shining) + "]\nPolygon \"P\" [-2 -2 1 -2 2 1 2 2 1 2 -2 1]\n"});
    return render(frames, {samples, seed, "shading/shaders"});
}

TEST(Random, NumbersAreUniformAndIndependent) {
    const std::vector<FramePixels> first = throwDice(1, 1), second = throwDice(1, 2);
    ASSERT_EQ(first.size(), 4u);
    ASSERT_EQ(second.size(), 4u);
    for (std::size_t i = 0; i < first.size(); ++i) {
        const Values &red = first[i].red, &green = first[i].green;
        ASSERT_EQ(red.size(), 64u * 64);
        constexpr double error = 5. / 64; // Five standard errors of what comes to 1.
        EXPECT_NEAR(mean(red), .5, error * std::sqrt(1. / 12));
        EXPECT_NEAR(correlation(red, red), 1, error);
        EXPECT_NEAR(correlation(red, green), 0, error);
        for (std::size_t shift : {1, 64})
            EXPECT_NEAR(correlation(red, red, shift), 0, error);
        EXPECT_NEAR(correlation(red, second[i].red), 0, error);
    }
}

TEST(Random, NumbersOfAPixelsSamplesAreIndependent) {
    for (const FramePixels &picture : throwDice(16, 1))
        EXPECT_NEAR(16 * correlation(picture.red, picture.red), 1, 5. / 64 * std::sqrt(2.));
}

} // namespace
} // namespace candela::test
