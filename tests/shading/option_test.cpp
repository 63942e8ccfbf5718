// SPDX-License-Identifier: Apache-2.0
// option(): shaders are told what each frame's options are.
#include "tests/support/program.h"
#include "tests/support/scratch_folder.h"

#include <gtest/gtest.h>
#include <set>
#include <sstream>

namespace candela::test {
namespace {

std::string frame(int number, const std::string &size, const std::string &options) {
    return "FrameBegin " + std::to_string(number) + "\nFormat " + size + " 1\n" + options +
           "PixelFilter \"box\" 1 1\nPixelSamples 1 1\nDisplay \"out.exr\" \"openexr\" \"rgb\"\n"
           "Projection \"orthographic\"\nWorldBegin\nSurface \"telling\"\nTranslate 0 0 1\n"
           "Polygon \"P\" [-.5 -.5 0 .5 -.5 0 .5 .5 0 -.5 .5 0]\nWorldEnd\nFrameEnd\n";
}

TEST(Option, EachFrameTellsItsOwn) {
    ScratchFolder folder;
    const std::string rib =
        frame(1, "8 4",
              "Option \"user\" \"uniform float gain\" [2]\n"
              "Option \"user\" \"uniform color tint\" [.5 .25 1]\n") +
        frame(2, "6 6", "Option \"user\" \"uniform float gain\" [3]\n");
    for (const char *lanes : {"1", "16"}) {
        const Outcome run = runCandela({folder.write("scene.rib", rib), "--quiet", "--lanes", lanes,
                                        "--shader-path", CANDELA_SOURCE_DIR "/tests/shading/shaders",
                                        "--output-dir", folder.path()});
        EXPECT_EQ(run.status, 0) << run.text();
        std::istringstream all(run.out);
        std::set<std::string> lines;
        for (std::string line; std::getline(all, line);)
            lines.insert(line);
        EXPECT_EQ(lines, (std::set<std::string>{
                             "1110 8 4 1 2 0.500000 0.250000 1.000000 7",
                             "1100 6 6 1 3 7.000000 7.000000 7.000000 7"}));
    }
}

} // namespace
} // namespace candela::test
