// SPDX-License-Identifier: Apache-2.0
// Atmospheres on the way to the eye, against what their formulas say.
#include "tests/volumes/worlds.h"

#include <cmath>
#include <gtest/gtest.h>

namespace candela::test {
namespace {

const double half = std::exp(-.5), whole = std::exp(-1.); ///< Of a fog of distance 2, at 1 and 2.

std::string veilOf(double distance, double background) {
    return "Atmosphere \"veil\" \"float distance\" [" + text(distance) +
           "] \"color background\" [" + text(background) + " 0 0]\n";
}

TEST(Atmosphere, StandsBetweenTheEyeAndWhatIsSeen) {
    const std::string fog = fogOf(2, .25), veil = veilOf(2, .25);
    const double behind = half * .5 + (1 - half) * .25; // The wall at 2 from a sheet at 1.
    const double through = .5 * .4 + .5 * behind;       // What a sheet at 1 makes of it.
    const std::string wall = sheet(2, .5), pane = sheet(1, .4, .5), air = sheet(1, 1, 0);
    expectEach(
        {
            {"a wall", fog + wall, whole * .5 + (1 - whole) * .25},
            {"a wall behind a sheet", fog + pane + wall, half * through + (1 - half) * .25},
            {"a sheet alone hides as much more", fog + pane, half * .2 + (1 - half) * .25,
             1 - .5 * half},
            {"what is not there changes nothing", fog + air + wall, whole * .5 + (1 - whole) * .25},
            {"a fog that hides nothing", veil + wall, whole * .5 + (1 - whole) * .25},
            {"it is before what is there alone", veil + pane, half * .2 + (1 - half) * .5 * .25,
             .5},
            {"before all that shines through", veil + pane + wall,
             half * through + (1 - half) * .25},
            {"also through what is not there", veil + air + wall, whole * .5 + (1 - whole) * .25},
            {"behind so much fog that nothing of the sheet is left, the wall still hides",
             veilOf(.01, .25) + pane + wall, .25},
            {"the atmosphere of what is seen", fog + sheet(3, 1) + "Atmosphere \"null\"\n" + wall,
             .5},
            {"none where nothing is", fog, 0, 0},
            {"not of others", "AttributeBegin\n" + fog + sheet(3, 1) + "AttributeEnd\n" + wall, .5},
            {"each its own", sheet(1, .5, .5) + fog + wall,
             .25 + .5 * (half * .5 + (1 - half) * .25)},
        },
        2e-6);
}

TEST(Atmosphere, IsTheSameInEverySpace) {
    const std::string fog = fogOf(2, .25);
    const double expected = whole * .5 + (1 - whole) * .25, far = std::exp(-1.);
    const std::string object =
        "ObjectBegin 1\n" + square(1) + "ObjectEnd\nSurface \"constant\"\nColor [.5 0 0]\n";
    expectEach(
        {
            {"scaled", fog + "Scale 2 2 2\n" + sheet(1, .5), expected},
            {"mirrored", fog + "Scale -2 2 2\n" + sheet(1, .5), expected},
            {"seen from behind", fog + "Translate 0 0 4\nScale 1 1 -1\n" + sheet(2, .5), expected},
            {"one-sided", fog + "Sides 1\n" + sheet(2, .5), expected},
            {"an object", fog + object + "Translate 0 0 1\nObjectInstance 1\n", expected},
            {"an object twice",
             fog + object +
                 "Translate 0 0 1\nObjectInstance 1\nTranslate 0 0 3\nScale -3 2 1\n"
                 "ObjectInstance 1\n",
             expected},
            {"far away", fogOf(1e5, .25) + "Translate 0 0 1e5\nScale 1e3 1e3 1\n" + sheet(0, .5),
             far * .5 + (1 - far) * .25},
        },
        3e-6);
}

TEST(Atmosphere, KnowsWhatItsVariablesMean) {
    const auto facts = [](int which) {
        return "Translate 0 0 1\nAtmosphere \"facts\" \"float which\" [" + text(which) +
               "]\nTranslate 0 0 -1\n";
    };
    const std::string wall = square(2, "Surface \"constant\"\nColor [.5 0 0]\n");
    const std::string marked =
        "Polygon \"P\" [-1 -1 2 -1 1 2 1 1 2 1 -1 2] \"s\" [.75 .75 .75 .75]\n";
    const std::string moved = square(-1, "Translate 0 0 3\nSurface \"constant\"\nColor [.5 0 0]\n");
    expectEach(
        {
            {"P", facts(0) + wall, 2. / 8},
            {"I from the eye", facts(1) + wall, 2. / 8},
            {"N", facts(2) + wall, 1. / 8},
            {"Cs", facts(3) + wall, .5 / 8},
            {"s", facts(4) + "Surface \"constant\"\n" + marked, .75 / 8},
            {"Oi", facts(5) + wall, 1. / 8},
            {"P in shader space", facts(6) + wall, 1. / 8},
            {"E", facts(7) + wall, 2. / 8, 1, By::Both, "ScreenWindow -.001 .001 -.001 .001\n"},
            {"P in object space", facts(8) + moved, -1. / 8},
        },
        4e-6);
}

TEST(Atmosphere, DepthCuesGoByDepth) {
    const auto cue = [](double least, double most) {
        return "Atmosphere \"depthcue\" \"float mindistance\" [" + text(least) +
               "] \"float maxdistance\" [" + text(most) + "] \"color background\" [.25 0 0]\n";
    };
    const std::string planes = "Clipping 1 5\n"; // A wall at 2 has the depth .25.
    expectEach(
        {
            {"a quarter", cue(0, 1) + sheet(2, .5), .75 * .5 + .25 * .25, 1, By::Both, planes},
            {"not yet", cue(.25, 1) + sheet(2, .5), .5, 1, By::Both, planes},
            {"gone", cue(.1, .2) + sheet(2, .5), .25, 1, By::Both, planes},
        },
        2e-6);
}

} // namespace
} // namespace candela::test
