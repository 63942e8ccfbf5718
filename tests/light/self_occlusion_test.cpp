// SPDX-License-Identifier: Apache-2.0
// Under `classic` lamps cast no shadows by default, yet their own walls hide one another: the light
// of a lamp alone is that of `path`.
#include "foundation/base/student.h"
#include "tests/light/pictures.h"
#include "tests/support/frames.h"

#include <cmath>
#include <gtest/gtest.h>

namespace candela::test {
namespace {

struct Lamp {
    const char *name, *shape;
};

// The floor is at z = 1, the eye in front of it and behind it all else.
constexpr Lamp lamps[] = {
    {"Sphere", "Translate .3 0 0 Sphere .4 -.4 .4 360"},
    {"Ellipsoid", "Translate .3 0 0 Scale 1 .5 1.5 Sphere .4 -.4 .4 360"},
    {"OpenSphere", "Translate .3 0 0 Rotate 140 1 0 0 Sphere .4 -.4 .1 250"},
    {"Cylinder", "Rotate 90 0 1 0 Cylinder .2 -.5 .5 360"},
    {"HalfCylinder", "Rotate 90 0 1 0 Cylinder .2 -.5 .5 200"},
    {"Cone", "Rotate 30 0 1 0 Cone .8 .4 360"},
    {"Paraboloid", "Paraboloid .5 0 .6 360"},
    {"Hyperboloid", "Rotate 80 0 1 0 Hyperboloid .3 0 -.3 .1 .4 .5 360"},
    {"Torus", "Rotate 40 0 1 0 Torus .4 .15 0 360 360"},
    {"Disc", "Translate .2 0 0 Rotate 20 1 0 0 Disk 0 .5 360"},
    {"Square", "Polygon \"P\" [-.5 -.5 0 .5 -.5 0 .5 .5 .2 -.5 .5 .2]"},
    {"Box", "Rotate 30 1 2 3 PointsPolygons [4 4 4 4 4 4] [0 3 2 1 4 5 6 7 0 1 5 4 1 2 6 5 2 3 7 6 "
            "3 0 4 7] \"P\" [-.3 -.3 -.3 .3 -.3 -.3 .3 .3 -.3 -.3 .3 -.3 -.3 -.3 .3 .3 -.3 .3 .3 "
            ".3 .3 -.3 .3 .3]"},
    {"BentSheet", "Patch \"bicubic\" \"P\" [-.6 -.6 .4 -.2 -.6 -.6 .2 -.6 .6 .6 -.6 -.4 -.6 -.2 .4 "
                  "-.2 -.2 -.6 .2 -.2 .6 .6 -.2 -.4 -.6 .2 .4 -.2 .2 -.6 .2 .2 .6 .6 .2 -.4 -.6 "
                  ".6 .4 -.2 .6 -.6 .2 .6 .6 .6 .6 -.4]"},
    {"ClosedByAnother", "Sphere .4 -.4 0 360 Disk 0 .4 360"},
    {"TwoOfOneLight", "Cylinder .1 -.5 -.2 360 Translate 0 0 -.7 Disk 0 .5 360"},
};

class LampsAlone : public testing::TestWithParam<Lamp> {};

TEST_P(LampsAlone, GiveTheSameLightToClassicAndPath) {
    const std::string view = "Format 16 16 1\nProjection \"perspective\" \"fov\" [1]\n"
                             "Translate 0 0 -.9\n";
    const std::string floor = "Surface \"matte\"\n" + squareAt(1, 3);
    const std::string shape = std::string(GetParam().shape) + "\n";
    const std::string inTheWay =
        "AttributeBegin Surface \"matte\" Translate 0 0 .8\n" + squareAt(0, 3) + "AttributeEnd\n";
    std::vector<Frame> frames;
    for (const char *sides : {"0", "1"})
        for (bool instance : {false, true}) {
            const std::string lamp =
                std::string(instance ? "ObjectBegin 1\n" + shape + "ObjectEnd\n" : "") +
                "AttributeBegin\nAreaLightSource \"arealight\" 1 \"onesided\" [" + sides +
                "]\nSurface \"matte\" \"Kd\" [0]\n" +
                (instance ? "ObjectInstance 1\nTranslate 2 0 0\nObjectInstance 1\n" : shape) +
                "AttributeEnd\nIlluminate 1 1\n";
            const std::string name =
                std::string("onesided ") + sides + (instance ? ", placed" : "");
            frames.push_back({name, inPath + view, lamp + floor});
            frames.push_back({name, inClassic + view, lamp + floor});
            frames.push_back({name, inClassic + view, lamp + inTheWay + floor});
        }
    const auto pictures = render(frames, {64, 1, "light/shaders"});
    ASSERT_EQ(pictures.size(), frames.size());
    for (std::size_t i = 0; i < frames.size(); ++i) {
        if (i % 3 == 0)
            continue;
        const std::vector<float> &one = pictures[i - i % 3].red, &other = pictures[i].red;
        const MeanAndError path = meanAndError({one.begin(), one.end()});
        const MeanAndError classic = meanAndError({other.begin(), other.end()});
        const double error = std::hypot(path.standardError, classic.standardError);
        EXPECT_LE(error, .03 * path.mean + 1e-6) << frames[i].name;
        EXPECT_LE(std::fabs(path.mean - classic.mean),
                  studentQuantile(1e-5, 255) * error + 1e-4 * path.mean)
            << frames[i].name << ' ' << path.mean << ' ' << classic.mean;
    }
}

INSTANTIATE_TEST_SUITE_P(All, LampsAlone, testing::ValuesIn(lamps),
                         [](const auto &info) { return std::string(info.param.name); });

} // namespace
} // namespace candela::test
