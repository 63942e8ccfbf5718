// SPDX-License-Identifier: Apache-2.0
// What is within bodies, and outside of them: along rays that pass straight on, are sent on by
// trace() and refracted, in every orientation.
#include "foundation/base/student.h"
#include "tests/volumes/worlds.h"

#include <cmath>
#include <gtest/gtest.h>
#include <vector>

namespace candela::test {
namespace {

/// Half of the light is left after 1.
const std::string halving =
    "Interior \"absorption\" \"color transmittance\" [.5 .5 .5] \"float distance\" [1]\n";
const std::string quartering =
    "Interior \"absorption\" \"color transmittance\" [.25 .25 .25] \"float distance\" [1]\n";
const std::string clear = "Surface \"constant\"\nOpacity [0 0 0]\n";
const std::string pane = "Surface \"pane\"\n";

/// A body of faces at these places, whose sides are not looked at.
std::string slab(const std::string &words, double front, double back) {
    return square(front, words) + square(back, words, true);
}

TEST(Interior, ColoursByTheWayThroughTheBody) {
    const std::string wall = sheet(6, .8);
    // Under `path` roulette is played for what is traced.
    for (const auto &[surface, by] : {std::pair{clear, By::Both}, {pane, By::Classic}}) {
        const std::string body = slab(surface + halving, 1, 3);
        std::vector<World> worlds{
            {"a slab", body + wall, .8 * .25},
            {"two", body + slab(surface + quartering, 4, 5) + wall, .8 * .25 * .25},
            {"one in another",
             slab(surface + halving, 1, 5) + slab(surface + quartering, 2, 3) + wall,
             .8 * std::pow(.5, 3) * .25},
            {"two that overlap",
             slab(surface + halving, 1, 3) + slab(surface + quartering, 2, 4) + wall,
             // In both it is in the one that ends first.
             .8 * .5 * .5 * .25},
            {"a sheet within", body + square(2, surface) + wall, .8 * .25},
            {"a turned sheet within", body + square(2, surface, true) + wall, .8 * .25},
            {"something opaque within", body + sheet(2, .8), .8 * .5},
            {"the eye within", square(2, surface + halving, true) + wall, .8 * .25},
            {"none", slab(surface + "Interior \"null\"\n", 1, 3) + wall, .8},
            {"turned round twice", slab(surface + halving + "ReverseOrientation\n", 3, 1) + wall,
             .8 * .25},
            {"one-sided: it has no inside", square(1, surface + halving + "Sides 1\n") + wall, .8},
        };
        for (World &world : worlds)
            world.by = by;
        expectEach(worlds, 4e-6);
    }
}

TEST(Interior, IsInsideInEverySpace) {
    const std::string wall = sheet(6, .8), body = slab("", 1, 3);
    for (const std::string &surface : {clear, pane}) {
        const std::string words = surface + halving;
        const std::string object = "ObjectBegin 1\n" + body + "ObjectEnd\n";
        expectEach(
            {
                {"scaled", wall + words + "Scale 2 2 .5\n" + body, .8 * .5},
                {"mirrored", wall + words + "Scale -1 1 1\n" + body, .8 * .25},
                {"mirrored along the look", wall + words + "Translate 0 0 5\nScale 1 1 -1\n" + body,
                 .8 * .25},
                {"inside out", wall + words + "Orientation \"inside\"\n" + slab("", 3, 1),
                 .8 * .25},
                {"an object", wall + object + words + "ObjectInstance 1\n", .8 * .25},
                {"objects, one mirrored",
                 wall + object + words +
                     "AttributeBegin\nTranslate 5 0 0\nObjectInstance 1\n"
                     "AttributeEnd\nScale -1 1 .5\nObjectInstance 1\n",
                 .8 * .5},
            },
            4e-6);
    }
}

TEST(Interior, IsTheBallsChord) {
    // On the axis, through a ball that a wide look would see as a lens.
    const std::string narrow = "ScreenWindow -.001 .001 -.001 .001\n";
    const std::string ball = "Translate 0 0 3\nSphere 1 -1 1 360\nTranslate 0 0 -3\n";
    const std::string wall = sheet(6, .8);
    for (const std::string &surface : {clear, pane})
        expectEach({{"a ball", wall + surface + halving + ball, .8 * .25, 1, By::Both, narrow}},
                   4e-6);
}

/// VALIDATION D3, at every angle: the slab's transmittance for light without polarisation, and with
/// what is reflected within.
TEST(Interior, OfGlassIsColouredByTheTrueLength) {
    const double n = 1.52, kd = .0424739, thickness = .5;
    const double transmittance = std::exp(-kd);
    for (const double degrees : {0., 10., 20., 30., 40., 50., 60., 70.}) {
        const double angle = degrees * M_PI / 180, cosine = std::cos(angle);
        const double inside = std::sqrt(1 - std::pow(std::sin(angle) / n, 2));
        const double s = (cosine - n * inside) / (cosine + n * inside);
        const double p = (n * cosine - inside) / (n * cosine + inside);
        const double r = (s * s + p * p) / 2, t = std::exp(-kd / inside);
        const double through = (1 - r) * (1 - r) * t / (1 - r * r * t * t);
        const std::string words = "Surface \"glass\" \"float eta\" [1.52]\nInterior \"absorption\" "
                                  "\"color transmittance\" "
                                  "[" +
                                  text(transmittance) + " 1 1] \"float distance\" [" +
                                  text(thickness) + "]\n";
        const World world{"at " + text(degrees),
                          sheet(20, 1) + "Translate 0 0 5\nRotate " + text(degrees) +
                              " 1 0 0\nScale 3 3 1\n" + slab(words, 0, thickness),
                          through};
        const MeanAndError found = meanAndError(meansOf(world, "path", 16, 16));
        EXPECT_NEAR(found.mean, through, found.standardError * studentQuantile(.0005, 15) + 1e-5)
            << world.name;
        EXPECT_LT(found.standardError, .002 * through) << world.name;
    }
}

TEST(Exterior, StandsOutsideOfWhatTheRayLeaves) {
    const auto outside = [](double left) {
        return "Exterior \"absorption\" \"color transmittance\" [" + text(left) + " 1 1]\n";
    };
    // A mirror at 3 shows a sheet behind the eye, at -1, on a way of 4.
    const std::string behind = square(-1, "Surface \"constant\"\nColor [.8 0 0]\n");
    const std::string mirror = "Surface \"onemirror\"\n";
    expectEach(
        {
            {"off a mirror", behind + square(3, mirror + outside(.5)), .8 * std::pow(.5, 4)},
            {"not of what it comes to",
             square(-1, "Surface \"constant\"\nColor [.8 0 0]\n" + outside(.5)) + square(3, mirror),
             .8},
            {"air is of what it comes to",
             square(-1, "Surface \"constant\"\nColor [.8 0 0]\n" + fogOf(4, 0)) + square(3, mirror),
             .8 * std::exp(-1.)},
            {"the outside is before the air",
             square(-1, "Surface \"constant\"\nColor [.8 0 0]\n" + fogOf(4, 0)) +
                 square(3, mirror + outside(.5)),
             .8 * std::pow(.5, 4)},
            {"before the eye is air",
             square(3, "Surface \"constant\"\nColor [.8 0 0]\n" + fogOf(3, 0) + outside(.5)),
             .8 * std::exp(-1.)},
        },
        4e-6);
}

} // namespace
} // namespace candela::test
