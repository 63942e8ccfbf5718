// SPDX-License-Identifier: Apache-2.0
// Memory that runs out is an error that says so; never a picture that lacks things, nor a crash.
#include "tests/bad_input/bad_input.h"

#include <cmath>

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

// Wherever it runs out: reading, compiling, starting threads; but where no program begins.
TEST_F(Memory, RunsOutInGoodOrder) {
    int pictures = 0, errors = 0;
    for (long megabytes = 280; megabytes <= 520; megabytes += 8) {
        RunSettings little;
        little.memoryLimit = megabytes << 20;
        const Outcome run = render(sceneWith("Surface \"wood\"\n"), {"--threads", "2"}, little);
        if (run.says("error while loading shared libraries"))
            continue;
        EXPECT_TRUE(run.status == 0 || run.status == 1) << megabytes << " MB\n" << run.text();
        EXPECT_TRUE(run.status == 0 || run.says("error: ")) << megabytes << " MB\n" << run.text();
        ++(run.status == 0 ? pictures : errors);
    }
    EXPECT_GT(pictures, 0);
    EXPECT_GT(errors, 0);
}

// Dicing, on all threads.
TEST_F(Memory, MayNotSufficeForTriangles) {
    std::string spheres = "ShadingRate .01\nTranslate 0 0 3\n";
    for (int i = 0; i < 900; ++i)
        spheres += "Sphere 1 -1 .99 360\n"; // Whole ones are not diced.
    expectNotEnough(spheres);
}

// Around a vertex of a subdivision mesh with thousands of faces every patch hangs on all others.
TEST_F(Memory, IsEnoughForFansOfManyFaces) {
    constexpr int count = 20000;
    std::string counts, vertices, points = "0 0 9 ", corners;
    for (int k = 0; k < count; ++k) {
        counts += "3 ";
        vertices += "0 " + std::to_string(1 + k) + " " + std::to_string(1 + (k + 1) % count) + " ";
        corners += std::to_string(1 + k) + " ";
        const double turn = 2 * M_PI * k / count;
        points += std::to_string(std::cos(turn)) + " " + std::to_string(std::sin(turn)) + " 9 ";
    }
    RunSettings little;
    little.memoryLimit = 2L << 30;
    const std::string boundary = " [\"interpolateboundary\"] [0 0] [] [] \"P\" [" + points + "] ";
    for (const std::string &faces : {"[" + counts + "] [" + vertices + "]",
                                     "[" + std::to_string(count) + "] [" + corners + "]"}) {
        for (const char *scheme : {"catmull-clark", "loop"}) {
            Outcome run = render(
                sceneWith(std::string("SubdivisionMesh \"") + scheme + "\" " + faces + boundary),
                {"--threads", "2"}, little);
            EXPECT_EQ(run.status, 0) << run.text();
            EXPECT_TRUE(run.says("to be smoothed: its faces are drawn as they are")) << run.text();
            expectDisc();
        }
    }
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
