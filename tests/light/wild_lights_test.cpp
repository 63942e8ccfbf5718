// SPDX-License-Identifier: Apache-2.0
// A light whose answer is no number gives nothing, and takes nothing from the others.
#include "tests/light/pictures.h"

#include <gtest/gtest.h>
#include <numeric>

namespace candela::test {
namespace {

const std::string lamp = "AttributeBegin\nAreaLightSource \"arealight\" 1 \"radiance\" [4] "
                         "\"onesided\" [0]\nSurface \"matte\" \"Kd\" [0]\n"
                         "Polygon \"P\" [-.3 -.3 -1 .3 -.3 -1 .3 .3 -1 -.3 .3 -1]\nAttributeEnd\n"
                         "Illuminate 1 1\n";
const std::string receiver = "Surface \"matte\" \"Kd\" [1]\nColor [1 1 1]\n" + squareAt(1);

double meanOf(const std::string &integrator, const std::string &wild) {
    const SmallPicture picture = takePicture(integrator, lamp + wild + receiver, 64);
    EXPECT_EQ(picture.red.size(), 64u);
    return std::accumulate(picture.red.begin(), picture.red.end(), 0.0) / 64;
}

TEST(WildLights, LeaveTheOthersAsTheyAre) {
    const std::string surface = "AttributeBegin\nSurface \"wild\" \"number\" [";
    const std::string ball = "]\nTranslate 1 0 -1\nSphere .2 -.2 .2 360\nAttributeEnd\n";
    const std::string point = "LightSource \"wildlight\" 2 \"number\" [";
    const std::string place = "] \"from\" [.5 .5 -1]\n";
    for (const std::string &integrator : {inPath, inClassic}) {
        const double alone = meanOf(integrator, "");
        EXPECT_GT(alone, .05);
        for (const char *number : {"1", "-1", "0"}) // Infinities, and no number.
            for (const std::string &wild : {surface + number + ball, point + number + place,
                                            surface + number + ball + point + number + place})
                EXPECT_NEAR(meanOf(integrator, wild), alone, .04 * alone) << wild << integrator;
    }
}

} // namespace
} // namespace candela::test
