// SPDX-License-Identifier: Apache-2.0
// A floor is looked at from nearby, and a mirror beside it, which is not in the picture, throws
// light there: next to none of the lamp's paths get into so small a view, and the picture of any
// seed has that light.
#include "tests/support/frames.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numeric>
#include <ostream>

namespace candela::test {
namespace {

struct CloseUp {
    std::string name;
    std::string light; ///< Shines on the mirror x = 1, which looks along -x.
    double direct;     ///< Irradiance over pi, in the middle.
    double mirrored;
    std::string space{}; ///< Before the view.
};

void PrintTo(const CloseUp &world, std::ostream *stream) { *stream << world.name; }

const std::string bulb =
    "LightSource \"pointlight\" 1 \"from\" [0 0 1] \"intensity\" [3.14159265]\n";
const std::string spot = "LightSource \"spotlight\" 1 \"from\" [0 0 1] \"to\" [1 0 .5] "
                         "\"intensity\" [3.14159265] \"coneangle\" [.3] \"conedeltaangle\" [0] "
                         "\"beamdistribution\" [0]\n";
const std::string sun = "LightSource \"distantlight\" 1 \"from\" [-1 0 1] \"to\" [0 0 0] "
                        "\"intensity\" [3.14159265]\n";

const CloseUp worlds[] = {
    {"Bulb", bulb, 1, .2 * std::sqrt(.2)},
    {"Spot", spot, 0, .2 * std::sqrt(.2)},
    {"Sun", sun, std::sqrt(.5), std::sqrt(.5)},
    {"BulbInMirroredSpace", bulb, 1, .2 * std::sqrt(.2), "Scale -1 1 1\n"},
};

Frame frameOf(const CloseUp &world, double window) {
    const std::string most = std::to_string(window), least = " -" + most + " ";
    return {world.name,
            "Option \"render\" \"string integrator\" \"bidir\"\nFormat 16 16 1\nScreenWindow" +
                least + most + least + most + "\nProjection \"orthographic\"\n" + world.space +
                "Rotate 180 1 0 0\nTranslate 0 0 -.5\n",
            world.light + "AttributeBegin\nSurface \"mirror\"\n"
                          "Polygon \"P\" [1 -5 0  1 5 0  1 5 5  1 -5 5]\nAttributeEnd\n"
                          "Surface \"matte\" \"Ka\" [0] \"Kd\" [.01]\n"
                          "Polygon \"P\" [-2 -5 0  1 -5 0  1 5 0  -2 5 0]\n"};
}

class CloseUps : public testing::TestWithParam<std::tuple<CloseUp, double>> {};

TEST_P(CloseUps, HaveTheMirrorsLightWhateverTheSeed) {
    const auto &[world, window] = GetParam();
    for (int seed = 1; seed <= 4; ++seed) {
        const auto pictures = render({frameOf(world, window)}, {64, seed, ""});
        ASSERT_EQ(pictures.size(), 1u);
        // Light that the floor sends by the mirror to the floor is little and rare, and found by
        // few: without the brightest pixels.
        std::vector<float> red = pictures[0].red;
        std::ranges::sort(red);
        red.resize(red.size() - 4);
        const double mean = std::accumulate(red.begin(), red.end(), 0.0) / double(red.size());
        EXPECT_NEAR((mean / .01 - world.direct) / world.mirrored, 1, .06) << "seed " << seed;
    }
}

std::string nameOf(const testing::TestParamInfo<std::tuple<CloseUp, double>> &info) {
    const auto &[world, window] = info.param;
    return world.name + (window < .02 ? "FromNearby" : "");
}

INSTANTIATE_TEST_SUITE_P(Bidir, CloseUps,
                         testing::Combine(testing::ValuesIn(worlds), testing::Values(.05, .01)),
                         nameOf);

} // namespace
} // namespace candela::test
