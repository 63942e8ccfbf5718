// SPDX-License-Identifier: Apache-2.0
// Shadow maps, made and used in one file: a disc over a ground, against where rays say its shadow
// lies; no acne and no gap; under both integrators, with MakeShadow and without.
#include "tests/textures/pictures.h"

#include "image/picture_file.h"

#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>

namespace candela::test {
namespace {

/// A ground, y up, and a disc of radius 1 that floats above it, turned as the ground is.
const std::string world =
    "AttributeBegin Surface \"matte\" \"Kd\" 1 \"Ka\" 0\n"
    "Polygon \"P\" [-6 0 -6  -6 0 6  6 0 6  6 0 -6]\n"
    "TransformBegin Translate 0 2 0 Rotate -90 1 0 0 Disk 0 1 360 TransformEnd AttributeEnd\n";

/// The light's own picture: straight down from 6 m, or, turned, at a slant.
struct Light {
    const char *name, *placing, *shader, *projection;
};
const Light lights[] = {
    {"spot", "Translate 0 0 6 Rotate -90 1 0 0", "shadowspot", "\"perspective\" \"fov\" 70"},
    {"slanted spot", "Translate 0 0 6 Rotate -60 1 0 0", "shadowspot",
     "\"perspective\" \"fov\" 70"},
    {"distant", "Translate 0 0 6 Rotate -70 1 0 0 Rotate 30 0 1 0", "shadowdistant",
     "\"orthographic\""},
};

std::string scene(const Light &light, const std::string &map, bool makes, const char *integrator) {
    const bool parallel = std::string(light.projection) == "\"orthographic\"";
    std::string rib = fmt::format(
        "FrameBegin 1 Format 256 256 1 PixelSamples 1 1 PixelFilter \"box\" 1 1\n"
        "Display \"depths.z\" \"{}\" \"z\" Projection {} {}\n{}\nWorldBegin\n{}WorldEnd FrameEnd\n",
        makes ? "zfile" : "shadow", light.projection, parallel ? "ScreenWindow -6 6 -6 6" : "",
        light.placing, world);
    if (makes)
        rib += "MakeShadow \"depths.z\" \"depths.shd\"\n";
    // The light looks along its own z: its space is the inverse of the placing.
    for (const bool mapped : {true, false})
        rib += fmt::format(
            "FrameBegin 2 Format 128 128 1 PixelSamples 4 4 PixelFilter \"box\" 1 1\n"
            "Option \"render\" \"string integrator\" [\"{}\"]\n"
            "Display \"{}.exr\" \"openexr\" \"rgb\" Projection \"orthographic\" "
            "ScreenWindow -5 5 -5 5\nTranslate 0 0 9 Rotate -90 1 0 0\nWorldBegin\n"
            "AttributeBegin\n{}\n{}LightSource \"{}\" 1 \"float intensity\" [{}] {} {}\n"
            "AttributeEnd\nIlluminate 1 1\n{}WorldEnd FrameEnd\n",
            integrator, mapped ? "mapped" : "traced",
            mapped ? "" : "Attribute \"light\" \"string shadows\" [\"on\"]",
            "ConcatTransform [" + map + "]\n", light.shader, parallel ? "1" : "30",
            parallel ? "" : "\"float coneangle\" [.6]",
            mapped ? fmt::format("\"string shadowname\" [\"{}\"] \"float blur\" [0]",
                                 makes ? "depths.shd" : "depths.z")
                   : "",
            world);
    return rib;
}

/// The inverse of a row of Translate and Rotate, as a matrix: the light's space in the world.
std::string inverseOf(const Light &light) {
    Matrix4 matrix;
    if (std::string(light.name) == "spot")
        matrix = rotation(-90, {1, 0, 0}) * translation(0, 0, 6);
    else if (std::string(light.name) == "slanted spot")
        matrix = rotation(-60, {1, 0, 0}) * translation(0, 0, 6);
    else
        matrix = rotation(30, {0, 1, 0}) * rotation(-70, {1, 0, 0}) * translation(0, 0, 6);
    std::string words;
    const Matrix4 back = inverse(matrix).value_or(Matrix4{});
    for (const float number : back.m)
        words += fmt::format("{} ", number);
    return words;
}

TEST(ShadowMaps, LieWhereRaysSayAndNowhereElse) {
    for (const Light &light : lights)
        for (const char *integrator : {"classic", "path"})
            for (const bool makes : {true, false}) {
                SCOPED_TRACE(fmt::format("{} {} {}", light.name, integrator, makes));
                ScratchFolder folder;
                const Outcome run =
                    runCandela({"--quiet", "--output-dir", folder.path(),
                                folder.write("shadow.rib",
                                             scene(light, inverseOf(light), makes, integrator))});
                EXPECT_EQ(run.status, 0) << run.text();
                EXPECT_EQ(run.errBesidesLight(), "");
                std::string problem;
                const auto mapped = readPicture(folder.path("mapped.exr"), problem);
                const auto traced = readPicture(folder.path("traced.exr"), problem);
                ASSERT_TRUE(mapped && traced) << problem;
                const auto &a = mapped->find("G")->values, &b = traced->find("G")->values;
                double difference = 0, light_ = 0, dark = 0;
                for (std::size_t i = 0; i < a.size(); ++i) {
                    difference += std::abs(a[i] - b[i]);
                    light_ += b[i];
                    dark += b[i] < 0.3f; // Under path some light comes by way of the disc.
                }
                ASSERT_GT(light_, 0);
                EXPECT_GT(dark, 100) << "there is no shadow";
                // The shadow's rim is a pixel of the map wide.
                EXPECT_LT(difference, 0.02 * light_);
            }
}

TEST(ShadowMaps, BlurAndBiasAreAsTold) {
    ScratchFolder folder;
    // A wall at depth 4 on the left half of what the camera at the origin sees, nothing on the
    // right.
    const std::string depths =
        "FrameBegin 1 Format 64 64 1 PixelSamples 1 1 PixelFilter \"box\" 1 1\n"
        "Display \"wall.z\" \"shadow\" \"z\" Projection \"orthographic\" ScreenWindow -1 1 -1 1\n"
        "WorldBegin Translate 0 0 4 Polygon \"P\" [-9 -9 0  0 -9 0  0 9 0  -9 9 0] WorldEnd "
        "FrameEnd\n";
    const struct {
        const char *call;
        float expected, within;
    } rows[] = {
        {"shadow(\"wall.z\", point \"world\" (-.5, 0, 6))", 1, 0},
        {"shadow(\"wall.z\", point \"world\" (-.5, 0, 4))", 0, 0},
        {"shadow(\"wall.z\", point \"world\" (-.5, 0, 3))", 0, 0},
        {"shadow(\"wall.z\", point \"world\" (.5, 0, 6))", 0, 0},
        {"shadow(\"wall.z\", point \"world\" (-5, 0, 6))", 0, 0},
        {"shadow(\"wall.z\", point \"world\" (-.5, 0, 6), \"bias\", 3)", 0, 0},
        {"shadow(\"wall.z\", point \"world\" (-.5, 0, 4.2), \"bias\", .1)", 1, 0},
        {"shadow(\"wall.z\", point \"world\" (-.5, 0, 4.2), \"bias\", .3)", 0, 0},
        {"shadow(\"wall.z\", point \"world\" (0, 0, 6), \"samples\", 64)", .5f, .02f},
        {"shadow(\"wall.z\", point \"world\" (.1, 0, 6), \"blur\", .2, \"samples\", 256, "
         "\"bias\", .5)",
         .25f, .03f},
        {"shadow(\"wall.z\", point \"world\" (-.4, -.1, 6), point \"world\" (.4, -.1, 6), "
         "point \"world\" (-.4, .1, 6), point \"world\" (.4, .1, 6), \"samples\", 256, "
         "\"bias\", .5)",
         .5f, .03f},
        {"comp(color shadow(\"wall.z\", point \"world\" (-.5, 0, 6)), 2)", 1, 0},
    };
    std::vector<std::string> expressions;
    for (const auto &row : rows)
        expressions.emplace_back(row.call);
    const Told told = tell(folder, {expressions, "", depths});
    EXPECT_EQ(told.run.errBesidesLight(), "");
    ASSERT_EQ(told.values.size(), expressions.size()) << told.run.text();
    for (std::size_t k = 0; k < expressions.size(); ++k)
        EXPECT_NEAR(told.values[k], rows[k].expected, rows[k].within) << expressions[k];
}

} // namespace
} // namespace candela::test
