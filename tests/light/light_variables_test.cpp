// SPDX-License-Identifier: Apache-2.0
// Lights that assign L, as files of the nineties do, and lights with output parameters.
#include "tests/light/pictures.h"

#include <cmath>
#include <gtest/gtest.h>

namespace candela::test {
namespace {

const std::string receiver = "Surface \"matte\"\nColor [1 1 1]\n" + squareAt(3);
const std::string classic = "Option \"render\" \"string integrator\" [\"classic\"]\n";
const std::string path = "Option \"render\" \"string integrator\" [\"path\"]\n";

/// The picture of a receiver that faces the eye.
SmallPicture litBy(const std::string &integrator, const std::string &lamp) {
    return takePicture(integrator, lamp + receiver, 1);
}

TEST(LightVariables, LWithoutIlluminateIsALightThere) {
    const std::string place = " \"intensity\" [9] \"point from\" [.05 0 1]\n";
    for (const std::string &integrator : {classic, path}) {
        const SmallPicture usual = litBy(integrator, "LightSource \"pointlight\" 1" + place);
        const SmallPicture own = litBy(integrator, "LightSource \"pointing\" 1" + place);
        ASSERT_EQ(usual.red.size(), own.red.size());
        for (size_t i = 0; i < own.red.size(); ++i)
            EXPECT_NEAR(own.red[i], usual.red[i], 1e-6 * usual.red[i]) << integrator << i;
        EXPECT_GT(usual.red[0], 1);
    }
}

/// From 60 degrees off the normal, wherever the lamp is.
TEST(LightVariables, ANewLIsWhatSurfacesSee) {
    for (const std::string &integrator : {classic, path})
        for (const char *distant : {"0", "1"})
            for (const char *before : {"", "Scale -1 1 1\n"}) {
                const SmallPicture picture =
                    litBy(integrator, "AttributeBegin\n" + std::string(before) +
                                          "LightSource \"bent\" 1 \"distant\" [" + distant +
                                          "] \"point from\" [9 9 -9] \"vector along\" "
                                          "[1.7320508 0 1]\nAttributeEnd\nIlluminate 1 1\n");
                for (float red : picture.red)
                    EXPECT_NEAR(red, .5, 1e-5) // Shadow rays start a little off the surface.
                        << integrator << distant << before;
            }
}

/// Each point that is lit has random numbers of its own, and each sample of a pixel.
TEST(LightVariables, RandomNumbersDiffer) {
    for (const std::string &integrator : {classic, path}) {
        const std::string lamp = "LightSource \"speckled\" 1\n";
        const SmallPicture once = takePicture(integrator, lamp + receiver, 1);
        const SmallPicture often = takePicture(integrator, lamp + receiver, 256);
        double mean = 0, apart = 0, meanOften = 0, apartOften = 0;
        for (std::size_t i = 0; i < 64; ++i) {
            mean += once.red[i] / 64, apart += std::fabs(once.red[i] - .5) / 64;
            meanOften += often.red[i] / 64, apartOften += std::fabs(often.red[i] - .5) / 64;
        }
        EXPECT_NEAR(mean, .5, .18) << integrator; // Five standard errors.
        EXPECT_NEAR(apart, .25, .09) << integrator;
        EXPECT_NEAR(meanOften, .5, .012) << integrator;
        EXPECT_LT(apartOften, .03) << integrator;
        EXPECT_GT(apartOften, .003) << integrator;
    }
}

/// What lights leave in their output parameters stays there: it is no light, and no direction.
TEST(LightVariables, OutputParametersChangeNothing) {
    struct Pair {
        const char *usual, *tagged, *rest;
    };
    const Pair pairs[] = {{"LightSource \"distantlight\"", "LightSource \"tagged_sun\"",
                           " 1 \"intensity\" [2] \"point from\" [-5 0 0] \"point to\" [0 0 3]\n"},
                          {"LightSource \"pointlight\"", "LightSource \"tagged_point\"",
                           " 1 \"intensity\" [9] \"point from\" [.05 0 1]\n"},
                          {"AttributeBegin AreaLightSource \"classic_lamp\"",
                           "AttributeBegin AreaLightSource \"tagged_lamp\"",
                           " 1 \"intensity\" [2]\n"
                           "Polygon \"P\" [-.1 -.1 -1 .1 -.1 -1 .1 .1 -1 -.1 .1 -1]\nAttributeEnd\n"
                           "Illuminate 1 1\n"}};
    const std::string units = "Option \"radiometry\" \"string units\" [\"classic\"]\n";
    for (const std::string &integrator : {classic, path})
        for (const Pair &pair : pairs) {
            const std::string rest = pair.rest;
            const SmallPicture usual = litBy(units + integrator, pair.usual + rest);
            const SmallPicture tagged = litBy(units + integrator, pair.tagged + rest);
            ASSERT_EQ(usual.red.size(), 64u);
            for (size_t i = 0; i < usual.red.size(); ++i)
                EXPECT_NEAR(tagged.red[i], usual.red[i], 1e-6 * usual.red[i]) << pair.tagged << i;
            EXPECT_GT(usual.red[0], .5) << pair.usual;
        }
}

} // namespace
} // namespace candela::test
