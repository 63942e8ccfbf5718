// SPDX-License-Identifier: Apache-2.0
// Ward's scale factor: VALIDATION H2, what it is made of, and the paper's figure 7 by the letter.
#include "tests/filter_library/support/filter_run.h"

#include <gtest/gtest.h>

#include <cmath>

namespace candela::filters {
namespace {

/// 1/(cd m^-2)
double scaleFactor(double adaptation, double displayMost) {
    const double world = 1.219 + std::pow(adaptation, .4);
    const double display = 1.219 + std::pow(displayMost / 2, .4);
    return std::pow(display / world, 2.5) / displayMost;
}

struct Known {
    double adaptation, factor, value;
};

constexpr Known table[] = {{.1, .265258365, .02653},      {1, .120260454, .12026},
                           {10, .0328084734, .32808},     {50, .01, .5},
                           {100, .00567197577, .56720},   {1000, .000732932266, .73293},
                           {10000, 8.18031054e-5, .81803}};

TEST(Ward94, HasTheScaleFactorsOfH2ToSixDigits) {
    for (const Known &known : table) {
        const Filter ward = Filter("ward94").with("L_wa", known.adaptation);
        const Picture found = filtered(ward, grey(2, 1, 1));
        EXPECT_NEAR(found.at(0, 0)[1] / known.factor, 1, 1e-6) << known.adaptation;
    }
}

TEST(Ward94, AdaptsToTheMeanOfTheScene) {
    for (const Known &known : table)
        for (const double logaverage : {0, 1}) {
            // The average of logarithms adds 1e-4 cd/m^2.
            const double bound = logaverage != 0 ? 1e-3 : 2e-6;
            const Filter ward = Filter("ward94").with("logaverage", logaverage);
            const Picture found = filtered(ward, grey(7, 5, known.adaptation));
            EXPECT_NEAR(found.at(3, 2)[0], known.factor * known.adaptation, bound * known.value);
            EXPECT_NEAR(found.at(3, 2)[0], known.value, bound + 5e-6) << known.adaptation;
        }
}

TEST(Ward94, IsTheFormulaOfItsAverages) {
    const Picture scene = manifold(61, 37, -1, 4);
    const double mean = meanOf(scene, luminanceOf);
    const double logmean =
        std::exp(meanOf(scene, [](const Rgb &c) { return std::log(luminanceOf(c) + 1e-4); }));
    for (const double most : {100., 400.})
        for (const double logaverage : {0, 1}) {
            const double factor = scaleFactor(logaverage != 0 ? logmean : mean, most);
            const Filter ward =
                Filter("ward94").with("logaverage", logaverage).with("L_dmax", most);
            const auto expected = makePicture(
                61, 37, [&](int x, int y) { return factor * photometricOf(scene.at(x, y)); });
            expectNear(filtered(ward, scene), expected, 3e-6, 0);
        }
}

/// Nothing is to be seen there, so nobody adapts to it; figure 7's mean counts it.
TEST(Ward94, TheAverageOfLogarithmsLeavesOutTheBackground) {
    Picture scene = grey(40, 20, 30), opacity(40, 20, {1, 1, 1});
    for (int y = 0; y < 20; ++y)
        for (int x = 0; x < 30; ++x)
            scene.at(x, y) = opacity.at(x, y) = {};
    for (const double logaverage : {0, 1}) {
        ImageMaps maps = mapsOf(scene);
        setMap(maps, "Oi", opacity);
        run({Filter("ward94").with("logaverage", logaverage)}, maps);
        const double adaptation = logaverage != 0 ? 30 : 7.5;
        EXPECT_NEAR(pictureOf(maps).at(35, 3)[0], scaleFactor(adaptation, 100) * 30, 1e-5);
    }
}

/// The figure scales radiance by a factor for luminance, so its picture is 179 times too dark.
TEST(Ward94, Figure7ByTheLetterRunsAndScalesRadiance) {
    const Picture scene = manifold(24, 18, 0, 3);
    const double factor = scaleFactor(meanOf(scene, luminanceOf), 80);
    const auto expected =
        makePicture(24, 18, [&](int x, int y) { return factor * scene.at(x, y); });
    expectNear(filtered(Filter("figure7").with("L_dmax", 80), scene), expected, 3e-6, 0);
}

} // namespace
} // namespace candela::filters
