// SPDX-License-Identifier: Apache-2.0
// Paths begin on a ball that shines beside what it lights, however large it is, and not on a sphere
// around everything; that is said.
#include "tests/support/program.h"
#include "tests/support/scratch_folder.h"

#include <gtest/gtest.h>

namespace candela::test {
namespace {

/// What is said of a ball of radius 1 that shines, with its centre at this x, and a square around
/// the origin.
bool saysThatItSurrounds(const std::string &x) {
    ScratchFolder folder;
    const std::string rib = folder.write(
        "scene.rib",
        "Option \"radiometry\" \"string units\" \"si\"\nOption \"render\" \"string integrator\" "
        "\"bidir\"\nFormat 4 4 1\nDisplay \"out.exr\" \"openexr\" \"rgb\"\nWorldBegin\n"
        "Translate 0 0 3\nAttributeBegin\nAreaLightSource \"arealight\" 1\n"
        "Surface \"matte\" \"Kd\" [0]\nTranslate " +
            x +
            " 0 0\nSphere 1 -1 1 360\nAttributeEnd\nIlluminate 1 1\nSurface \"matte\"\n"
            "Polygon \"P\" [-.2 -.2 0  -.2 .2 0  .2 .2 0  .2 -.2 0]\nWorldEnd\n");
    const Outcome run = runCandela({rib, "--output-dir", folder.path(), "--spp", "1"});
    EXPECT_EQ(run.status, 0) << run.text();
    return run.says("it surrounds the scene");
}

TEST(BallLamps, BeginPathsBesideWhatTheyLight) {
    EXPECT_FALSE(saysThatItSurrounds("-1.3"));
    EXPECT_TRUE(saysThatItSurrounds("0"));
}

} // namespace
} // namespace candela::test
