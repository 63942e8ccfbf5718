// SPDX-License-Identifier: Apache-2.0
// Light on its way to surfaces: volumes weaken it under `path`; the light of volumes themselves.
#include "foundation/base/student.h"
#include "tests/volumes/worlds.h"

#include <cmath>
#include <gtest/gtest.h>
#include <vector>

namespace candela::test {
namespace {

/// Fog without light of its own: e^-1 is left after 2.
const std::string dark = fogOf(2, 0);
const std::string matte = "Surface \"matte\" \"float Ka\" [0] \"float Kd\" [1]\n";

/// In si units a lamp at z before a matte wall at 3 gives this under parallel looks, near the axis.
double lit(double z) { return 4 / std::pow(3 - z, 2) / M_PI; }
std::string lamp(double z) {
    return "LightSource \"pointlight\" 1 \"intensity\" [4] \"from\" [0 0 " + text(z) + "]\n";
}
const std::string narrow = "ScreenWindow -.001 .001 -.001 .001\n";

TEST(LightThroughVolumes, IsWeakenedUnderPath) {
    const double eye = std::exp(-1.5); // The wall's own way.
    const auto left = [](double way) { return std::exp(-way / 2); };
    const std::string absorbing =
        "Interior \"absorption\" \"color transmittance\" [.5 .5 .5] \"float distance\" [.5]\n";
    const std::string clear = "Surface \"constant\"\nOpacity [0 0 0]\n";
    const std::string body = square(1, clear + absorbing) + square(2, clear + absorbing, true);
    const std::string wall = square(3, matte);
    const std::string inFog = "AttributeBegin\n" + dark + square(3, matte) + "AttributeEnd\n";
    expectEach(
        {
            {"fog", lamp(0) + inFog, eye * lit(0) * left(3), 1, By::Path, narrow},
            {"a near lamp", lamp(2) + inFog, eye * lit(2) * left(1), 1, By::Path, narrow},
            {"RI 3.1 knows surfaces alone", lamp(0) + inFog, eye * lit(0), 1, By::Classic, narrow},
            {"shadows of RI 3.1 neither",
             "Attribute \"light\" \"string shadows\" [\"on\"]\n" + lamp(0) + inFog, eye * lit(0), 1,
             By::Classic, narrow},
            {"a body: the eye looks through it, too", lamp(0) + body + wall, lit(0) / 16, 1,
             By::Path, narrow},
            {"a lamp in the body", lamp(1.5) + body + wall, lit(1.5) * .5 * .25, 1, By::Path,
             narrow},
            {"behind the body", lamp(2.5) + body + wall, lit(2.5) * .25, 1, By::Path, narrow},
            {"no weather before suns", "LightSource \"distantlight\" 1 \"intensity\" [2]\n" + inFog,
             eye * 2 / M_PI, 1, By::Path, narrow},
            {"a body before suns",
             "LightSource \"distantlight\" 1 \"intensity\" [2]\n" + body + wall, 2 / M_PI / 16, 1,
             By::Path, narrow},
            {"all is twice as large", "Scale 2 2 2\n" + lamp(0) + inFog,
             std::exp(-3.) * lit(0) / 4 * left(6), 1, By::Path, narrow},
        },
        2e-5);
}

/// Within the confidence that sixteen seeds give.
void expectMean(const World &world, const std::string &integrator, int samples) {
    const MeanAndError found = meanAndError(meansOf(world, integrator, 16, samples));
    EXPECT_NEAR(found.mean, world.red, found.standardError * studentQuantile(.0005, 15) + 1e-6)
        << world.name << ", " << integrator;
    EXPECT_LT(found.standardError, .004 * (1 + world.red)) << world.name;
}

/// A furnace: walls that shine, and air that swallows as much as it gives. Light samples, scattered
/// rays that find walls, and every segment agree.
TEST(LightThroughVolumes, FurnacesStayFurnaces) {
    const std::string air =
        "Atmosphere \"glow\" \"float distance\" [1.5] \"color light\" [1 1 1]\n";
    const std::string oven = "Surface \"constant\"\nSphere 5 -5 5 360\n";
    const std::string grey = "Surface \"paintedmatte\" \"float Kd\" [.6]\nTranslate 0 0 2\n";
    const std::string inside =
        "Interior \"glow\" \"float distance\" [.3] \"color light\" [1 1 1]\n";
    const std::string glass = "Surface \"glass\"\n";
    const std::string ball = "Translate 0 0 2\nSphere 1 -1 1 360\n";
    // A grey ball takes what the air around it gives; the air takes and gives where it is dark.
    const double grey1 = .6, way = std::exp(-1 / 1.5);
    for (const World &world :
         {World{"a grey ball", air + oven + grey + "Sphere 1 -1 1 360\n", way * grey1 + (1 - way),
                1, By::Path, narrow},
          World{"a glass ball with air in it", air + oven + glass + ball, 1},
          World{"a glass ball that glows", air + oven + glass + inside + ball, 1},
          World{"a glass ball that is clear", oven + glass + "Interior \"null\"\n" + ball, 1}})
        expectMean(world, "path", 16);
}

} // namespace
} // namespace candela::test
