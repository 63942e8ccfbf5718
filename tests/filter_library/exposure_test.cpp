// SPDX-License-Identifier: Apache-2.0
// One factor for all pixels: linear_scale and exposure_ev.
#include "tests/filter_library/support/filter_run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace candela::filters {
namespace {

/// The factor from luminance to value, once it is sure that there is one for all pixels.
double factorOf(const Filter &filter, const Picture &scene) {
    const Picture found = filtered(filter, scene);
    const double factor = found.at(0, 0)[0] / photometricOf(scene.at(0, 0))[0];
    const auto expected = makePicture(scene.width, scene.height, [&](int x, int y) {
        return factor * photometricOf(scene.at(x, y));
    });
    expectNear(found, expected, 1e-6, 0);
    return factor;
}

TEST(LinearScale, PutsWhatIsNamedWhereItIsSaid) {
    const Picture scene = manifold(31, 23, 0, 3);
    double greatest = 0;
    for (const Rgb &c : scene.pixels)
        greatest = std::max(greatest, luminanceOf(c));
    const double mean = meanOf(scene, luminanceOf);
    const double logmean =
        std::exp(meanOf(scene, [](const Rgb &c) { return std::log(luminanceOf(c) + 1e-4); }));

    const Filter scale("linear_scale");
    EXPECT_NEAR(factorOf(scale, scene) * greatest, 1, 1e-6);
    EXPECT_NEAR(factorOf(scale.with("reference", "mean"), scene) * mean, .5, 1e-6);
    EXPECT_NEAR(factorOf(scale.with("reference", "logmean"), scene) * logmean, .18, 1e-6);
    EXPECT_NEAR(factorOf(scale.with("L_white", 250), scene) * 250, 1, 1e-6);
    EXPECT_NEAR(factorOf(scale.with("L_white", 250).with("gain", 2), scene) * 250, 2, 1e-6);
}

TEST(LinearScale, BlackStaysBlack) {
    EXPECT_EQ(filtered(Filter("linear_scale"), grey(3, 3, 0)).at(1, 1), Rgb{});
}

/// ISO 12232: saturation at 78 / S lx s; the sensor gets q L t / N^2.
TEST(ExposureEv, SaturatesWhereTheStandardSays) {
    const Picture scene = manifold(9, 7, 0, 3);
    const Filter camera = Filter("exposure_ev").with("aperture", 8).with("shutter", 1 / 60.);
    for (const double speed : {100., 800.}) {
        const double most = 78 / speed * 64 * 60 / .65;
        EXPECT_NEAR(factorOf(camera.with("ISO", speed), scene) * most, 1, 2e-6);
    }
    // The customary 1.2 * 2^EV cd/m^2 at ISO 100.
    EXPECT_NEAR(factorOf(Filter("exposure_ev").with("EV", 15), scene) * 1.2 * 32768, 1, 2e-6);
    EXPECT_NEAR(factorOf(Filter("exposure_ev").with("EV", -3), scene) * 1.2 / 8, 1, 2e-6);
}

TEST(ExposureEv, EvIsApertureAndShutter) {
    const Picture scene = grey(2, 2, 100);
    const Filter evs = Filter("exposure_ev").with("EV", std::log2(5.6 * 5.6 * 125));
    const Filter camera = Filter("exposure_ev").with("aperture", 5.6).with("shutter", .008);
    EXPECT_NEAR(factorOf(evs, scene) / factorOf(camera, scene), 1, 1e-5);
    EXPECT_NEAR(factorOf(evs.with("compensation", 2), scene) / factorOf(camera, scene), 4, 4e-5);
}

/// ISO 2720: N^2/t = L S/K. What is metered comes out at q K/78, whatever it is, at any speed.
TEST(ExposureEv, TheMeterPutsTheMeanAtTheSameValue) {
    for (const double factor : {.01, 1., 300.})
        for (const double speed : {100., 3200.}) {
            Picture scene = manifold(33, 20, 0, 3);
            for (Rgb &c : scene.pixels)
                c = factor * c;
            const Picture found = filtered(Filter("exposure_ev").with("ISO", speed), scene);
            const double mean = meanOf(found, luminanceOf) / 179;
            EXPECT_NEAR(mean / (.65 * 12.5 / 78), 1, 1e-5);
        }
    EXPECT_EQ(filtered(Filter("exposure_ev"), grey(3, 3, 0)).at(1, 1), Rgb{});
}

} // namespace
} // namespace candela::filters
