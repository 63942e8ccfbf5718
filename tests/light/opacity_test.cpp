// SPDX-License-Identifier: Apache-2.0
// Sheets that let light through: exact under `classic`, and right whatever opacity is claimed.
#include "foundation/base/student.h"
#include "tests/light/pictures.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace candela::test {
namespace {

std::string sheet(double z, double color, double opacity) {
    return "Surface \"constant\"\nColor [" + std::to_string(color) + " 0 0]\nOpacity [" +
           std::to_string(opacity) + " " + std::to_string(opacity) + " " + std::to_string(opacity) +
           "]\n" + squareAt(z);
}

std::string claiming(double opacity) {
    return "Surface \"exactly\" \"float opacity\" [" + std::to_string(opacity) + "]\n";
}

void expectEverywhere(const std::vector<float> &values, double expected) {
    ASSERT_EQ(values.size(), 64u);
    for (float value : values)
        EXPECT_NEAR(value, expected, 1e-6 * (1 + expected));
}

TEST(ClassicSheets, AreExactInEveryPixelWithOneSample) {
    const SmallPicture picture = takePicture(
        inClassic, sheet(1, .25, .5) + sheet(2, .5, .5) + sheet(3, .75, .5) + sheet(4, 3, 1), 1);
    expectEverywhere(picture.red, .25 / 2 + .5 / 4 + .75 / 8 + 3. / 8);
    expectEverywhere(picture.alpha, 1);
}

TEST(ClassicSheets, OfAnyNumberAreExact) {
    std::string world;
    double expected = 0, through = 1;
    for (int i = 0; i < 30; ++i, through *= .875) {
        world += sheet(1 + i, .01 * i, .125);
        expected += through * .125 * .01 * i;
    }
    const SmallPicture picture = takePicture(inClassic, world, 1);
    expectEverywhere(picture.red, expected);
    expectEverywhere(picture.alpha, 1 - through);
}

/// What 50 sheets show together: the sum of what each sends through those before it.
struct Stack {
    double opacity, distance;
    double color(int i) const { return .2 + .05 * (i % 7); }
    std::string rib() const {
        std::string world;
        for (int i = 49; i >= 0; --i) // The farthest first: order makes no difference.
            world += sheet(1 + distance * i, color(i), opacity);
        return world;
    }
    double red() const {
        double sum = 0, through = 1;
        for (int i = 0; i < 50; ++i, through *= 1 - opacity)
            sum += through * opacity * color(i);
        return sum;
    }
    double alpha() const { return 1 - std::pow(1 - opacity, 50); }
};

void expectOnAverage(const std::vector<float> &values, double expected, double most) {
    ASSERT_EQ(values.size(), 64u);
    const MeanAndError seen = meanAndError({values.begin(), values.end()});
    EXPECT_LE(seen.standardError, most * expected);
    EXPECT_NEAR(seen.mean, expected,
                studentQuantile(1e-5, 63) * seen.standardError + 1e-5 * expected);
}

// Nothing is chosen by chance that is worth a hundredth of the light.
TEST(Surfaces, AreFollowedAlongAllTheirEventsInEverySample) {
    const std::string room = "Surface \"constant\"\nColor [3 0 0]\n" + squareAt(-5) +
                             "Color [2 0 0]\n" + squareAt(4) + "Color [1 1 1]\n";
    const double reflectance = .04; // Of glass, looked at straight on.
    const struct {
        const char *surface;
        double expected;
    } cases[] = {
        {"Surface \"glass\" \"eta\" [1.5]\n", reflectance * 3 + (1 - reflectance) * 2},
        {"Opacity [.25 .25 .25]\nSurface \"glass\" \"eta\" [1.5]\n",
         .25 * (reflectance * 3 + (1 - reflectance) * 2) + .75 * 2},
        {"Color [.5 .5 .5]\nOpacity [.02 .02 .02]\nSurface \"constant\"\n", .02 * .5 + .98 * 2},
    };
    for (const std::string &integrator : {inClassic, inPath})
        for (const auto &[surface, expected] : cases) {
            SCOPED_TRACE(integrator + surface);
            expectEverywhere(takePicture(integrator, room + surface + squareAt(1), 1).red,
                             expected);
        }
}

// Paths that are followed to the end are exact; the rest is ended by roulette, which is fair.
TEST(Sheets, FiftyOfThemAddUpByBothIntegrators) {
    for (const std::string &integrator : {inClassic, inPath})
        for (double opacity : {.01, .1, .5, .9})
            for (double distance : {1e-4, .1}) {
                SCOPED_TRACE(integrator + std::to_string(opacity) + " " + std::to_string(distance));
                const Stack stack{opacity, distance};
                const SmallPicture picture = takePicture(integrator, stack.rib(), 64);
                expectOnAverage(picture.red, stack.red(), 2e-3);
                expectOnAverage(picture.alpha, stack.alpha(), 2e-3);
            }
}

// No number of surfaces ends a path that goes straight on.
TEST(Sheets, MoreThanAThousandThinOnesHideLittle) {
    std::string world = "Surface \"constant\"\nColor [2 0 0]\n" + squareAt(9, 5) +
                        "Color [0 0 0]\nOpacity [.0002 .0002 .0002]\n";
    for (int i = 0; i < 1500; ++i)
        world += squareAt(1 + .001 * i);
    for (const std::string &integrator : {inClassic, inPath}) {
        const SmallPicture picture = takePicture(integrator, world, 1);
        const double expected = 2 * std::pow(.9998, 1500), rounding = 1500 * 4 * 0x1p-24;
        for (float value : picture.red)
            EXPECT_NEAR(value, expected, rounding * expected);
    }
}

// Black surfaces of `constant` send nothing and are given no light samples: the sheets just above
// the floor would else be most likely to be chosen.
TEST(Sheets, BlackOnesTakeNoLightSamples) {
    std::string world = "LightSource \"pointlight\" 1 \"from\" [0 0 -50] \"intensity\" [7853.98]\n"
                        "Surface \"constant\"\nColor [0 0 0]\nOpacity [.002 .002 .002]\n";
    for (int i = 0; i < 200; ++i)
        world += squareAt(-2 - .001 * i);
    const SmallPicture picture = takePicture(
        inPath, world + "Opacity [1 1 1]\nColor [1 1 1]\nSurface \"matte\"\n" + squareAt(1), 1);
    const auto [darkest, brightest] = std::minmax_element(picture.red.begin(), picture.red.end());
    EXPECT_GT(*darkest, .98f * *brightest);
    EXPECT_NEAR(*brightest, std::pow(.998, 200) * 7853.98 / (51 * 51) / M_PI, .02);
}

// One surface between two media: F = .04 comes back, the rest goes on behind it.
TEST(ClassicGlass, FollowsReflectionAndRefractionBoth) {
    const std::string behindTheEye = "Surface \"constant\"\nColor [2 0 0]\n" + squareAt(-1, 5);
    const std::string wall = "Surface \"constant\"\nColor [1 0 0]\n" + squareAt(9, 5);
    const SmallPicture picture = takePicture(
        inClassic, behindTheEye + wall + "Color [1 1 1]\nSurface \"glass\"\n" + squareAt(3, 5), 1);
    expectEverywhere(picture.red, .04 * 2 + .96 * 1);
}

TEST(Opacity, BeyondOneIsOneAndBelowNoneIsNone) {
    for (const std::string &integrator : {inClassic, inPath}) {
        const std::string wall = sheet(4, 3, 1);
        SmallPicture hidden = takePicture(integrator, claiming(1.5) + squareAt(1) + wall, 1);
        expectEverywhere(hidden.red, 0);
        expectEverywhere(hidden.alpha, 1);
        SmallPicture clear = takePicture(integrator, claiming(-.5) + squareAt(1) + wall, 1);
        expectEverywhere(clear.red, 3);
        expectEverywhere(clear.alpha, 1);
        clear = takePicture(integrator, claiming(-.5) + squareAt(1), 1);
        expectEverywhere(clear.alpha, 0);
    }
}

// What the file claims is clamped before it colours anything: matte multiplies by Os.
TEST(Opacity, OfTheFileIsClampedBeforeItColours) {
    const std::string wall = "Surface \"constant\"\nColor [3 0 0]\nOpacity [1 1 1]\n" + squareAt(4);
    const std::string square = "Polygon \"P\" [-1 -1 1 1 -1 1 1 1 1 -1 1 1]";
    for (const std::string &integrator : {inClassic, inPath})
        for (auto [claimed, expected] : {std::pair{"2", .5}, {"-1", 3.}}) {
            const std::string values = std::string("[") + claimed + " " + claimed + " " + claimed;
            const std::string surface = "Surface \"constant\"\nColor [.5 0 0]\n";
            expectEverywhere(takePicture(integrator,
                                         surface + "Opacity " + values + "]\n" + squareAt(1) + wall,
                                         1)
                                 .red,
                             expected);
            expectEverywhere(
                takePicture(integrator,
                            surface + square + " \"constant color Os\" " + values + "]\n" + wall, 1)
                    .red,
                expected);
        }
}

// Intensity pi over distance 1 is E = pi, and a white wall then sends 1. The sheet stands where the
// eye does not look through it.
TEST(Opacity, OfWhatCastsAShadowIsWithinTheSameBounds) {
    for (const std::string &integrator : {inClassic, inPath})
        for (auto [opacity, expected] : {std::pair{1.5, 0.}, {-.5, 1.}, {1., 0.}, {0., 1.}}) {
            const std::string lamp = "Attribute \"light\" \"string shadows\" [\"on\"]\n"
                                     "LightSource \"pointlight\" 1 \"float intensity\" [314.15926]"
                                     " \"point from\" [0 0 -8]\n";
            const std::string wall = "Surface \"matte\"\nColor [1 1 1]\n" + squareAt(2);
            const SmallPicture picture =
                takePicture(integrator, lamp + claiming(opacity) + squareAt(-1) + wall, 1);
            ASSERT_EQ(picture.red.size(), 64u);
            for (float value : picture.red)
                EXPECT_NEAR(value, expected, 1e-3) << opacity;
        }
}

} // namespace
} // namespace candela::test
