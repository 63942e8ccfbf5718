// SPDX-License-Identifier: Apache-2.0
// `candela info`, `candela run`, and what `candela compile` says to authors.
#include "image/picture_file.h"
#include "tests/support/program.h"
#include "tests/support/scratch_folder.h"

#include <gtest/gtest.h>
#include <sstream>

namespace candela::test {
namespace {

bool has(const std::string &text, const std::string &part) {
    return text.find(part) != std::string::npos;
}

TEST(InfoVerb, TellsParametersProofsAndEntryPoints) {
    ScratchFolder folder;
    const std::string file = folder.write(
        "shiny.sl", "/* A test. */\n"
                    "surface shiny(float Kd = .5; /* albedo */ float Ks = 1 - Kd;\n"
                    "              point at = point \"world\" (1, 2, 3); string map = \"a.tx\";\n"
                    "              output varying color aov = 0; float k[2] = {1, 2};)\n"
                    "{\n"
                    "    aov = Kd * diffuse(N) + occlusion(P, N);\n"
                    "    Oi = Os;\n"
                    "    Ci = aov * Ks * k[1] + xcomp(at);\n"
                    "}\n");
    const Outcome run = runCandela({"info", file});
    EXPECT_EQ(run.status, 0) << run.text();
    for (const char *part :
         {"surface shiny  (", "A test.", "float Kd = 0.5  -- albedo",
          "float Ks = computed where the shader starts", "point at = \"world\" (1, 2, 3)",
          "string map = \"a.tx\"", "output varying color aov = (0, 0, 0)", "float k[2] = { 1, 2 }",
          "affine in the light: yes", "opaque where Os is 1: yes", "shade ", "asks occlusion"})
        EXPECT_TRUE(has(run.out, part)) << part << "\n" << run.out;
    EXPECT_TRUE(has(runCandela({"info", "plastic"}).out, "surface plastic  ("));
}

TEST(InfoVerb, SaysWhatIsWrong) {
    const Outcome run = runCandela({"info", "nosuchshader"});
    EXPECT_EQ(run.status, 1);
    EXPECT_TRUE(run.says("no shader \"nosuchshader\"")) << run.err;
    EXPECT_EQ(runCandela({"info"}).status, 2);
}

/// Numbers of a line of `candela run`.
std::vector<double> numbersOf(const std::string &text, int line) {
    std::istringstream lines(text);
    std::string one;
    for (int k = 0; k <= line; ++k)
        std::getline(lines, one);
    std::istringstream words(one);
    std::vector<double> numbers;
    for (double number; words >> number;)
        numbers.push_back(number);
    return numbers;
}

TEST(RunVerb, PrintsValues) {
    ScratchFolder folder;
    const std::string file = folder.write(
        "ramp.sl", "surface ramp(float scale = 1; output varying float twice = 0;)\n"
                   "{ twice = 2 * u; Oi = .5; Ci = scale * color(u, v, comp(diffuse(N), 0)); }\n");
    const Outcome run = runCandela({"run", file, "scale=4", "--size", "4x2"});
    EXPECT_EQ(run.status, 0) << run.text();
    EXPECT_TRUE(run.out.starts_with("# x y Ci.0 Ci.1 Ci.2 Oi.0 Oi.1 Oi.2 twice\n")) << run.out;
    EXPECT_EQ(numbersOf(run.out, 3), (std::vector<double>{2, 0, 2.5, 1, 4, .5, .5, .5, 1.25}));
    EXPECT_EQ(runCandela({"run", file, "scale=4", "--size", "4x2", "--lanes", "1"}).out, run.out);
}

TEST(RunVerb, WritesPictures) {
    ScratchFolder folder;
    const std::string file = folder.write(
        "ramp.sl",
        "surface ramp(output varying float twice = 0;) { twice = 2 * u; Oi = 1; Ci = v; }\n");
    const std::string picture = folder.path("out.exr");
    const Outcome run = runCandela({"run", file, "--size", "4x2", "-o", picture});
    EXPECT_EQ(run.status, 0) << run.text();
    std::string problem;
    const auto found = readPicture(picture, problem);
    ASSERT_TRUE(found) << problem;
    ASSERT_TRUE(found->find("R") && found->find("twice") && found->find("Oi.G"));
    EXPECT_EQ(found->find("R")->values[0], .25f);
    EXPECT_EQ(found->find("twice")->values[3], 1.75f);
    EXPECT_EQ(runCandela({"run", file, "-o", folder.path("out.png"), "--show", "twice"}).status, 0);
    EXPECT_TRUE(folder.has("out.png"));
}

TEST(RunVerb, OtherKinds) {
    const Outcome light = runCandela({"run", "pointlight", "from=0,0,-2", "--size", "1x1"});
    EXPECT_EQ(light.status, 0) << light.text();
    EXPECT_EQ(numbersOf(light.out, 1), (std::vector<double>{0, 0, 0, 0, 2, .25, .25, .25}));
    const Outcome imager = runCandela({"run", "background", "--size", "2x1"});
    EXPECT_EQ(imager.status, 0) << imager.text();
}

TEST(RunVerb, SaysWhatIsWrong) {
    EXPECT_EQ(runCandela({"run", "nosuchshader"}).status, 1);
    const Outcome parameter = runCandela({"run", "plastic", "Kdd=1"});
    EXPECT_EQ(parameter.status, 1);
    EXPECT_TRUE(parameter.says("did you mean 'Kd'?")) << parameter.err;
    EXPECT_EQ(runCandela({"run", "plastic", "--size", "0x3"}).status, 2);
    EXPECT_EQ(runCandela({"run"}).status, 2);
}

TEST(CompileVerbHints, AreForAuthors) {
    ScratchFolder folder;
    const std::string file = folder.write(
        "loose.sl",
        "surface loose(float unused = 1) { float a, b = 2; Ci = a + sin(90); Oi = Os; }\n");
    const Outcome compiled = runCandela({"compile", "--quiet", file});
    EXPECT_EQ(compiled.status, 0);
    for (const char *part : {"parameter unused is never used", "variable b is never used",
                             "variable a is read, but never set", "looks like degrees"})
        EXPECT_TRUE(compiled.says(part)) << part << "\n" << compiled.err;
    const std::string rib = folder.write("scene.rib", "Format 4 4 1\nDisplay \"o.exr\" \"openexr\" "
                                                      "\"rgb\"\nWorldBegin\nSurface \"loose\"\n"
                                                      "Translate 0 0 3\nSphere 1 -1 1 360\n"
                                                      "WorldEnd\n");
    const Outcome rendered = runCandela({rib, "--quiet", "--output-dir", folder.path()});
    EXPECT_EQ(rendered.status, 0);
    EXPECT_EQ(rendered.err, "") << "while rendering, hints are silent";
}

TEST(CompileVerbDepfile, NamesAllThatWasRead) {
    ScratchFolder folder;
    folder.write("inc/body.h", "Ci = 1;\n");
    const std::string file =
        folder.write("with space.sl", "surface s() {\n#include \"body.h\"\nOi = 1; }\n");
    const Outcome run = runCandela({"compile", "--emit", "ir", "-o", folder.path("s.ir"), "-I",
                                    folder.path("inc"), "--depfile", folder.path("s.d"), file});
    EXPECT_EQ(run.status, 0) << run.text();
    EXPECT_EQ(folder.read("s.d"), folder.path("s.ir") + ": \\\n  " +
                                      folder.path("with\\ space.sl") + " \\\n  " +
                                      folder.path("inc/body.h") + "\n");
}

} // namespace
} // namespace candela::test
