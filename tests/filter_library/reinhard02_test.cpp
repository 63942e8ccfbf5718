// SPDX-License-Identifier: Apache-2.0
// Reinhard's operator, for the whole picture and with dodging and burning.
#include "tests/filter_library/support/filter_run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace candela::filters {
namespace {

double logMean(const Picture &scene) {
    return std::exp(meanOf(scene, [](const Rgb &c) { return std::log(luminanceOf(c) + 1e-4); }));
}

TEST(Reinhard02, GlobalIsTheFormula) {
    const Picture scene = manifold(47, 29, -1, 4);
    double greatest = 0;
    for (const Rgb &c : scene.pixels)
        greatest = std::max(greatest, luminanceOf(c));
    for (const double white : {0., 800.}) {
        const double scale = .25 / logMean(scene);
        const double most = (white > 0 ? white : greatest) * scale;
        const auto expected = makePicture(47, 29, [&](int x, int y) {
            const double L = luminanceOf(scene.at(x, y)) * scale;
            const double value = L * (1 + L / (most * most)) / (1 + L);
            return value / luminanceOf(scene.at(x, y)) * photometricOf(scene.at(x, y));
        });
        const Filter filter = Filter("reinhard02").with("key", .25).with("L_white", white);
        expectNear(filtered(filter, scene), expected, 5e-6, 0);
    }
}

/// The scaled luminances about a pixel, seen through a Gaussian of that size: all of it at once.
double seen(const Picture &scene, double scale, int x, int y, double size) {
    const double deviation = size / 4;
    const int radius = std::min(int(std::floor(3 * deviation + 1)), 32);
    double sum = 0, weights = 0;
    for (int j = -radius; j <= radius; ++j)
        for (int i = -radius; i <= radius; ++i) {
            const double weight = std::exp(-(i * i + j * j) / (2 * deviation * deviation));
            sum += weight * luminanceOf(scene.clamped(x + i, y + j)) * scale;
            weights += weight;
        }
    return sum / weights;
}

/// What a pixel adapts to. `doubtful`: some comparison was too close for rounding.
double adapted(const Picture &scene, double scale, int x, int y, double key, bool &doubtful) {
    double size = 1, centre = seen(scene, scale, x, y, 1), chosen = centre;
    for (int number = 0; number < 8; ++number, size *= 1.6) {
        const double surround = seen(scene, scale, x, y, size * 1.6);
        const double edge = 256 * key / (size * size);
        const double contrast = std::abs(centre - surround) / (edge + centre);
        doubtful = doubtful || std::abs(contrast - .05) < 1e-5;
        if (contrast >= .05)
            break;
        chosen = centre;
        centre = surround;
    }
    return chosen;
}

/// A bright window in a dark room, and detail in both.
Picture room(int width, int height) {
    return makePicture(width, height, [&](int x, int y) {
        const bool window = x > width / 2 && y > 4 && y < height / 2;
        const double detail = 1 + .3 * std::sin(x * .9) * std::cos(y * .7);
        const double value = float((window ? 20 : .05) * detail);
        return Rgb{value, value, value};
    });
}

TEST(Reinhard02, LocalIsTheFormula) {
    const Picture scene = room(41, 33);
    const double scale = .18 / logMean(scene);
    const Picture found = filtered(Filter("reinhard02").with("local", 1), scene);
    int doubts = 0;
    for (int y = 0; y < scene.height; ++y)
        for (int x = 0; x < scene.width; ++x) {
            bool doubtful = false;
            const double v = adapted(scene, scale, x, y, .18, doubtful);
            const double value = luminanceOf(scene.at(x, y)) * scale / (1 + v);
            if (!doubtful) {
                ASSERT_NEAR(found.at(x, y)[1] / value, 1, 2e-5) << x << " " << y;
            }
            doubts += doubtful;
        }
    EXPECT_LT(doubts, 10);
}

/// Where all is alike, each pixel adapts to itself, and both variants say L / (1 + L).
TEST(Reinhard02, BothVariantsAgreeOnFlatPictures) {
    for (const double luminance : {.5, 20., 3000.}) {
        const Picture scene = grey(40, 9, luminance);
        const Picture local = filtered(Filter("reinhard02").with("local", 1), scene);
        const Filter global = Filter("reinhard02").with("L_white", 1e9);
        expectNear(local, filtered(global, scene), 3e-5, 0);
        EXPECT_NEAR(local.at(20, 4)[0], .18 / 1.18, 1e-4);
    }
}

TEST(Reinhard02, BrighterIsBrighterAndNothingBurnsOut) {
    const Picture ramp = makePicture(200, 1, [](int x, int) {
        const double value = float(std::pow(10, -3 + x * .03));
        return Rgb{value, value, value};
    });
    const Picture found = filtered(Filter("reinhard02"), ramp);
    for (int x = 1; x < ramp.width; ++x)
        EXPECT_GT(found.at(x, 0)[0], found.at(x - 1, 0)[0]);
    EXPECT_NEAR(found.at(199, 0)[0], 1, 1e-5);
}

} // namespace
} // namespace candela::filters
