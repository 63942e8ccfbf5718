// SPDX-License-Identifier: Apache-2.0
// What is said of displacement that goes wrong, and that the rest is drawn all the same.
#include "image/picture_file.h"
#include "tests/support/program.h"
#include "tests/support/scratch_folder.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace candela::test {
namespace {

struct Drawn {
    Outcome run;
    double covered = 0; ///< Share of the picture.
};

Drawn draw(const std::string &world, const std::string &options = {}) {
    ScratchFolder folder;
    const std::string rib =
        folder.write("scene.rib", options +
                                      "Format 64 64 1\nPixelFilter \"box\" 1 1\n"
                                      "Display \"out.exr\" \"openexr\" \"rgba\"\n"
                                      "Projection \"orthographic\"\nScreenWindow -2 2 -2 2\n"
                                      "Translate 0 0 5\nWorldBegin\nSurface \"constant\"\n" +
                                      world + "\nWorldEnd\n");
    Drawn drawn;
    drawn.run = runCandela({rib, "--quiet", "--spp", "4", "--output-dir", folder.path(),
                            "--shader-path", CANDELA_SOURCE_DIR "/tests/displacement/shaders"});
    std::string problem;
    if (const auto picture = readPicture(folder.path("out.exr"), problem)) {
        const std::vector<float> &alpha = picture->find("A")->values;
        for (float a : alpha)
            drawn.covered += a / double(alpha.size());
    }
    return drawn;
}

int times(const std::string &part, const std::string &text) {
    int count = 0;
    for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; ++at)
        ++count;
    return count;
}

constexpr double sphere = 3.14159265 / 16, blown = 1.44 * sphere;

/// Two bodies in one place are as far out as each says.
TEST(Bodies, InOnePlaceAreNotWelded) {
    const std::string puff = "Displacement \"puff\" Sphere 1 -1 1 360\n";
    const std::string inner = "Displacement \"puff\" \"by\" [-.5]\nSphere 1 -1 1 360\n";
    EXPECT_NEAR(draw(puff + inner).covered, blown, 2e-3);
    EXPECT_NEAR(draw(inner + puff).covered, blown, 2e-3);
    EXPECT_NEAR(draw(inner).covered, .25 * sphere, 2e-3);
}

/// What changes its shape while it is displaced keeps the one that it has at first, and says so.
TEST(Messages, TellOfDisplacedThingsThatChange) {
    const std::string moving =
        "MotionBegin [0 1]\n"
        "Patch \"bilinear\" \"P\" [-1.5 -.5 0 -.5 -.5 0 -1.5 .5 0 -.5 .5 0]\n"
        "Patch \"bilinear\" \"P\" [.5 -.5 0 1.5 -.5 0 .5 .5 0 1.5 .5 0]\n"
        "MotionEnd\n";
    for (const char *shader :
         {"Displacement \"puff\" \"by\" [.01]\n", "Displacement \"puff\" \"by\" [0]\n"}) {
        const Drawn drawn = draw(std::string(shader) + moving, "Shutter 0 1\n");
        EXPECT_EQ(drawn.run.status, 0);
        EXPECT_EQ(
            times("a primitive that is displaced keeps the shape that it has when the shutter "
                  "opens",
                  drawn.run.err),
            1)
            << drawn.run.err;
        EXPECT_NEAR(drawn.covered, 1. / 16, 2e-3);
    }
}

TEST(Messages, TellTheLeastBoundThatHolds) {
    const std::string displaced = "Displacement \"puff\" Sphere 1 -1 1 360";
    for (const char *right : {"", "Attribute \"displacementbound\" \"sphere\" [.2]",
                              "Attribute \"displacementbound\" \"float sphere\" [.4] "
                              "\"string coordinatesystem\" [\"world\"]"}) {
        const Drawn drawn = draw(std::string(right) + "\n" + displaced);
        EXPECT_EQ(drawn.run.err, "") << right;
        EXPECT_NEAR(drawn.covered, blown, 2e-3);
    }
    for (const char *small :
         {"Attribute \"displacementbound\" \"sphere\" [.05] \"coordinatesystem\" [\"shader\"]",
          "Scale .5 .5 .5 Attribute \"displacementbound\" \"float sphere\" [.3]"}) {
        const Drawn drawn =
            draw(std::string(small) + "\n" + displaced + "\n" + "Sphere 1 -1 1 360");
        EXPECT_EQ(drawn.run.status, 0);
        const bool isHalf = small[0] == 'S';
        EXPECT_EQ(times(isHalf ? "at least 0.4" : "at least 0.2", drawn.run.err), 1)
            << drawn.run.err;
        EXPECT_TRUE(drawn.run.says("scene.rib:10:"));
    }
}

TEST(Messages, NameShadersThatSendPointsNowhere) {
    for (const char *how : {"0", "1", "2"}) {
        const Drawn drawn = draw("Displacement \"astray\" \"float how\" [" + std::string(how) +
                                 "]\nSphere 1 -1 1 360\nTranslate 1 0 0\nSphere .5 -.5 .5 360");
        EXPECT_EQ(drawn.run.status, 0) << drawn.run.text();
        EXPECT_EQ(times("\"astray\" moves points to where there is no place", drawn.run.err), 1)
            << drawn.run.err;
        EXPECT_GT(drawn.covered, .9 * sphere);
    }
}

TEST(Messages, GrowWithNoHugeDisplacement) {
    const Drawn drawn = draw("Displacement \"puff\" \"float by\" [1e6]\nSphere 1 -1 1 360");
    EXPECT_EQ(drawn.run.status, 0) << drawn.run.text();
    EXPECT_EQ(drawn.run.err, "");
}

TEST(Messages, TellOfMissingShadersOnce) {
    const Drawn drawn =
        draw("Displacement \"nosuch\"\nSphere 1 -1 1 360\nTranslate .5 0 0\nSphere 1 -1 1 360");
    EXPECT_EQ(drawn.run.status, 1);
    EXPECT_EQ(times("no shader \"nosuch\"", drawn.run.err), 1) << drawn.run.err;
    EXPECT_GT(drawn.covered, .99 * sphere);
    EXPECT_EQ(draw("Displacement \"null\"\nSphere 1 -1 1 360").run.err, "");
}

} // namespace
} // namespace candela::test
