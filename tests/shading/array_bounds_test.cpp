// SPDX-License-Identifier: Apache-2.0
// Arrays indexed outside their elements: the nearest element is taken, and each place is named
// once, whatever the width of the code and however many points go wrong there.
#include "image/picture_file.h"
#include "tests/support/program.h"
#include "tests/support/scratch_folder.h"

#include <gtest/gtest.h>
#include <sstream>

namespace candela::test {
namespace {

/// Places outside stand on lines 9 (varying, written), 10 (varying, read), 11 (uniform), 12 (NaN),
/// 13 (a parameter), 14 (a primitive variable) and, included, on line 1 of pick.h.
const std::string shader = "#include \"pick.h\"\n"
                           "surface t(float given[2] = {.25, .75}; varying float each[3] = {0, 0, "
                           "0}; float far = 1e30; float zero = 0)\n"
                           "{\n"
                           "    float before[2] = {7, 7};\n"
                           "    float a[4] = {.125, .25, .375, .5};\n"
                           "    float after[2] = {7, 7};\n"
                           "    float index = floor(8 * u) - 2;\n"
                           "    if (index >= 0 && index < 4) a[index] = a[index] * 1;\n"
                           "    a[index] = a[clamp(index, 0, 3)];\n"
                           "    float varyingly = a[index];\n"
                           "    float uniformly = a[far];\n"
                           "    float nowhere = a[zero / zero];\n"
                           "    float parameter = given[-far];\n"
                           "    float variable = each[index];\n"
                           "    float included = pick(after, 9);\n"
                           "    float good = 0;\n"
                           "    if (before[0] == 7 && before[1] == 7 && after[0] == 7 && after[1] "
                           "== 7 && arraylength(a) == 4 && uniformly == .5 && nowhere == .125 && "
                           "parameter == .25 && included == 7 && variable == clamp(index, 0, 2) + "
                           "1) good = 1;\n"
                           "    Oi = 1; Ci = color(varyingly, good, clamp(index, 0, 3));\n"
                           "}\n";

const std::string scene =
    "Format 16 16 1\nPixelSamples 2 2\nPixelFilter \"box\" 1 1\n"
    "Display \"out.exr\" \"openexr\" \"rgb\"\nProjection \"orthographic\"\n"
    "WorldBegin\nSurface \"t\"\n"
    "Patch \"bilinear\" \"P\" [-1 -1 1 1 -1 1 -1 1 1 1 1 1] \"varying float[3] "
    "each\" [1 2 3 1 2 3 1 2 3 1 2 3]\nWorldEnd\n";

int countOf(const std::string &text, const std::string &part) {
    int count = 0;
    for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; ++at)
        ++count;
    return count;
}

TEST(ArrayBounds, NearestElementsAreTakenAndPlacesNamedOnce) {
    for (const char *lanes : {"1", "16"})
        for (const char *integrator : {"path", "classic"}) {
            ScratchFolder folder;
            folder.write("pick.h", "float pick(float from[2]; float at) { return from[at]; }\n");
            folder.write("t.sl", shader);
            const Outcome run =
                runCandela({folder.write("scene.rib", scene), "--quiet", "--lanes", lanes,
                            "--integrator", integrator, "--output-dir", folder.path()});
            EXPECT_EQ(run.status, 0) << run.text();
            for (int line : {9, 10, 11, 12, 13, 14})
                EXPECT_EQ(countOf(run.err, "t.sl:" + std::to_string(line) + ":"), 1) << line << "\n"
                                                                                     << run.text();
            EXPECT_EQ(countOf(run.err, "pick.h:1:"), 1) << run.text();
            EXPECT_EQ(countOf(run.err, "outside the array"), 7) << run.text();

            std::string problem;
            const auto picture = readPicture(folder.path("out.exr"), problem);
            ASSERT_TRUE(picture) << problem;
            const auto &red = picture->find("R")->values, &green = picture->find("G")->values,
                       &blue = picture->find("B")->values;
            for (std::size_t i = 0; i < red.size(); ++i) {
                EXPECT_EQ(green[i], 1);
                EXPECT_EQ(red[i], (blue[i] + 1) / 8);
            }
        }
}

TEST(ArrayBounds, NothingIsSaidWhereIndicesAreGuarded) {
    ScratchFolder folder;
    folder.write("t.sl", "surface t() {\n float a[4] = {1, 1, 1, 1};\n float index = 9 * u - 3;\n"
                         " float x = 1;\n if (index >= 0 && index < 4) x = a[index];\n"
                         " Oi = 1; Ci = x;\n}\n");
    const Outcome run =
        runCandela({folder.write("scene.rib", scene), "--quiet", "--output-dir", folder.path()});
    EXPECT_EQ(run.status, 0) << run.text();
    EXPECT_FALSE(run.says("outside the array")) << run.text();
}

} // namespace
} // namespace candela::test
