// SPDX-License-Identifier: Apache-2.0
// A lamp under what shines from far and wide, of any form: together they are no noisier than the
// two by themselves, each beside the other's body.
#include "foundation/base/student.h"
#include "tests/support/frames.h"

#include <cmath>
#include <gtest/gtest.h>

namespace candela::test {
namespace {

struct Wide {
    const char *name, *shape;
};

// The floor is at z = 3, seen from above, which is -z.
constexpr Wide wideLights[] = {
    {"Sphere", "Sphere 500 -500 500 360"},
    {"SphereOfRoundedMatrix", "ConcatTransform [.958 .287 0 0 -.287 .958 0 0 0 0 1 0 0 0 0 1]\n"
                              "Sphere 500 -500 500 360"},
    {"SphereSeamed", "Sphere 500 -500 500 359.9"},
    {"TwoSpheres", "Sphere 500 -500 500 360 Sphere 400 -400 400 360"},
    {"Hemisphere", "Translate 0 0 4 Sphere 500 -500 0 360"},
    {"TwoHemispheres", "Sphere 500 -500 0 360 Sphere 500 0 500 360"},
    {"Ellipsoid", "Scale 1 1 .5 Sphere 500 -500 500 360"},
    {"Box", "PointsPolygons [4 4 4 4 4 4] [0 3 2 1 4 5 6 7 0 1 5 4 1 2 6 5 2 3 7 6 3 0 4 7] \"P\" "
            "[-400 -400 -400 400 -400 -400 400 400 -400 -400 400 -400 -400 -400 400 400 -400 400 "
            "400 400 400 -400 400 400]"},
    {"CeilingOfOneKilometre",
     "Polygon \"P\" [-500 -500 -100 500 -500 -100 500 500 -100 -500 500 -100]"},
    {"RoundCeiling", "Disk -100 500 360"},
    {"SmallCeiling", "Polygon \"P\" [-80 -80 -100 80 -80 -100 80 80 -100 -80 80 -100]"},
    {"Tent", "Translate 0 0 5 Rotate 180 1 0 0 Cone 900 600 360"},
    {"Hall", "Translate 0 0 4 Cylinder 300 -200 0 360 Disk -200 300 360"},
};

constexpr Wide lamps[] = {
    {"Disc", "Translate 1 0 -1 Disk 0 .3 360"},
    {"Egg", "Translate 1 0 -1 Scale 1 1 2 Sphere .2 -.2 .2 360"},
    {"Far", "Translate 20 0 -30 Disk 0 2 360"},
};

/// The body alone, black: what it keeps from others differs from pixel to pixel, too.
std::string unlit(const Wide &light) {
    return std::string("AttributeBegin\nSurface \"matte\" \"Kd\" [0]\n") + light.shape +
           "\nAttributeEnd\n";
}

std::string lit(int number, const Wide &light, const std::string &radiance) {
    const std::string name = std::to_string(number);
    return "AttributeBegin\nAreaLightSource \"arealight\" " + name + " \"radiance\" [" + radiance +
           "] \"onesided\" [0]\nSurface \"matte\" \"Kd\" [0]\n" + light.shape +
           "\nAttributeEnd\nIlluminate " + name + " 1\n";
}

double varianceOf(const FramePixels &pixels) {
    const MeanAndError mean = meanAndError({pixels.red.begin(), pixels.red.end()});
    return mean.standardError * mean.standardError * double(pixels.red.size());
}

/// Ball lamps that the eye is in: they surround nothing that they light.
constexpr Wide ballsAroundTheEye[] = {
    {"Ball", "Sphere .05 -.05 .05 360"},
    {"Scaled", "Scale .01 .01 .01 Sphere 5 -5 5 360"},
    {"Mirrored", "Scale -1 1 1 Translate .02 0 0 Sphere .05 -.05 .05 360"},
    {"OneSide", "Sides 1 Sphere .05 -.05 .05 360"},
    {"Large", "Translate 0 0 -4 Sphere 5 -5 5 360"},
};

TEST(BallsAroundTheEye, LightFloorsAsSeenFromElsewhere) {
    const std::string camera = "Format 32 32 1\nProjection \"perspective\" \"fov\" [.5]\n";
    const std::string sun = "LightSource \"distantlight\" 2 \"intensity\" [.001]\n";
    std::vector<Frame> frames;
    for (const Wide &ball : ballsAroundTheEye)
        for (const std::string &beside : {std::string(), sun})
            for (const char *floor :
                 {"Surface \"matte\" \"Kd\" [.7]\n", "Surface \"plastic\" \"roughness\" [.3]\n"})
                for (const char *eye : {"", "Translate 0 0 -2\n"}) {
                    const std::string unseen =
                        std::string("Attribute \"visibility\" \"int camera\" [0]\n") + ball.shape;
                    frames.push_back({ball.name + (" over " + std::string(floor)), camera + eye,
                                      lit(1, {ball.name, unseen.c_str()}, "12") + beside + floor +
                                          "Polygon \"P\" [-20 -20 3 -20 20 3 20 20 3 20 -20 3]\n"});
                }
    const auto pictures = render(frames, {16, 1, "light/shaders"});
    ASSERT_EQ(pictures.size(), frames.size());
    for (std::size_t i = 0; i < frames.size(); i += 2) {
        const RedComparison both = compareRed(pictures[i], pictures[i + 1]);
        EXPECT_GT(both.mean, 1e-4) << frames[i].name;
        EXPECT_LE(std::abs(both.difference.mean), 5 * both.difference.standardError + 1e-6)
            << frames[i].name;
        const double lightVaries = 1e-3 * both.mean; // Over what the eye sees, from near and far.
        EXPECT_LE(varianceOf(pictures[i]),
                  1.5 * varianceOf(pictures[i + 1]) + lightVaries * lightVaries)
            << frames[i].name;
    }
}

struct Setting {
    Wide wide;
    const char *floor;
};

class WideLights : public testing::TestWithParam<Setting> {};

TEST_P(WideLights, LeaveLampsTheirSamples) {
    // Pixels that are all alike: what differs is noise.
    const std::string options = "Format 32 32 1\nProjection \"perspective\" \"fov\" [.5]\n";
    const std::string floor =
        std::string(GetParam().floor) + "Polygon \"P\" [-20 -20 3 -20 20 3 20 20 3 20 -20 3]\n";
    std::vector<Frame> frames;
    for (const Wide &lamp : lamps)
        for (const char *radiance : {".002", ".2"}) {
            const std::string one = lit(1, lamp, "12"), other = lit(2, GetParam().wide, radiance);
            const std::string name = std::string(lamp.name) + ", radiance " + radiance;
            for (const std::string &lights :
                 {one + unlit(GetParam().wide), unlit(lamp) + other, one + other})
                frames.push_back({name, options, lights + floor});
        }
    const auto pictures = render(frames, {4, 1, "light/shaders"});
    ASSERT_EQ(pictures.size(), frames.size());
    for (std::size_t i = 0; i < frames.size(); i += 3) {
        const double alone = varianceOf(pictures[i]) + varianceOf(pictures[i + 1]);
        const double together = varianceOf(pictures[i + 2]);
        EXPECT_GT(alone, 0) << frames[i].name;
        EXPECT_LE(together, 3 * alone) << frames[i].name;
    }
}

std::vector<Setting> settings() {
    std::vector<Setting> all;
    for (const Wide &wide : wideLights)
        for (const char *floor : {"Surface \"matte\"\n", "Surface \"roughmetal\" \"alpha\" [.3]\n"})
            all.push_back({wide, floor});
    return all;
}

INSTANTIATE_TEST_SUITE_P(All, WideLights, testing::ValuesIn(settings()), [](const auto &info) {
    return std::string(info.param.wide.name) + (info.index % 2 ? "OverMetal" : "");
});

} // namespace
} // namespace candela::test
