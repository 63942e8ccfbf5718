// SPDX-License-Identifier: Apache-2.0
// What the frame does not show costs few triangles, however small its pixels are: counted for
// lamps of every curved kind, behind the camera and beside what it looks at.
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
                "scene.rib", "Format 32 32 1\nPixelSamples 1 1\nDisplay \"out.exr\" \"openexr\" "
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

} // namespace
} // namespace candela::test
