// SPDX-License-Identifier: Apache-2.0
// Veiling glare: the CIE's function about a point of light, and no light lost or made.
#include "tests/filter_library/support/filter_run.h"

#include <gtest/gtest.h>

#include <cmath>

namespace candela::filters {
namespace {

/// CIE 135/1, 1/sr at an angle in degrees.
double glare(double angle, double age, double pigment) {
    const auto over = [&](double scale, double power) {
        return std::pow(1 + angle * angle / (scale * scale), -power);
    };
    const double old = std::pow(age / 70, 4);
    return (1 - .08 * old) * (9.2e6 * over(.0046, 1.5) + 1.5e5 * over(.045, 1.5)) +
           (1 + 1.6 * old) * (400 * over(.1, 1) + 3e-8 * angle * angle +
                              pigment * (1300 * over(.1, 1.5) + .8 * over(.1, .5))) +
           2.5e-3 * pigment;
}

/// A point of 1 in the middle of the dark.
Picture star(int size) {
    Picture dark(size, size);
    dark.at(size / 2, size / 2) = {1, 1, 1};
    return dark;
}

/// The mean of values at a distance from the middle, within an eighth of it.
double ring(const Picture &picture, double radius) {
    const int middle = picture.width / 2;
    double sum = 0;
    int count = 0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            if (std::abs(std::hypot(x - middle, y - middle) - radius) < radius / 8) {
                sum += picture.at(x, y)[1];
                ++count;
            }
    return sum / count;
}

/// The same mean of the function itself.
double ringOfGlare(int size, double radius, double pixel, double age, double pigment) {
    const double steradians = std::pow(pixel * 3.14159265358979324 / 180, 2);
    const auto kernel = makePicture(size, size, [&](int x, int y) {
        const double angle = pixel * std::hypot(x - size / 2, y - size / 2);
        const double value = glare(angle, age, pigment) * steradians;
        return Rgb{value, value, value};
    });
    return ring(kernel, radius);
}

TEST(Bloom, APointOfLightHasTheGlareOfTheCie) {
    const int size = 255;
    for (const double degrees : {20., 60.})
        for (const double age : {25., 70.}) {
            const Filter filter = Filter("bloom").with("fieldofview", degrees).with("age", age);
            const Picture found = filtered(filter, star(size));
            for (const double radius : {4., 6., 9., 14., 20., 30., 45.}) {
                const double expected = ringOfGlare(size, radius, degrees / size, age, .5);
                EXPECT_NEAR(ring(found, radius) / expected, 1, .1)
                    << degrees << " degrees, age " << age << ", " << radius << " pixels";
            }
        }
}

TEST(Bloom, NoLightIsLostOrMade) {
    for (const auto &[width, height] : {std::pair{64, 48}, {61, 37}, {5, 90}, {1, 1}, {3, 2}}) {
        Picture scene = manifold(width, height, -1, 3);
        scene.at(width - 1, height / 2) = {1e4, 3e3, 1}; // a lamp at the border
        const Rgb before = sumOf(scene);
        const Rgb after = sumOf(filtered(Filter("bloom"), scene));
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(after[c] / before[c], 1, 1e-6) << width << " x " << height;
    }
}

TEST(Bloom, ConstantPicturesStayAsTheyAre) {
    const Picture scene(50, 33, {.25, 3, 1000});
    expectNear(filtered(Filter("bloom"), scene), scene, 2e-6, 0);
    const Picture dark(20, 20);
    expectNear(filtered(Filter("bloom"), dark), dark, 0, 0);
}

TEST(Bloom, ItIsAsStrongAsItIsToldToBe) {
    const Picture scene = star(63);
    const Picture once = filtered(Filter("bloom"), scene);
    const Picture half = filtered(Filter("bloom").with("strength", .5), scene);
    EXPECT_NEAR(half.at(5, 20)[0] / once.at(5, 20)[0], .5, 1e-5);
    expectNear(filtered(Filter("bloom").with("strength", 0), scene), scene, 0, 0);
    // No more than all of it.
    const Picture all = filtered(Filter("bloom").with("strength", 1e6), scene);
    EXPECT_NEAR(sumOf(all)[0], 1, 1e-5);
    for (const Rgb &c : all.pixels)
        EXPECT_GE(c[0], 0);
}

} // namespace
} // namespace candela::filters
