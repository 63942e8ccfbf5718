// SPDX-License-Identifier: Apache-2.0
// Tumblin and Rushmeier's operator: VALIDATION H3, in both variants of the display's adaptation.
#include "tests/filter_library/support/filter_run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace candela::filters {
namespace {

constexpr double displayMost = 86, contrastMost = 35, lambert = 3.14159265358979324e-4;
constexpr double displayAlpha = 1.98384572, displayBeta = 5.87739456;

const Filter unclipped = Filter("tumblin_rushmeier93").with("clip", 0);

/// Of the display, cd/m^2, for a luminance in a scene of that geometric mean.
double shown(const Filter &filter, double mean, double luminance) {
    const Picture found = filtered(filter.with("L_mean", mean), grey(1, 1, luminance));
    return (found.at(0, 0)[1] + 1 / contrastMost) * displayMost;
}

struct World {
    double mean, alpha, beta, atOffset, value; ///< of a pixel at 10^.84 times the mean
};

constexpr World table[] = {{.1, 1.45486, 6.11902, 8.6792, .0723},
                           {1, 1.85486, 6.06530, 12.8189, .1205},
                           {10, 2.25486, 5.21158, 18.9329, .1916},
                           {100, 2.65486, 3.55786, 27.9631, .2966},
                           {1000, 3.05486, 1.10414, 41.3003, .4517}};

TEST(TumblinRushmeier93, HasTheConstantsOfH3) {
    for (const World &world : table) {
        const double low = shown(unclipped, world.mean, world.mean);
        const double high = shown(unclipped, world.mean, 100 * world.mean);
        // Lamberts: 10^(beta_rw + alpha_rw l) = 10^(beta_d + alpha_d l_d).
        const double alpha = displayAlpha * std::log10(high / low) / 2;
        const double beta = displayBeta + displayAlpha * std::log10(low * lambert) -
                            alpha * std::log10(world.mean * lambert);
        EXPECT_NEAR(alpha, world.alpha, 2e-5) << world.mean;
        EXPECT_NEAR(beta, world.beta, 5e-5) << world.mean;
    }
}

TEST(TumblinRushmeier93, HasTheDisplayValuesOfH3) {
    for (const World &world : table) {
        EXPECT_NEAR(shown(unclipped, world.mean, world.mean), 2.10119, 2e-5) << world.mean;
        const double bright = world.mean * std::pow(10, .84);
        EXPECT_NEAR(shown(unclipped, world.mean, bright), world.atOffset, 1e-4) << world.mean;
        const Picture value = filtered(unclipped.with("L_mean", world.mean), grey(1, 1, bright));
        EXPECT_NEAR(value.at(0, 0)[0], world.value, 6e-5);
    }
    EXPECT_NEAR(shown(unclipped, 1e4, 1e4 * std::pow(10, .84)), 60.9988, 2e-4);
}

/// By the paper the middle of every scene is below the display's black; with .84 it is the middle
/// of the display's contrast, sqrt(C_max) above black.
TEST(TumblinRushmeier93, TheOffsetPutsTheScenesMiddleOnTheDisplays) {
    for (const double mean : {.1, 3., 100., 5000.}) {
        const Picture scene = grey(5, 4, mean);
        EXPECT_NEAR(filtered(unclipped, scene).at(2, 2)[0], -.00414, 1e-5);
        EXPECT_EQ(filtered(Filter("tumblin_rushmeier93"), scene).at(2, 2)[0], 0);
        const Filter symmetric = unclipped.with("displayoffset", .84);
        EXPECT_NEAR(shown(symmetric, mean, mean), 14.536653, 2e-4);
    }
}

TEST(TumblinRushmeier93, IsTheFormulaAndKeepsRatiosOfColours) {
    const Picture scene = manifold(53, 31, -2, 5);
    const double middle =
        meanOf(scene, [](const Rgb &c) { return std::log10(std::max(luminanceOf(c), 1e-4)); });
    const auto alpha = [](double l) { return .4 * l + 2.92; };
    const auto beta = [](double l) { return -.4 * l * l - 2.584 * l + 2.0208; };
    for (const double offset : {0., .84}) {
        const double world = middle + std::log10(lambert) + .84;
        const double display = std::log10(120 / std::sqrt(50.) * lambert) + offset;
        const auto expected = makePicture(53, 31, [&](int x, int y) {
            const double l = std::log10(luminanceOf(scene.at(x, y)) * lambert);
            const double brightness = beta(world) + alpha(world) * l;
            const double luminance =
                std::pow(10, (brightness - beta(display)) / alpha(display)) / lambert;
            const double value = luminance / 120 - 1 / 50.;
            Rgb c = value / luminanceOf(scene.at(x, y)) * photometricOf(scene.at(x, y));
            for (double &channel : c)
                channel = std::clamp(channel, 0., 1.);
            return c;
        });
        const Filter filter = Filter("tumblin_rushmeier93")
                                  .with("L_dmax", 120)
                                  .with("C_max", 50)
                                  .with("displayoffset", offset);
        expectNear(filtered(filter, scene), expected, 2e-5, .05);
    }
}

/// Black has no logarithm; it is black all the same, and counts as 1e-4 cd/m^2.
TEST(TumblinRushmeier93, BlackPixelsStayBlack) {
    Picture scene = grey(4, 1, 100);
    scene.at(0, 0) = {};
    EXPECT_EQ(filtered(unclipped, scene).at(0, 0)[1], 0);
    const double mean = std::pow(10, (3 * 2 - 4) / 4.);
    EXPECT_NEAR(filtered(unclipped, scene).at(3, 0)[1],
                shown(unclipped, mean, 100) / displayMost - 1 / contrastMost, 1e-5);
}

} // namespace
} // namespace candela::filters
