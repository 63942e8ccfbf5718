// SPDX-License-Identifier: Apache-2.0
// Light that paths from lights alone can find, and so little of it that pilots seldom see any: it
// is in the pictures of all seeds, whatever techniques are taken.
#include "tests/support/frames.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numeric>

namespace candela::test {
namespace {

struct SeldomSeen {
    std::string name;
    std::string light;               ///< Of 1 W/sr, W/m^2, or what the space asks for.
    std::string sender;              ///< What throws the caustic on the floor.
    std::string space{};             ///< Before the view.
    std::string toWorld{}, toView{}; ///< Where the world is, and the view follows.
    int window = 2;                  ///< Half the side of what is seen.
};

void PrintTo(const SeldomSeen &world, std::ostream *stream) { *stream << world.name; }

const std::string bulb = "LightSource \"pointlight\" 1 \"from\" [0 0 1]\n";
const std::string mirror = "Polygon \"P\" [1.5 -.05 .45  1.5 .05 .45  1.5 .05 .55  1.5 -.05 .55]\n";
const std::string beads = "Surface \"glass\"\nTranslate .8 .1 .4\nSphere .04 -.04 .04 360\n";

std::vector<SeldomSeen> worlds() {
    const std::string shining = "Surface \"mirror\"\n" + mirror;
    return {
        {"Bulb", bulb, shining},
        {"Spot",
         "LightSource \"spotlight\" 1 \"from\" [0 0 1] \"to\" [1.5 0 .5] \"coneangle\" [.4]\n",
         shining},
        {"Sun", "LightSource \"distantlight\" 1 \"from\" [-1 0 1] \"to\" [0 0 0]\n", shining},
        {"Two",
         bulb +
             "LightSource \"distantlight\" 2 \"intensity\" [.2] \"from\" [-1 0 1] \"to\" [0 0 0]\n",
         shining},
        {"Instance", bulb,
         "Surface \"mirror\"\nObjectBegin 1\n" + mirror + "ObjectEnd\nObjectInstance 1\n"},
        {"Handed", bulb, shining, "Scale -1 1 1\n"},
        {"OneSided", bulb, "Sides 1\nReverseOrientation\n" + shining},
        {"Far", bulb, shining, "", "Translate 300 0 0\n", "Translate -300 0 0\n"},
        {"Huge", "LightSource \"pointlight\" 1 \"from\" [0 0 1] \"intensity\" [1e4]\n", shining,
         "Scale 100 100 100\n", "", "", 200},
        {"Bead", bulb, beads},
        {"UnderALamp",
         bulb + "AttributeBegin\nAreaLightSource \"arealight\" 2 \"radiance\" [5]\n"
                "Surface \"constant\"\nColor [0 0 0]\nTranslate -.5 0 1.5\nReverseOrientation\n"
                "Disk 0 .2 360\nAttributeEnd\nIlluminate 2 1\n",
         shining},
    };
}

Frame frameOf(const SeldomSeen &world, const std::string &options) {
    const std::string most = std::to_string(world.window), least = " -" + most + " ";
    return {world.name,
            options + "Format 32 32 1\nScreenWindow" + least + most + least + most +
                "\nProjection \"orthographic\"\n" + world.space +
                "Rotate 180 1 0 0\nTranslate 0 0 -3\n" + world.toView,
            world.toWorld + world.light + "AttributeBegin\n" + world.sender +
                "AttributeEnd\nSurface \"matte\" \"Ka\" [0] \"Kd\" [.5]\n"
                "Polygon \"P\" [-2 -2 0  1.4 -2 0  1.4 2 0  -2 2 0]\n"};
}

double meanOf(const FramePixels &pixels) {
    return std::accumulate(pixels.red.begin(), pixels.red.end(), 0.0) / double(pixels.red.size());
}

class SeldomSeenLight : public testing::TestWithParam<SeldomSeen> {};

TEST_P(SeldomSeenLight, IsInThePicturesOfAllSeeds) {
    const std::string path = "Option \"render\" \"string integrator\" \"path\"\n";
    const std::string both = "Option \"render\" \"string integrator\" \"bidir\"\n";
    const std::string told = both + "Option \"bidir\" \"float lightpaths\" [32]\n";
    const auto render = [&](const std::string &options, int samples, int seed) {
        const auto pictures = test::render({frameOf(GetParam(), options)}, {samples, seed, ""});
        return pictures.size() == 1 ? meanOf(pictures[0]) : NAN;
    };
    constexpr int seeds = 6;
    const double direct = render(path, 64, 100);
    const double caustic = render(told, 64, 100) - direct;
    ASSERT_GT(caustic, 0);
    std::vector<double> found;
    for (int seed = 1; seed <= seeds; ++seed) {
        // The same camera samples or others: direct light has little noise.
        found.push_back(render(both, 64, seed) - direct);
        EXPECT_GT(found.back(), caustic / 4) << "seed " << seed;
    }
    const MeanAndError mean = meanAndError(found);
    EXPECT_NEAR(mean.mean, caustic, 5 * mean.standardError + .03 * caustic);
}

INSTANTIATE_TEST_SUITE_P(Bidir, SeldomSeenLight, testing::ValuesIn(worlds()),
                         [](const auto &info) { return info.param.name; });

} // namespace
} // namespace candela::test
