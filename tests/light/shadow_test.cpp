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

} // namespace
} // namespace candela::test
