// SPDX-License-Identifier: Apache-2.0
// Tables of lighting engineering, derived anew: light off a lit square, a lamp in a cube.
#include "tests/probing/probing.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace candela::test {

namespace {

constexpr double pi = std::numbers::pi;
constexpr int places = 7;

/// A horizontal square of side `side` that sends light evenly; a wall along its edge, and a ceiling
/// 3 m above it. Configuration factors in % at points .5, 1, ... 3.5 m up the wall over the middle
/// of the edge, and as far from the edge on the ceiling.
struct LitSquare {
    double side;
    double wall[places], ceiling[places];
};

constexpr LitSquare squares[] = {
    {.5,
     {7.1093, 1.5347, .5214, .2317, .1216, .0714, .0453},
     {.8643, .7776, .6391, .4914, .3623, .2616, .1876}},
    {4,
     {40.3838, 31.7550, 24.6230, 19.0136, 14.7123, 11.4496, 8.9811},
     {28.9754, 32.6219, 34.9649, 35.7685, 34.9649, 32.6219, 28.9754}},
    {500,
     {49.9216, 49.8432, 49.7647, 49.6863, 49.6079, 49.5295, 49.4511},
     {58.2160, 65.8074, 72.3567, 77.7310, 82.0052, 85.3513, 87.9588}},
};

} // namespace

TEST(Tables, LightOffALitSquare) {
    for (const LitSquare &square : squares) {
        const std::string a = std::to_string(square.side), half = std::to_string(square.side / 2);
        const std::string shape = "Polygon \"P\" [0 -" + half + " 0  0 " + half + " 0  " + a + " " +
                                  half + " 0  " + a + " -" + half + " 0]\n";
        std::string points;
        for (int k = 1; k <= places; ++k)
            points += "0 0 " + std::to_string(.5 * k) + " 1 0 0\n";
        for (int k = 1; k <= places; ++k)
            points += std::to_string(.5 * k) + " 0 3 0 0 -1\n";
        const Probed probed = probe(siWorld(lamp(shape, 1, false)), points, {"--spp", "131072"});
        ASSERT_EQ(probed.answers.size(), 2u * places) << probed.run.text();
        for (int k = 0; k < places; ++k) {
            const double wall = square.wall[k], ceiling = square.ceiling[k];
            EXPECT_NEAR(100 * probed.answers[k].total / pi, wall, 2e-3 * wall + 5e-5)
                << "side " << square.side << ", wall " << k;
            EXPECT_NEAR(100 * probed.answers[places + k].total / pi, ceiling, 2e-3 * ceiling + 5e-5)
                << "side " << square.side << ", ceiling " << k;
        }
    }
}

namespace {

/// 4 m wide, 10,000 lm from its middle in all directions alike.
std::string cube(double reflectance) {
    const std::string rho = std::to_string(reflectance);
    std::string walls;
    for (const char *turn :
         {"0 1 0 0", "90 1 0 0", "180 1 0 0", "270 1 0 0", "90 0 1 0", "-90 0 1 0"})
        walls += "AttributeBegin\nRotate " + std::string(turn) +
                 "\nPolygon \"P\" [-2 -2 2  2 -2 2  2 2 2  -2 2 2]\nAttributeEnd\n";
    return siWorld("LightSource \"pointlight\" 1 \"from\" [0 0 0] \"intensity\" [" +
                   std::to_string(1e4 / (4 * pi * 179)) +
                   "]\nSurface \"matte\" \"Ka\" [0] \"Kd\" [" + rho + "]\n" + walls);
}

} // namespace

TEST(Tables, ALampInACubeLightsItsFloorDirectly) {
    const Probed probed =
        probe(cube(0), "0 0 -2 0 0 1\n1.9999 0 -2 0 0 1\n1.9999 1.9999 -2 0 0 1\n");
    ASSERT_EQ(probed.answers.size(), 3u) << probed.run.text();
    EXPECT_NEAR(probed.answers[0].photometric, 198.9437, 2e-3);
    EXPECT_NEAR(probed.answers[1].photometric, 70.3372, 7e-3);
    EXPECT_NEAR(probed.answers[2].photometric, 38.2867, 7e-3);
}

/// The mean over all walls is flux over area, over 1 - reflectance; all walls are alike.
TEST(Tables, ALampInACubeLightsItsWallsByManyReflections) {
    for (double reflectance : {.2, .5, .8}) {
        std::string points;
        constexpr int cells = 16;
        for (int k = 0; k < cells * cells; ++k)
            points += std::to_string((k % cells + .5) * 4 / cells - 2) + " " +
                      std::to_string((k / cells + .5) * 4 / cells - 2) + " -2 0 0 1\n";
        const Probed probed = probe(cube(reflectance), points, {"--spp", "256"});
        ASSERT_EQ(int(probed.answers.size()), cells * cells) << probed.run.text();
        double mean = 0;
        for (const Answer &answer : probed.answers)
            mean += answer.photometric / (cells * cells);
        const double expected = 104.166667 / (1 - reflectance);
        EXPECT_NEAR(mean, expected, 5e-3 * expected) << reflectance;
    }
}

} // namespace candela::test
