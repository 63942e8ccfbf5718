// SPDX-License-Identifier: Apache-2.0
// option() and rendererinfo(): what shaders are told of the frame and of the renderer.
#include "tests/support/program.h"
#include "tests/support/scratch_folder.h"

#include <gtest/gtest.h>
#include <set>
#include <sstream>

namespace candela::test {
namespace {

std::string frame(int number, const std::string &size, const std::string &options,
                  const std::string &world) {
    return "FrameBegin " + std::to_string(number) + "\nFormat " + size + " 1\n" + options +
           "PixelFilter \"box\" 1 1\nPixelSamples 1 1\nDisplay \"out.exr\" \"openexr\" \"rgb\"\n"
           "Projection \"orthographic\"\nScreenWindow -1 1 -1 1\nWorldBegin\nTranslate 0 0 1\n" +
           world + "WorldEnd\nFrameEnd\n";
}

std::string square(const std::string &where) {
    return "TransformBegin\nTranslate " + where +
           "\nPolygon \"P\" [-.8 -.8 0 .8 -.8 0 .8 .8 0 -.8 .8 0]\nTransformEnd\n";
}

/// What the shaders say, each line once.
std::set<std::string> linesOf(const std::string &rib, const char *lanes) {
    ScratchFolder folder;
    const Outcome run =
        runCandela({folder.write("scene.rib", rib), "--quiet", "--lanes", lanes, "--shader-path",
                    CANDELA_SOURCE_DIR "/tests/shading/shaders", "--output-dir", folder.path()});
    EXPECT_EQ(run.status, 0) << run.text();
    std::istringstream all(run.out);
    std::set<std::string> lines;
    for (std::string line; std::getline(all, line);)
        lines.insert(line);
    return lines;
}

using Lines = std::set<std::string>;

TEST(Option, EachFrameTellsItsOwn) {
    const std::string world = "Surface \"telling\"\n" + square("0 0 0");
    const std::string rib = frame(1, "8 4",
                                  "Option \"user\" \"uniform float gain\" [2]\n"
                                  "Option \"user\" \"uniform color tint\" [.5 .25 1]\n",
                                  world) +
                            frame(2, "6 6", "Option \"user\" \"uniform float gain\" [3]\n", world);
    for (const char *lanes : {"1", "16"})
        EXPECT_EQ(linesOf(rib, lanes), (Lines{"1110 8 4 1 2 0.500000 0.250000 1.000000 7",
                                              "1100 6 6 1 3 7.000000 7.000000 7.000000 7"}))
            << lanes;
}

TEST(RendererInfo, IsKnownWhenTheShaderIsCompiled) {
    ScratchFolder folder;
    const std::string source =
        folder.write("who.sl", "surface who() { string name = \"\", version = \"\";\n"
                               "  float number[4] = {9, 9, 9, 9}, missing = 5;\n"
                               "  float a = rendererinfo(\"renderer\", name);\n"
                               "  float b = rendererinfo(\"versionstring\", version);\n"
                               "  float c = rendererinfo(\"version\", number);\n"
                               "  float d = rendererinfo(\"nothing\", missing);\n"
                               "  if (a + b + c != 3 || d != 0 || missing != 5) Ci = 7;\n"
                               "  if (version != CANDELA_VERSION || name != \"Candela\") Ci = 7;\n"
                               "  if (number[0] * 10000 + number[1] * 100 + number[2] != CANDELA)\n"
                               "    Ci = 7; }\n");
    const Outcome run = runCandela({"compile", "--emit", "ir", "--question", "shade", source});
    EXPECT_EQ(run.status, 0) << run.text();
    EXPECT_EQ(run.out.find("If"), std::string::npos) << run.out;
    EXPECT_EQ(run.out.find(" (7)"), std::string::npos) << run.out;
}

} // namespace
} // namespace candela::test
