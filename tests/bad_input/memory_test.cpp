// SPDX-License-Identifier: Apache-2.0
// Memory that runs out is an error that says so; never a picture that lacks things, nor a crash.
#include "tests/bad_input/bad_input.h"

namespace candela::test {

class Memory : public BadInput {
protected:
    /// Renders what needs much in little; the picture must not come out.
    void expectNotEnough(const std::string &wrong) {
        RunSettings little;
        little.memoryLimit = 700L << 20;
        Outcome run = render(sceneWith(wrong), {"--threads", "2"}, little);
        EXPECT_EQ(run.status, 1) << run.text();
        EXPECT_TRUE(run.says("error: ")) << run.text();
        EXPECT_TRUE(run.says("not enough memory")) << run.text();
        EXPECT_FALSE(folder_.has("out.exr")) << run.text();
    }
};

#ifndef __SANITIZE_ADDRESS__ // Its shadow alone takes more address space than that.

// The limit leaves enough for an ordinary scene.
TEST_F(Memory, IsEnoughForASmallScene) {
    RunSettings little;
    little.memoryLimit = 700L << 20;
    Outcome run = render(sceneWith(""), {"--threads", "2"}, little);
    EXPECT_EQ(run.status, 0) << run.text();
    expectDisc();
}

// Dicing, on all threads.
TEST_F(Memory, MayNotSufficeForTriangles) {
    std::string spheres = "ShadingRate .0001\nTranslate 0 0 3\n";
    for (int i = 0; i < 60; ++i)
        spheres += "Sphere 1 -1 .99 360\n"; // Whole ones are not diced.
    expectNotEnough(spheres);
}

// Reading: more numbers than there is room for.
TEST_F(Memory, MayNotSufficeForTheFile) {
    std::string numbers;
    for (int i = 0; i < 1 << 20; ++i)
        numbers += "0 ";
    std::string many;
    for (int i = 0; i < 100; ++i)
        many += numbers;
    expectNotEnough("PointsPolygons [3] [0 1 2] \"P\" [" + many + "]");
}

#endif

} // namespace candela::test
