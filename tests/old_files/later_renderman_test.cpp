// SPDX-License-Identifier: Apache-2.0
// What PRMan had from 19 on, and Aqsis: materials, lights, layers, cameras that come near.
#include "image/picture_file.h"
#include "tests/support/program.h"
#include "tests/support/scratch_folder.h"

#include <gtest/gtest.h>
#include <numbers>

namespace candela::test {
namespace {

/// The red of the middle of a picture of this world, looked at along z through a narrow lens.
float redOf(const std::string &world, const std::string &options = {}) {
    ScratchFolder folder;
    const std::string rib = "Format 9 9 1\nPixelFilter \"box\" 1 1\n"
                            "Display \"out.exr\" \"openexr\" \"rgb\"\n" +
                            (options.empty() ? "Projection \"perspective\" \"fov\" 2\n" : options) +
                            "WorldBegin\n" + world + "WorldEnd\n";
    const Outcome run = runCandela(
        {folder.write("scene.rib", rib), "--output-dir", folder.path(), "--quiet", "--spp", "256"});
    EXPECT_EQ(run.status, 0) << run.text();
    std::string problem;
    const auto picture = readPicture(folder.path("out.exr"), problem);
    EXPECT_TRUE(picture) << problem;
    return picture ? picture->find("R")->values.at(40) : -1;
}

const std::string wall = "Polygon \"P\" [-9 -9 4  -9 9 4  9 9 4  9 -9 4]\n";

TEST(LaterRenderMan, MaterialsHaveTheirColor) {
    const std::string sun = "LightSource \"distantlight\" 1\n";
    EXPECT_NEAR(redOf(sun + "Bxdf \"PxrDiffuse\" \"a\" \"color diffuseColor\" [.25 1 1]\n" + wall),
                .25f, .01f);
    EXPECT_NEAR(redOf(sun +
                      "Color [.75 1 1]\nBxdf \"PxrDiffuse\" \"a\" \"reference color "
                      "diffuseColor\" [\"x:resultRGB\"]\n" +
                      wall),
                .75f, .01f);
    EXPECT_NEAR(redOf("Bxdf \"PxrConstant\" \"a\" \"color emitColor\" [.25 1 1]\n" + wall), .25f,
                .01f);
    EXPECT_NEAR(redOf(sun + "Bxdf \"PxrBlack\" \"a\"\n" + wall), 0, .01f);
}

// A square or disc of radiance L, parallel to the wall at a distance of 1, seen from its middle.
TEST(LaterRenderMan, LightsShineAlongZOnTheWholeWorld) {
    const auto lit = [](const char *light, const char *more = "") {
        return redOf("AttributeBegin\nAttribute \"visibility\" \"integer camera\" [0]\n"
                     "AttributeBegin\nTranslate 0 0 3\n" +
                     std::string(more) + "Light \"" + light +
                     "\" \"a\" \"float exposure\" [1] \"float intensity\" [1.5]\n"
                     "AttributeEnd\nAttributeEnd\nBxdf \"PxrDiffuse\" \"b\" \"color diffuseColor\" "
                     "[.5 .5 .5]\n" +
                     wall);
    };
    const double radiance = 3, albedo = .5;
    // Irradiance over pi: that of a disc is r^2 / (r^2 + 1), of a square's corner by its contour.
    const double disc = .25 / 1.25;
    const double a = .5 / std::sqrt(1.25);
    const double square = 4 / (2 * std::numbers::pi) * 2 * a * std::atan(a);
    EXPECT_NEAR(lit("PxrDiskLight"), albedo * radiance * disc, .01f);
    EXPECT_NEAR(lit("PxrRectLight"), albedo * radiance * square, .01f);
    EXPECT_NEAR(lit("PxrRectLight", "Scale -1 1 1\n"), albedo * radiance * square, .01f);
    EXPECT_NEAR(lit("PxrRectLight", "Rotate 180 1 0 0\n"), 0, 1e-6f);
    EXPECT_NEAR(lit("PxrSphereLight"), albedo * radiance * .25, .01f);
    EXPECT_NEAR(lit("PxrDistantLight"), albedo * radiance / std::numbers::pi, .01f);
    EXPECT_NEAR(lit("PxrDomeLight"), albedo * radiance, .01f);
}

TEST(LaterRenderMan, LayersAndCamerasComeNear) {
    EXPECT_NEAR(redOf("Color [.25 1 1]\nShaderLayer \"surface\" \"matte\" \"a\"\n"
                      "ShaderLayer \"surface\" \"constant\" \"b\"\n"
                      "ConnectShaderLayers \"surface\" \"a\" \"Ci\" \"b\" \"Cs\"\n" +
                      wall),
                .25f, 1e-6f);
    const std::string disc = "Surface \"constant\"\nTranslate 0 0 4\nDisk 0 .01 360\n";
    EXPECT_EQ(redOf(disc, "Projection \"PxrCamera\" \"float fov\" [.1]\n"), 1);
    EXPECT_EQ(redOf(disc, "Projection \"fisheye\" \"fov\" [.1]\n"), 1);
    EXPECT_LT(redOf(disc, "Projection \"PxrOrthographic\"\n"), .2f);
}

TEST(LaterRenderMan, HierarchicalMeshesAreDrawnAsTheirBase) {
    EXPECT_NEAR(redOf("Surface \"constant\"\nColor [.25 1 1]\n"
                      "HierarchicalSubdivisionMesh \"catmull-clark\" [4] [0 1 2 3] "
                      "[\"interpolateboundary\" \"vertexedit\"] [1 0 0 0 1 1] [1] [.5] [\"edit\"] "
                      "\"P\" [-9 -9 4  -9 9 4  9 9 4  9 -9 4]\n"),
                .25f, 1e-6f);
}

} // namespace
} // namespace candela::test
