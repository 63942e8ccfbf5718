// SPDX-License-Identifier: Apache-2.0
// Shadow rays reach as far as their lamps: what stands a tenth of a millimetre before one hides it.
#include "tests/light/pictures.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace candela::test {
namespace {

const std::string receiver = "Surface \"matte\"\nColor [1 1 1]\n" + squareAt(3);
/// Stands 3 m before the receiver, behind the eye.
const std::string screen = "Surface \"matte\"\nColor [0 0 0]\n" + squareAt(0, 2);
const std::string eyeBeyondTheScreen = "Clipping .5 1000\n";

std::string pointLamp(double z) {
    return "Attribute \"light\" \"string shadows\" [\"on\"]\nLightSource \"pointlight\" 1 \"float "
           "intensity\" [30] \"point from\" [0 0 " +
           std::to_string(z) + "]\n";
}

std::string areaLamp(double z) {
    return "AttributeBegin\nAttribute \"light\" \"string shadows\" [\"on\"]\n"
           "AreaLightSource \"arealight\" 1 \"float radiance\" [1000] \"float onesided\" [0]\n" +
           squareAt(z, .05) + "AttributeEnd\nIlluminate 1 1\n";
}

TEST(ShadowRays, LampsATenthOfAMillimetreBehindAPolygonDoNotShineThroughIt) {
    for (const std::string &integrator : {inClassic, inPath})
        for (const auto &lamp : {pointLamp, areaLamp}) {
            const std::string options = integrator + eyeBeyondTheScreen;
            const SmallPicture behind = takePicture(options, lamp(-1e-4) + screen + receiver, 4);
            ASSERT_EQ(behind.red.size(), 64u);
            EXPECT_EQ(*std::max_element(behind.red.begin(), behind.red.end()), 0);
            const SmallPicture before = takePicture(options, lamp(1e-4) + screen + receiver, 4);
            ASSERT_EQ(before.red.size(), 64u);
            EXPECT_GT(*std::min_element(before.red.begin(), before.red.end()), .3f);
        }
}

/// What casts no shadow is seen, and light passes as if it were not there, lamps of any size.
TEST(ShadowRays, PassWhatCastsNoShadow) {
    const std::string casts = "Attribute \"render\" \"string casts_shadows\" ";
    for (const std::string &integrator : {inClassic, inPath})
        for (const auto &lamp : {pointLamp, areaLamp})
            for (const char *object : {"", "ObjectBegin 1\n"}) {
                const std::string options = integrator + eyeBeyondTheScreen;
                const std::string placed =
                    *object ? object + screen +
                                  "ObjectEnd\nSurface \"matte\"\nColor 0 0 0\nObjectInstance 1\n"
                            : screen;
                const auto meanWith = [&](const std::string &before) {
                    const SmallPicture seen =
                        takePicture(options, lamp(-1) + before + receiver, 256);
                    double sum = 0;
                    for (float value : seen.red)
                        sum += value / 64;
                    return sum;
                };
                const double free = meanWith("");
                EXPECT_GT(free, .1);
                EXPECT_NEAR(meanWith(casts + "[\"none\"]\n" + placed), free, .01 * free);
                for (const char *other : {"[\"opaque\"]\n", "[\"Os\"]\n", "[\"shade\"]\n"})
                    EXPECT_EQ(meanWith(casts + other + placed), 0) << other;
            }
}

/// Opaque, whatever the shader says.
TEST(ShadowRays, EndAtWhatIsOpaqueToThem) {
    const std::string glass = "Opacity .25 .25 .25\n" + screen + "Opacity 1 1 1\n";
    const std::string options = inPath + eyeBeyondTheScreen;
    const std::string casts = "Attribute \"render\" \"string casts_shadows\" [\"opaque\"]\n";
    EXPECT_GT(takePicture(options, pointLamp(-1) + glass + receiver, 4).red[0], .1f);
    EXPECT_EQ(takePicture(options, pointLamp(-1) + casts + glass + receiver, 4).red[0], 0);
}

} // namespace
} // namespace candela::test
