// SPDX-License-Identifier: Apache-2.0
// `vcm`: a wall behind a pane of glass, lit by what shines from one place or direction, is found by
// merging alone; and small frames are no darker than large ones.
#include "tests/support/frames.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numeric>

namespace candela::test {
namespace {

struct Seen {
    std::string name, view, world;
    double value; ///< In the middle of the picture.
    double tolerance = .03;
};

void PrintTo(const Seen &seen, std::ostream *stream) { *stream << seen.name; }

const std::string pane = "AttributeBegin\nSurface \"glass\"\n"
                         "Polygon \"P\" [-1.2 -1.2 1  1.2 -1.2 1  1.2 1.2 1  -1.2 1.2 1]\n"
                         "ReverseOrientation\n"
                         "Polygon \"P\" [-1.2 -1.2 .9  1.2 -1.2 .9  1.2 1.2 .9  -1.2 1.2 .9]\n"
                         "AttributeEnd\n";
const std::string wall = "Surface \"matte\" \"Ka\" [0] \"Kd\" [.5]\n"
                         "Polygon \"P\" [-1 -1 0  1 -1 0  1 1 0  -1 1 0]\n";
const std::string above = "Projection \"orthographic\"\nRotate 180 1 0 0\nTranslate 0 0 -3\n";
const std::string sun = "LightSource \"distantlight\" 1 \"intensity\" [3.14159265] \"from\" "
                        "[0 0 1] \"to\" [0 0 0]\n";
/// What a pane lets through at right angles, reflections within it included, once down and once up.
/// The matte wall and the pane send light to and fro: a little more.
constexpr double through = .96 / 1.04;

const Seen all[] = {
    {"SunBehindPane", "Format 32 32 1\nScreenWindow -.3 .3 -.3 .3\n" + above, sun + pane + wall,
     .5 * through *through, .08},
    {"SunBehindPaneMirrored", "Format 32 32 1\nScreenWindow -.3 .3 -.3 .3\nScale -1 1 1\n" + above,
     sun + pane + wall, .5 * through *through, .08},
    {"InFurnace", "Format 16 16 1\nProjection \"perspective\" \"fov\" [90]\n",
     "Surface \"glowing\" \"radiance\" [1] \"Kd\" [.5]\nCylinder 2 -2 2 360\nDisk 2 2 360\n"
     "Disk -2 2 360\n",
     2, .02},
};

class Merged : public testing::TestWithParam<Seen> {};

TEST_P(Merged, IsWhatShines) {
    const Seen &seen = GetParam();
    const auto pictures = render(
        {{seen.name, "Option \"render\" \"string integrator\" \"vcm\"\n" + seen.view, seen.world}},
        {64, 1, "light_paths/shaders"});
    ASSERT_EQ(pictures.size(), 1u);
    const std::vector<float> &red = pictures[0].red;
    const double mean = std::accumulate(red.begin(), red.end(), 0.0) / double(red.size());
    EXPECT_NEAR(mean, seen.value, seen.tolerance * seen.value);
}

INSTANTIATE_TEST_SUITE_P(Vcm, Merged, testing::ValuesIn(all),
                         [](const auto &info) { return info.param.name; });

} // namespace
} // namespace candela::test
