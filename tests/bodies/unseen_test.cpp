// SPDX-License-Identifier: Apache-2.0
// What the frame does not show costs few triangles, however small its pixels are: counted for
// lamps of every curved kind, behind the camera and beside what it looks at, and for skies, of
// which it shows a part.
#include "tests/support/program.h"
#include "tests/support/scratch_folder.h"

#include <fstream>
#include <gtest/gtest.h>
#include <sstream>

namespace candela::test {
namespace {

double statistic(const std::string &path, const std::string &name) {
    std::ifstream file(path);
    std::stringstream text;
    text << file.rdbuf();
    const std::size_t at = text.str().find('"' + name + "\":");
    return at == std::string::npos ? -1 : std::stod(text.str().substr(at + name.size() + 3));
}

TEST(Unseen, CurvedLampsCostFewTriangles) {
    const char *const lamps[] = {"Disk 0 .5 360",
                                 "Scale 1 .5 1 Sphere .5 -.5 .5 360",
                                 "Sphere .5 -.4 .5 360",
                                 "Cylinder .5 -.5 .5 360",
                                 "Cone 1 .5 360",
                                 "Paraboloid .5 0 1 360",
                                 "Hyperboloid .5 0 -.5 .2 .4 .5 360",
                                 "Torus .4 .1 0 360 360"};
    const char *const cameras[] = {
        "Projection \"orthographic\"\nScreenWindow -1e-4 1e-4 -1e-4 1e-4\n",
        "Projection \"perspective\" \"fov\" [.01]\n"};
    const char *const places[] = {"Translate 0 0 -2", "Translate 3 0 2", "Translate 1 -2 .3"};
    ScratchFolder folder;
    for (const char *camera : cameras)
        for (const char *place : places) {
            std::string world;
            for (const char *lamp : lamps)
                world += "AttributeBegin\n" + std::string(place) + "\nSurface \"constant\"\n" +
                         lamp + "\nAttributeEnd\n";
            const std::string rib = folder.write(
                "scene.rib",
                "Format 32 32 1\nPixelSamples 1 1\nDisplay \"out.exr\" \"openexr\" "
                "\"rgb\"\n" +
                    std::string(camera) + "WorldBegin\n" + world +
                    "Surface \"matte\"\nPolygon \"P\" [-1 -1 1 1 -1 1 1 1 1 -1 1 1]\nWorldEnd\n");
            const std::string figures = folder.path("figures.json");
            const Outcome run =
                runCandela({rib, "--quiet", "--output-dir", folder.path(), "--stats", figures});
            EXPECT_EQ(run.status, 0) << run.text();
            const double triangles = statistic(figures, "scene.triangles");
            EXPECT_GT(triangles, 100);
            EXPECT_LT(triangles, 400e3) << camera << place;
        }
}

/// What is around the eye, whole spheres aside: the frame shows little of it, from far away.
struct Sky {
    const char *name, *shape;
};

TEST(Skies, OfAnyFormCostFewTriangles) {
    const Sky skies[] = {
        {"hemisphere", "Rotate -90 1 0 0 Sphere 1000 0 1000 360"},
        {"sphere with a seam", "Sphere 1000 -1000 1000 359.99"},
        {"nearly a sphere", "Scale 1 1 1.001 Sphere 1000 -1000 1000 360"},
        {"ellipsoid", "Scale 1 .5 1 Sphere 1000 -1000 1000 360"},
        {"cylinder", "Rotate -90 1 0 0 Cylinder 1000 -900 900 360"},
        {"paraboloid", "Rotate 90 1 0 0 Translate 0 0 -900 Paraboloid 1000 0 1500 360"},
        {"cone", "Rotate -90 1 0 0 Translate 0 0 -500 Cone 2000 1000 360"},
        {"ceiling", "Translate 0 100 0 Rotate 90 1 0 0 Disk 0 1000 360"},
        {"tent",
         "Rotate -90 1 0 0 Patch \"bicubic\" \"P\" [-900 -900 0 -300 -900 400 300 -900 400 900 "
         "-900 0 -900 -300 400 -300 -300 900 300 -300 900 900 -300 400 -900 300 400 -300 "
         "300 900 300 300 900 900 300 400 -900 900 0 -300 900 400 300 900 400 900 900 0]"}};
    const char *const cameras[] = {"Format 640 480 1\nProjection \"perspective\" \"fov\" [40]\n",
                                   "Format 640 480 1\nProjection \"perspective\" \"fov\" [100]\n",
                                   "Format 16 16 1\nProjection \"perspective\" \"fov\" [1]\n"};
    ScratchFolder folder;
    for (const char *camera : cameras)
        for (const Sky &sky : skies) {
            const std::string rib = folder.write(
                "scene.rib", "PixelSamples 1 1\nDisplay \"out.exr\" \"openexr\" \"rgb\"\n" +
                                 std::string(camera) +
                                 "Translate 0 0 5\nRotate 30 1 2 3\nWorldBegin\nAttributeBegin\n"
                                 "Surface \"constant\"\n" +
                                 sky.shape + "\nAttributeEnd\nWorldEnd\n");
            const std::string figures = folder.path("figures.json");
            const Outcome run = runCandela({rib, "--quiet", "--crop", "0,.1,0,.1", "--output-dir",
                                            folder.path(), "--stats", figures});
            EXPECT_EQ(run.status, 0) << run.text();
            const double triangles = statistic(figures, "scene.triangles");
            EXPECT_GT(triangles, 100) << sky.name;
            EXPECT_LT(triangles, 200e3) << sky.name << camera;
        }
}

} // namespace
} // namespace candela::test
