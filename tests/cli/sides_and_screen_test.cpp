// SPDX-License-Identifier: Apache-2.0
// Which side of a surface is seen in mirrored spaces, and where what stands before Projection puts
// the picture.
#include "image/picture_file.h"
#include "tests/support/program.h"
#include "tests/support/scratch_folder.h"

#include <gtest/gtest.h>

namespace candela::test {

namespace {

class Views : public testing::Test {
protected:
    ScratchFolder folder_;

    /// The red and alpha channels of a picture of 16 x 16 pixels.
    struct Seen {
        std::vector<float> red, alpha;
    };
    Seen render(const std::string &rib) {
        folder_.write("side.sl", "surface side() { Oi = 1; vector i = normalize(I);\n"
                                 "  Ci = (N . i < 0 && Ng . i < 0) ? 1 : 0; }\n");
        const std::string head = "Format 16 16 1\nPixelSamples 1 1\nPixelFilter \"box\" 1 1\n"
                                 "Display \"out.exr\" \"openexr\" \"rgba\"\n";
        Outcome run = runCandela({folder_.write("scene.rib", head + rib), "--output-dir",
                                  folder_.path(), "--shader-path", folder_.path() + ":&"});
        EXPECT_EQ(run.status, 0) << rib << run.text();
        EXPECT_EQ(run.errBesidesLight(), "") << rib;
        std::string problem;
        std::optional<Picture> picture = readPicture(folder_.path("out.exr"), problem);
        if (!picture || !picture->find("R") || !picture->find("A")) {
            ADD_FAILURE() << problem;
            return {};
        }
        return {picture->find("R")->values, picture->find("A")->values};
    }
};

} // namespace

TEST_F(Views, TheOutsideIsSeenInEveryMirror) {
    const std::string shapes[] = {"Sphere 1 -1 1 360", "Torus .7 .3 0 360 360",
                                  "ObjectBegin 1 Scale 1 -1 1 Sphere 1 -1 1 360 ObjectEnd "
                                  "Scale -1 1 1 ObjectInstance 1"};
    for (const std::string &shape : shapes)
        for (const char *camera : {"", "Scale 1 1 -1 "})
            for (const char *mirror : {"", "Scale -1 1 1 ", "Scale -1 -1 -1 "})
                for (bool reversed : {false, true}) {
                    const std::string rib =
                        std::string("Projection \"perspective\" \"fov\" [30] Translate 0 0 4 ") +
                        camera + "WorldBegin Surface \"side\" " + mirror +
                        (reversed ? "ReverseOrientation " : "") + shape + " WorldEnd\n";
                    const Seen seen = render(rib);
                    int covered = 0, outside = 0;
                    for (std::size_t i = 0; i < seen.alpha.size(); ++i)
                        covered += seen.alpha[i] > 0.99f, outside += seen.red[i] > 0.99f;
                    EXPECT_GT(covered, 50) << rib;
                    EXPECT_EQ(outside, reversed ? 0 : covered) << rib;
                }
}

// A square in the upper right quarter of the screen; rows count from the top.
TEST_F(Views, WhatStandsBeforeProjectionMovesThePicture) {
    struct {
        const char *before, *projection;
        int x0, x1, y0, y1; ///< The pixels that it covers.
    } const table[] = {
        {"", "Projection \"orthographic\"", 8, 12, 4, 8},
        {"", "Projection \"null\"", 8, 12, 4, 8},
        {"", "Projection \"\"", 8, 12, 4, 8},
        {"", "", 8, 12, 4, 8},
        {"Scale .5 .5 1", "Projection \"null\"", 8, 10, 6, 8},
        {"Scale .5 .5 1", "", 8, 10, 6, 8},
        {"Scale .5 .5 1", "Projection \"orthographic\"", 8, 10, 6, 8},
        {"Scale .5 .5 1", "Projection \"perspective\" \"fov\" [90]", 8, 10, 6, 8},
        {"", "Projection \"perspective\" \"fov\" [90]", 8, 12, 4, 8},
        {"Scale -1 1 1", "Projection \"orthographic\"", 4, 8, 4, 8},
        {"Rotate 90 0 0 1", "Projection \"orthographic\"", 4, 8, 4, 8},
        {"Rotate 90 0 0 1", "Projection \"perspective\" \"fov\" [90]", 4, 8, 4, 8},
        {"Translate .25 -.5 0", "Projection \"perspective\" \"fov\" [90]", 10, 14, 8, 12},
    };
    for (const auto &row : table) {
        const std::string rib = std::string(row.before) + "\n" + row.projection +
                                "\nWorldBegin\nSurface \"constant\"\n"
                                "Polygon \"P\" [0 0 1 0 .5 1 .5 .5 1 .5 0 1]\nWorldEnd\n";
        const Seen seen = render(rib);
        ASSERT_EQ(seen.alpha.size(), 256u);
        for (int y = 0; y < 16; ++y)
            for (int x = 0; x < 16; ++x)
                EXPECT_EQ(seen.alpha[16 * y + x],
                          x >= row.x0 && x < row.x1 && y >= row.y0 && y < row.y1)
                    << rib << x << " " << y;
    }
}

} // namespace candela::test
