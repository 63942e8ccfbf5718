// SPDX-License-Identifier: Apache-2.0
// Output parameters of volumes are channels of displays: those of the segment that the camera sees
// first.
#include "image/picture_file.h"
#include "tests/support/program.h"
#include "tests/support/scratch_folder.h"
#include "tests/volumes/worlds.h"

#include <gtest/gtest.h>

namespace candela::test {
namespace {

TEST(VolumeOutputs, AreChannels) {
    const std::string half = "Surface \"matte\"\nPolygon \"P\" [-1 -1 2  -1 1 2  0 1 2  0 -1 2]\n";
    for (const std::string integrator : {"classic", "path"}) {
        ScratchFolder folder;
        folder.write("told.sl",
                     "volume told(output varying float air = 0; output varying color tint = 0;)\n"
                     "{ color c = 0; illuminance (P) c += Cl; air = length(I); tint = c;\n"
                     "Ci *= .5; }\n");
        folder.write("curved.sl", "volume curved(output varying float air = 0;)\n"
                                  "{ Ci = Ci * Ci; air = 5; }\n");
        for (const bool isCurved : {false, true}) {
            const std::string rib = folder.write(
                "scene.rib",
                "Format 4 4 1\nPixelSamples 1 1\nPixelFilter \"box\" 1 1\nDisplay \"out.exr\" "
                "\"openexr\" \"rgba,air" +
                    std::string(isCurved ? "" : ",tint") +
                    "\"\nProjection \"orthographic\"\nScreenWindow -1 1 -1 "
                    "1\nWorldBegin\nLightSource \"distantlight\" 1 \"intensity\" [.5]\n"
                    "AttributeBegin\nAtmosphere \"" +
                    std::string(isCurved ? "curved" : "told") + "\"\n" + half + "AttributeEnd\n" +
                    square(3, "Surface \"matte\"\n") + "WorldEnd\n");
            const Outcome run =
                runCandela({rib, "--quiet", "--integrator", integrator, "--output-dir",
                            folder.path(), "--shader-path", folder.path()});
            EXPECT_EQ(run.status, 0) << run.text();
            std::string problem;
            const auto picture = readPicture(folder.path("out.exr"), problem);
            ASSERT_TRUE(picture) << problem;
            const PictureChannel *air = picture->find("air"), *tint = picture->find("tint.R");
            ASSERT_TRUE(air);
            for (std::size_t pixel = 0; pixel < 16; ++pixel) {
                const bool left = pixel % 4 < 2;
                EXPECT_EQ(air->values[pixel], left ? isCurved ? 5 : 2 : 0) << pixel;
                if (tint)
                    EXPECT_EQ(tint->values[pixel], left ? .5f : 0) << pixel;
            }
            EXPECT_EQ(tint != nullptr, !isCurved);
        }
    }
}

} // namespace
} // namespace candela::test
