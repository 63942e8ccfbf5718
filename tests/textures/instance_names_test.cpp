// SPDX-License-Identifier: Apache-2.0
// Instances of one shader that name pictures of their own: they share code and batches, and each
// gets what it has named.
#include "tests/textures/pictures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <sstream>

namespace candela::test {
namespace {

/// Says what it sees in the picture that it is given, and where it is.
const char *const named = R"(
surface named(string map = ""; varying float scale = 1;) {
    float seen = -1;
    if (map != "")
        seen = float texture(map, .5, .5);
    printf("%s:%.2f:%.2f\n", map, scale * seen, zcomp(transform("world", P)));
    Ci = 0; Oi = 1;
})";
/// Lifts the surface by what the picture says.
const char *const lifting = R"(
displacement lifting(string heights = "";) {
    P += float texture(heights, .5, .5) * vector "world" (0, 0, 1);
})";

void write(const ScratchFolder &folder) {
    folder.write("named.sl", named);
    folder.write("lifting.sl", lifting);
    for (const auto &[name, value] : {std::pair("a.exr", .25f), {"b.exr", .5f}, {"c.exr", .75f}})
        writeExr(folder, name, 8, 8, {"Y"}, [value = value](int, int, int) { return value; });
}

std::string square(int column, const std::string &attributes) {
    return "AttributeBegin\n" + attributes + "\nTranslate " + std::to_string(column) +
           " 0 0\nPatch \"bilinear\" \"P\" [0 1 0  1 1 0  0 0 0  1 0 0]\nAttributeEnd\n";
}
std::string surface(const std::string &map) {
    return "Surface \"named\" \"map\" [\"" + map + "\"]";
}

/// Eight unit squares side by side, a pixel each; gives all lines that are said, each once.
Outcome render(const ScratchFolder &folder, const std::string &world, const char *lanes,
               const char *integrator, const std::string &options = "") {
    const std::string scene =
        folder.write("scene.rib", options +
                                      "Format 8 1 1 PixelSamples 2 2 PixelFilter \"box\" 1 1\n"
                                      "Display \"named.exr\" \"openexr\" \"rgb\"\n"
                                      "Projection \"orthographic\" ScreenWindow 0 8 0 1\n"
                                      "Translate 0 0 3\nWorldBegin\n" +
                                      world + "WorldEnd\n");
    return runCandela({"--quiet", "--lanes", lanes, "--integrator", integrator, "--output-dir",
                       folder.path(), scene});
}

std::set<std::string> linesOf(const std::string &text) {
    std::istringstream stream(text);
    std::set<std::string> lines;
    for (std::string line; std::getline(stream, line);)
        lines.insert(line);
    return lines;
}

int occurrences(const std::string &text, const std::string &word) {
    int count = 0;
    for (std::size_t at = 0; (at = text.find(word, at)) != std::string::npos; ++at)
        ++count;
    return count;
}

/// For every width and integrator.
void expectLines(const ScratchFolder &folder, const std::string &world,
                 const std::set<std::string> &expected, const std::string &options = "") {
    for (const char *lanes : {"1", "16"})
        for (const char *integrator : {"classic", "path"}) {
            const Outcome run = render(folder, world, lanes, integrator, options);
            EXPECT_EQ(run.status, 0) << run.text();
            EXPECT_EQ(linesOf(run.out), expected) << lanes << " " << integrator << run.err;
        }
}

TEST(InstanceNames, OfOneBatchAreEachLookedUp) {
    ScratchFolder folder;
    write(folder);
    // Objects bring theirs along, mirrored too; a string of the text is a constant.
    const std::string world = "ObjectBegin 1\n" + square(0, surface("c.exr")) + "ObjectEnd\n" +
                              square(0, surface("a.exr")) + square(1, surface("b.exr")) +
                              square(2, surface("a.exr")) + square(3, surface("")) +
                              square(4, "Surface \"named\"") +
                              "AttributeBegin Translate 5 0 0 ObjectInstance 1 AttributeEnd\n"
                              "AttributeBegin Translate 7 0 0 Scale -1 1 1 Sides 2\n"
                              "ObjectInstance 1 AttributeEnd\n" +
                              square(7, "Surface \"named\" \"map\" [\"b.exr\"] \"scale\" [2]");
    expectLines(folder, world,
                {"a.exr:0.25:0.00", "b.exr:0.50:0.00", ":-1.00:0.00", "c.exr:0.75:0.00",
                 "b.exr:1.00:0.00"});
}

TEST(InstanceNames, OfWhatIsMissingAreEachWarnedOfOnce) {
    ScratchFolder folder;
    write(folder);
    std::string world = square(0, surface("a.exr"));
    for (int k = 1; k < 8; ++k)
        world += square(k, surface("missing" + std::to_string(k % 4) + ".tx"));
    for (const char *lanes : {"1", "16"}) {
        const Outcome run = render(folder, world, lanes, "classic");
        EXPECT_EQ(run.status, 0) << run.text();
        for (int k = 0; k < 4; ++k) {
            const std::string name = "missing" + std::to_string(k) + ".tx";
            EXPECT_EQ(occurrences(run.err, "texture \"" + name + "\": there is no such file"), 1)
                << run.err;
            EXPECT_EQ(linesOf(run.out).count(name + ":0.00:0.00"), 1u) << run.out;
        }
        EXPECT_TRUE(run.says("named.sl:5: warning: texture")) << run.err;
    }
}

TEST(InstanceNames, MoveEachSurfaceByItsOwnPicture) {
    ScratchFolder folder;
    write(folder);
    const auto lifted = [&](const char *heights) {
        return "Attribute \"displacementbound\" \"sphere\" [1] Displacement \"lifting\" "
               "\"string heights\" [\"" +
               std::string(heights) + "\"] " + surface("a.exr");
    };
    expectLines(folder,
                square(0, lifted("b.exr")) + square(2, lifted("c.exr")) + // Else their edges meet.
                    square(4, surface("b.exr")),
                {"a.exr:0.25:0.50", "a.exr:0.25:0.75", "b.exr:0.50:0.00"});
}

/// Numbers go from one value to the other; a string stays what it is when the shutter opens.
TEST(InstanceNames, StayWhileOtherParametersMove) {
    ScratchFolder folder;
    write(folder);
    const std::string moving =
        "MotionBegin [0 1]\nSurface \"named\" \"map\" [\"b.exr\"] \"scale\" [2]\n"
        "Surface \"named\" \"map\" [\"c.exr\"] \"scale\" [2]\nMotionEnd\n"
        "Translate 0 0 0 MotionBegin [0 1] Translate 0 0 0 Translate 0 0 0 MotionEnd";
    expectLines(folder, square(0, surface("a.exr")) + square(1, moving),
                {"a.exr:0.25:0.00", "b.exr:1.00:0.00"}, "Shutter 0 1\n");
}

} // namespace
} // namespace candela::test
