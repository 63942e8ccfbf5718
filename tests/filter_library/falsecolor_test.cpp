// SPDX-License-Identifier: Apache-2.0
// Measured quantities as colours, and a legend that says what they are.
#include "tests/filter_library/support/filter_run.h"
#include "tests/filter_library/support/legend.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace candela::filters {
namespace {

const Filter bare = Filter("falsecolor").with("legend", 0).with("palette", "grey");

TEST(FalseColor, PlacesLuminanceOnALinearOrLogarithmicScale) {
    const Picture scene = manifold(40, 30, -1, 4);
    const Filter linear = bare.with("scale", 500);
    expectNear(filtered(linear, scene),
               makePicture(40, 30,
                           [&](int x, int y) {
                               const double at = std::min(luminanceOf(scene.at(x, y)) / 500, 1.);
                               return Rgb{at, at, at};
                           }),
               1e-5, .01);
    const Filter logarithmic = linear.with("log", 1).with("decades", 2);
    expectNear(filtered(logarithmic, scene),
               makePicture(40, 30,
                           [&](int x, int y) {
                               const double l = std::log10(luminanceOf(scene.at(x, y)) / 500);
                               const double at = std::clamp(1 + l / 2, 0., 1.);
                               return Rgb{at, at, at};
                           }),
               1e-5, .1);
}

TEST(FalseColor, MeasuresIlluminanceOfIrradianceAndOfMatteSurfaces) {
    const Picture scene = manifold(8, 8, 0, 2);
    ImageMaps maps = mapsOf(Picture(8, 8));
    setMap(maps, "irradiance", scene);
    run({bare.with("scale", 200).with("quantity", "illuminance").with("map", "irradiance")}, maps);
    EXPECT_NEAR(pictureOf(maps).at(3, 5)[0], std::min(luminanceOf(scene.at(3, 5)) / 200, 1.), 1e-5);

    // E = pi L / albedo: a matte surface of albedo .5 under 314 lx has 50 cd/m^2.
    maps = mapsOf(grey(8, 8, 50));
    setMap(maps, "albedo", Picture(8, 8, {.5, .5, .5}));
    run({bare.with("scale", 1000).with("quantity", "matteilluminance")}, maps);
    EXPECT_NEAR(pictureOf(maps).at(3, 5)[0], .3141593, 1e-6);
    // Of what reflects nothing, nothing is known.
    maps = mapsOf(grey(8, 8, 50));
    setMap(maps, "albedo", Picture(8, 8));
    run({bare.with("scale", 1000).with("quantity", "matteilluminance")}, maps);
    EXPECT_EQ(pictureOf(maps).at(3, 5)[0], 0);
}

/// The top of a scale: 1, 2 or 5 times a power of ten, exceeded by few pixels.
TEST(FalseColor, ChoosesAScaleThatFits) {
    for (const double most : {.0123, .9, 3., 70., 1800., 6e5}) {
        Picture scene = makePicture(50, 40, [&](int x, int y) {
            const double value = most / 179 * (.5 + .5 * double(y * 50 + x) / 2000);
            return Rgb{value, value, value};
        });
        scene.at(3, 3) = {1e7, 1e7, 1e7}; // a lamp does not count
        const Picture found = filtered(bare, scene);
        const double top = luminanceOf(scene.at(30, 30)) / found.at(30, 30)[0];
        const double power = std::pow(10, std::floor(std::log10(top) + 1e-4));
        const double leading = top / power;
        EXPECT_LT(std::min({std::abs(leading - 1), std::abs(leading - 2), std::abs(leading - 5)}),
                  1e-3)
            << top;
        EXPECT_GE(top, most * .99);
        EXPECT_LE(top, most * 2.5 * 1.05);
    }
}

std::vector<std::string> textsOf(const Legend &legend) {
    std::vector<std::string> texts;
    for (const Label &label : legend.labels)
        texts.push_back(label.text);
    return texts;
}

using Texts = std::vector<std::string>;

TEST(FalseColor, TheLegendSaysTheScale) {
    const Picture scene = manifold(640, 480, 0, 3);
    const struct {
        double scale;
        Texts texts;
    } linear[] = {
        {1000, {"0", "100", "200", "300", "400", "500", "600", "700", "800", "900", "1000"}},
        {2, {"0", "0.2", "0.4", "0.6", "0.8", "1.0", "1.2", "1.4", "1.6", "1.8", "2.0"}},
        {300, {"0", "30", "60", "90", "120", "150", "180", "210", "240", "270", "300"}},
        {5e7, {"0", "5e6", "1e7", "1.5e7", "2e7", "2.5e7", "3e7", "3.5e7", "4e7", "4.5e7", "5e7"}},
    };
    for (const auto &wanted : linear) {
        const Picture found = filtered(Filter("falsecolor").with("scale", wanted.scale), scene);
        const Legend legend = readLegend(found, 640);
        EXPECT_EQ(legend.unit, "cd/m^");
        EXPECT_EQ(textsOf(legend), wanted.texts);
        for (std::size_t i = 0; i < legend.labels.size(); ++i)
            EXPECT_NEAR(legend.labels[i].place, double(i) / 10, .003);
    }
}

TEST(FalseColor, TheLegendOfALogarithmicScale) {
    const Picture scene = manifold(640, 480, 0, 3);
    const Filter three = Filter("falsecolor").with("scale", 200).with("log", 1).with("decades", 3);
    const Legend legend = readLegend(filtered(three.with("quantity", "illuminance"), scene), 640);
    EXPECT_EQ(legend.unit, "lx");
    EXPECT_EQ(textsOf(legend),
              (Texts{"0.2", "0.5", "1", "2", "5", "10", "20", "50", "100", "200"}));
    for (const Label &label : legend.labels)
        EXPECT_NEAR(label.place, 1 + std::log10(std::stod(label.text) / 200) / 3, .003);

    const Filter eight = three.with("scale", 1e5).with("decades", 8);
    EXPECT_EQ(textsOf(readLegend(filtered(eight, scene), 640)),
              (Texts{"0.001", "0.01", "0.1", "1", "10", "100", "1000", "10000", "100000"}));
    const Filter high = three.with("scale", 1e9).with("decades", 2);
    EXPECT_EQ(textsOf(readLegend(filtered(high, scene), 640)),
              (Texts{"1e7", "2e7", "5e7", "1e8", "2e8", "5e8", "1e9"}));
}

/// One dot a pixel, or several; on the picture, or beside it.
TEST(FalseColor, TheLegendGrowsWithThePictureAndStandsWhereItIsTold) {
    const Filter filter = Filter("falsecolor").with("scale", 50);
    for (const auto &[width, height] : {std::pair{160, 120}, {320, 240}, {1300, 800}}) {
        const Picture scene = manifold(width, height, 0, 1);
        const Picture on = filtered(filter, scene);
        EXPECT_EQ(on.width, width);
        const Legend legend = readLegend(on, width);
        ASSERT_GE(legend.labels.size(), 3u);
        EXPECT_EQ(legend.labels.front().text, "0");
        EXPECT_EQ(legend.labels.back().text, "50");
        const Picture beside = filtered(filter.with("legend", 2), scene);
        const int dots = std::max(std::min(width / 320, height / 240), 1);
        EXPECT_EQ(beside.width, width + 56 * dots);
        EXPECT_EQ(textsOf(readLegend(beside, width)), textsOf(legend));
        const Picture none = filtered(filter.with("legend", 0), scene);
        for (int x = 0; x < width; ++x)
            ASSERT_EQ(beside.at(x, height / 2), none.at(x, height / 2));
    }
    // No room for one.
    expectNear(filtered(filter, manifold(60, 50, 0, 1)),
               filtered(filter.with("legend", 0), manifold(60, 50, 0, 1)), 0, 0);
}

TEST(FalseColor, ContoursStandWhereLuminancePassesTheLegendsValues) {
    const auto ramp = makePicture(200, 20, [](int x, int) {
        const double value = (x + .5) / 179; // cd/m^2: x + .5
        return Rgb{value, value, value};
    });
    const Filter filter = bare.with("scale", 200).with("contours", 1);
    const Picture found = filtered(filter, ramp);
    for (int x = 1; x < 199; ++x) {
        const bool line = found.at(x, 10)[0] == 0;
        EXPECT_EQ(line, (x + 1) % 20 == 0) << x;
    }
    const Picture over = filtered(filter.with("contours", 2).with("palette", "heat"), ramp);
    for (int x = 1; x < 199; ++x) {
        const Rgb &c = over.at(x, 10);
        EXPECT_EQ(c[0] == c[1] && c[1] == c[2], (x + 1) % 20 != 0) << x;
    }
}

TEST(FalseColor, PalettesGoFromDarkToBright) {
    for (const char *palette : {"spectrum", "heat", "grey"}) {
        const Filter filter = bare.with("scale", 179).with("palette", palette);
        const auto ramp = makePicture(256, 1, [](int x, int) {
            const double value = x / 255.;
            return Rgb{value, value, value};
        });
        const Picture found = filtered(filter, ramp);
        EXPECT_LT(luminanceOf(found.at(0, 0)) / 179, .02) << palette;
        EXPECT_GT(luminanceOf(found.at(255, 0)) / 179, .4) << palette;
        // Neighbours are told apart.
        for (int x = 8; x < 256; x += 8) {
            double difference = 0;
            for (int c = 0; c < 3; ++c)
                difference += std::abs(found.at(x, 0)[c] - found.at(x - 8, 0)[c]);
            EXPECT_GT(difference, .003) << palette << x;
        }
    }
}

} // namespace
} // namespace candela::filters
