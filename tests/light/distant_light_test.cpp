// SPDX-License-Identifier: Apache-2.0
// Light from one direction is the same whatever the scene's unit and however far away it lies:
// shadow rays start off the surface, but the direction that shaders hear does not know of it.
#include "tests/light/pictures.h"

#include <gtest/gtest.h>

namespace candela::test {
namespace {

struct Place {
    const char *name, *transform;
    double halfWidth; ///< Of what is lit, in the place's own unit.
    /// How long the light's direction is told: its ends are points, and so rounded where they are.
    double told = 1;
};

constexpr Place places[] = {
    {"Metres", "", 1},
    {"Kilometres", "Scale .001 .001 .001", 1000},
    {"Centimetres", "Scale 100 100 100", 1},
    {"Micrometres", "Scale 1e6 1e6 1e6", 1},
    {"Mirrored", "Scale -1e4 1e4 1e4", 1},
    {"OneKilometreOff", "Translate 0 0 1000", 1, 1e3},
    {"OneMegametreOff", "Translate 0 0 1e6", 1, 1e6},
};

class DistantLights : public testing::TestWithParam<Place> {};

/// Of irradiance pi at a cosine of .8.
TEST_P(DistantLights, AreTheSameEverywhere) {
    const Place &place = GetParam();
    const std::string sun = "LightSource \"distantlight\" 1 \"float intensity\" [3.14159265] "
                            "\"point from\" [" +
                            std::to_string(.6 * place.told) + " 0 " +
                            std::to_string(-.8 * place.told) + "] \"point to\" [0 0 0]\n";
    for (const std::string &integrator : {inPath, inClassic})
        for (const char *surface : {"matte", "toward_distant_light"}) {
            const SmallPicture picture =
                takePicture(integrator,
                            std::string(place.transform) + "\n" + sun + "Surface \"" + surface +
                                "\" Color [1 1 1]\n" + squareAt(3, place.halfWidth),
                            1);
            ASSERT_EQ(picture.red.size(), 64u);
            for (const float red : picture.red)
                EXPECT_NEAR(red, .8f, 4e-6f) << surface;
        }
}

INSTANTIATE_TEST_SUITE_P(All, DistantLights, testing::ValuesIn(places),
                         [](const auto &info) { return std::string(info.param.name); });

} // namespace
} // namespace candela::test
