// SPDX-License-Identifier: Apache-2.0
// Volumes that ask for light where they like: single scattering against integrals.
#include "foundation/base/student.h"
#include "tests/volumes/worlds.h"

#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <vector>

namespace candela::test {
namespace {

const std::string narrow = "ScreenWindow -1e-5 1e-5 -1e-5 1e-5\n";
const std::string black = "Surface \"constant\"\nColor [0 0 0]\n";
/// In RI's own units, whatever the integrator.
const std::string classicUnits = "Attribute \"light\" \"string units\" [\"classic\"]\n";

std::string air(const std::string &shader, const std::string &words = "") {
    return "Atmosphere \"" + shader + "\" " + words + "\n" + black;
}

TEST(LitVolumes, HearEveryKindOfLight) {
    const std::string point = "LightSource \"pointlight\" 1 \"from\" [0 0 -1] \"intensity\" [1]\n";
    const std::string distant = "LightSource \"distantlight\" 2 \"intensity\" [.5]\n";
    const std::string named = "LightSource \"pointlight\" 3 \"from\" [0 0 0] \"intensity\" [1] "
                              "\"string __category\" [\"fog\"]\n";
    const std::string wall = square(1);
    expectEach(
        {
            {"a point light", classicUnits + point + air("lamplit") + wall, .25, 1, By::Both,
             narrow},
            {"and a distant one", classicUnits + point + distant + air("lamplit") + wall, .75, 1,
             By::Both, narrow},
            {"in si units", point + distant + air("lamplit") + wall, .75 / M_PI, 1, By::Both,
             narrow},
            {"one that is off for what is seen",
             classicUnits + point + distant + air("lamplit") + "Illuminate 2 0\n" + wall, .25, 1,
             By::Both, narrow},
            {"of a category",
             classicUnits + point + named + air("lamplit", "\"string category\" [\"fog\"]") + wall,
             1, 1, By::Both, narrow},
            {"of all but one",
             classicUnits + point + named + air("lamplit", "\"string category\" [\"-fog\"]") + wall,
             .25, 1, By::Both, narrow},
            {"another where it is light", classicUnits + distant + air("startled") + wall, 1.5, 1,
             By::Both, narrow},
            {"beside what is there", classicUnits + distant + air("lamplit") + sheet(1, .25), .75,
             1, By::Classic, narrow},
            {"and lit by it, too", classicUnits + distant + air("lamplit") + sheet(1, .25), 1.25, 1,
             By::Path, narrow},
            {"in an object",
             classicUnits + distant + "ObjectBegin 1\n" + square(0) + "ObjectEnd\n" +
                 air("lamplit") + "Translate 0 0 1\nScale -1 1 2\nObjectInstance 1\n",
             .5, 1, By::Both, narrow},
            {"in a body, and the light comes to its end",
             classicUnits + distant +
                 "Surface \"constant\"\nOpacity [0 0 0]\nColor [0 0 0]\n"
                 "Interior \"lamplit\"\n" +
                 square(1) + square(2, "", true),
             .5, 0, By::Both, narrow},
        },
        2e-5);
}

/// What ends the segment does not hide the light from its last point.
TEST(LitVolumes, AreLitUpToTheSurface) {
    const std::string lit = classicUnits + "LightSource \"distantlight\" 1 \"to\" [0 .2 1]\n";
    const std::string view = "ScreenWindow -.3 .3 -.3 .3\n";
    const char *shapes[][2] = {
        {"a sphere", "Translate 0 0 2\nSphere .5 -.5 .5 360\n"},
        {"an ellipsoid", "Translate 0 0 2\nScale 1 1.01 1\nSphere .5 -.5 .5 360\n"},
        {"one-sided", "Translate 0 0 2\nSides 1\nSphere .5 -.5 .5 360\n"},
        {"far away", "Translate 0 0 2000\nSphere .5 -.5 .5 360\n"},
        {"a slanting wall", "Translate 0 0 2\nRotate 40 1 2 0\n"
                            "Patch \"bilinear\" \"P\" [-2 -2 0 2 -2 0 -2 2 0 2 2 0]\n"}};
    std::vector<World> worlds;
    for (const auto &[name, shape] : shapes)
        for (const char *back : {"0", "1e-9", "1e-3"})
            worlds.push_back(
                {std::string(name) + ", " + back + " before it",
                 lit + air("at_the_end", "\"back\" [" + std::string(back) + "]") + shape, 1, 1,
                 By::Both, view});
    expectEach(worlds, 1e-6);
}

double integral(double from, double to, const std::function<double(double)> &f) {
    constexpr int steps = 20000;
    double sum = 0;
    for (int k = 0; k < steps; ++k)
        sum += f(from + (k + .5) / steps * (to - from));
    return sum * (to - from) / steps;
}

TEST(LitVolumes, ScatterOnceAsIntegralsSay) {
    const std::string march = "\"float scattering\" [.4] \"float absorption\" [.1] \"float steps\" "
                              "[192]";
    const std::string sun = classicUnits + "LightSource \"distantlight\" 2 \"intensity\" [2]\n";
    // A lamp beside the ray at height 1, z = 1.
    const std::string beside = "LightSource \"pointlight\" 1 \"from\" [0 1 1] \"intensity\" [5]\n";
    const auto strength = [](double z) { return 5 / (4 * M_PI * (1 + (z - 1) * (z - 1))); };
    const auto way = [](double z) { return std::sqrt(1 + (z - 1) * (z - 1)); };
    // Between the lamp and what lies beyond z = 1 from y = .5 on; the square's shadow begins there.
    const std::string blind = "Surface \"constant\"\nColor [0 0 0]\nPolygon \"P\" [-1 .5 1  1 .5 1 "
                              "1 .5 3  -1 .5 3]\n";
    const std::string wall = square(3);
    expectEach(
        {
            {"of a sun", sun + air("march", march) + wall,
             .5 * .4 * integral(0, 3, [](double z) { return std::exp(-.5 * z); }), 1, By::Both,
             narrow},
            {"of a lamp, through clear air", beside + air("march", march) + wall,
             .4 * integral(0, 3, [&](double z) { return strength(z) * std::exp(-.5 * z); }), 1,
             By::Classic, narrow},
            {"of a lamp, through the same air", beside + air("march", march) + wall,
             .4 * integral(0, 3,
                           [&](double z) { return strength(z) * std::exp(-.5 * (z + way(z))); }),
             1, By::Path, narrow},
            {"and there is shadow", beside + blind + air("march", march) + wall,
             .4 * integral(0, 1,
                           [&](double z) { return strength(z) * std::exp(-.5 * (z + way(z))); }),
             1, By::Path, narrow},
            {"which lamps of RI 3.1 do not cast", beside + blind + air("march", march) + wall,
             .4 * integral(0, 3, [&](double z) { return strength(z) * std::exp(-.5 * z); }), 1,
             By::Classic, narrow},
            {"unless they are told to",
             "Attribute \"light\" \"string shadows\" [\"on\"]\n" + beside + blind +
                 air("march", march) + wall,
             .4 * integral(0, 1, [&](double z) { return strength(z) * std::exp(-.5 * z); }), 1,
             By::Classic, narrow},
            {"in a room that is twice as large",
             "Scale 2 2 2\n" + beside + air("march", march) + wall,
             .4 * integral(0, 6, [&](double z) { return strength(z / 2) / 4 * std::exp(-.5 * z); }),
             1, By::Classic, narrow},
        },
        2e-4);
}

/// The library's haze, whose points are drawn: means within confidence.
TEST(LitVolumes, TheLibrarysHazeKeepsToItsUnits) {
    const std::string words =
        "\"color scattering\" [.4 .4 .4] \"color absorption\" [.1 .1 .1] \"float anisotropy\" [.5]";
    const std::string beside = "LightSource \"pointlight\" 1 \"from\" [0 1 1] \"intensity\" [5]\n";
    const auto scattered = [](double z, bool weakened) {
        const double squared = 1 + (z - 1) * (z - 1), way = std::sqrt(squared);
        const double cosine = (1 - z) / way; // Of the turn from the lamp's light to the eye.
        const double phase = .75 / std::pow(1.25 - cosine, 1.5) / (4 * M_PI);
        return .4 * 5 / squared * phase * std::exp(-.5 * (z + (weakened ? way : 0)));
    };
    for (const bool path : {false, true}) {
        const double expected = integral(0, 3, [&](double z) { return scattered(z, path); });
        const World world{"haze", beside + air("haze", words) + square(3), expected, 1, By::Both,
                          narrow};
        const MeanAndError found = meanAndError(meansOf(world, path ? "path" : "classic", 16, 16));
        EXPECT_NEAR(found.mean, expected, found.standardError * studentQuantile(.0005, 15) + 1e-5);
        EXPECT_LT(found.standardError, .004 * expected);
    }
}

/// A lamp with a surface is sampled, its shadow within the haze too.
TEST(LitVolumes, HearAreaLights) {
    const std::string lamp = "AttributeBegin\nAreaLightSource \"arealight\" 1 \"radiance\" [20]\n"
                             "Surface \"constant\"\nColor [0 0 0]\n"
                             "Polygon \"P\" [-.05 1 .95  .05 1 .95  .05 1 1.05  -.05 1 1.05]\n"
                             "AttributeEnd\nIlluminate 1 1\n";
    const std::string march = "\"float scattering\" [.4] \"float absorption\" [.1] \"float steps\" "
                              "[32]";
    // Small and far enough to be a point: .01 m^2 of radiance 20, by the cosine at the lamp.
    const auto strength = [](double z) {
        const double squared = 1 + (z - 1) * (z - 1);
        return 20 * .01 / (4 * M_PI) * std::pow(squared, -1.5);
    };
    for (const bool path : {false, true}) {
        const double expected = .4 * integral(0, 3, [&](double z) {
                                    const double way = std::sqrt(1 + (z - 1) * (z - 1));
                                    return strength(z) * std::exp(-.5 * (z + (path ? way : 0)));
                                });
        const World world{"area", air("march", march) + lamp + square(3), expected, 1, By::Both,
                          narrow};
        const MeanAndError found = meanAndError(meansOf(world, path ? "path" : "classic", 16, 16));
        EXPECT_NEAR(found.mean, expected,
                    found.standardError * studentQuantile(.0005, 15) + 2e-3 * expected);
    }
}

} // namespace
} // namespace candela::test
