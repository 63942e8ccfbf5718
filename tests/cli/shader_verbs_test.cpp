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

TEST(InfoVerb, TellsWhatIsProvedOfOtherKinds) {
    ScratchFolder folder;
    const std::string fog = folder.write("fog.sl", "volume fog() { Ci *= .5; Oi *= .5; }\n");
    const std::string lit =
        folder.write("lit.sl", "volume lit() {\nilluminance(P) Oi += Cl;\nCi = Ci * Ci; }\n");
    const std::string bump = folder.write("bump.sl", "displacement bump() { P += u * N; }\n");
    const std::string said = runCandela({"info", fog, lit, bump}).out;
    for (const char *part : {"affine in what there is at its end: yes\n    asks for light: no",
                             "affine in what there is at its end: no (line 3)\n    asks for light: "
                             "yes",
                             "proofs\n    moves P: yes\n    derivatives of P known: yes"})
        EXPECT_TRUE(has(said, part)) << part << "\n" << said;
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

TEST(RunVerb, TellsBoundsOverBoxes) {
    ScratchFolder folder;
    const std::string file = folder.write(
        "edge.sl", "surface edge() { Oi = 1; Ci = s + .5 * step(.6, t) * diffuse(N); }\n");
    const Outcome run = runCandela({"run", "--bounds", file, "--size", "2x2"});
    EXPECT_EQ(run.status, 0) << run.text();
    EXPECT_TRUE(has(run.out, " reflectance_tolerance.0 ")) << run.out;
    EXPECT_TRUE(has(run.out, " Ce_deviation.2 ")) << run.out;
    // The upper boxes have no step, the lower ones one of .5 in the reflectance.
    const std::vector<double> upper = numbersOf(run.out, 1), lower = numbersOf(run.out, 3);
    ASSERT_GT(upper.size(), 30u);
    constexpr std::size_t tolerance = 2 + 9, deviation = 2 + 12, CeByU = 2 + 15 + 3;
    EXPECT_NEAR(upper[tolerance], 0, 1e-4);
    EXPECT_NEAR(lower[tolerance], .5, 1e-3);
    EXPECT_NEAR(lower[deviation], .5, 1e-3);
    EXPECT_NEAR(lower[CeByU], 1, 1e-6);
    const std::string picture = folder.path("out.png");
    EXPECT_EQ(runCandela({"run", "--bounds", file, "-o", picture}).status, 0);
    const Outcome light = runCandela({"run", "--bounds", "pointlight"});
    EXPECT_EQ(light.status, 1);
    EXPECT_TRUE(has(light.err, "no surface shader")) << light.err;
}

TEST(InfoVerb, TellsWhereBoundsComeFrom) {
    ScratchFolder folder;
    const auto said = [&](const std::string &body) {
        return runCandela({"info", folder.write("one.sl", "surface one()\n{\n" + body + "}\n")})
            .out;
    };
    EXPECT_TRUE(has(said("Ci = noise(P);\n"), "bounds over a box: derived\n"));
    EXPECT_TRUE(
        has(said("Ci = s; TCiDu = 0; TCiDv = 0;\n"), "bounds over a box: given by the shader"));
    EXPECT_TRUE(has(said("Ci = s;\nCi *= texture(\"a.tif\");\n"),
                    "bounds over a box: derived; infinite where these reach: texture() (line 4)"));
    EXPECT_TRUE(has(runCandela({"info", "pointlight"}).out, "bounds over a box: derived"));
}

TEST(RunVerb, OtherKinds) {
    const Outcome light = runCandela({"run", "pointlight", "from=0,0,-2", "--size", "1x1"});
    EXPECT_EQ(light.status, 0) << light.text();
    EXPECT_EQ(numbersOf(light.out, 1), (std::vector<double>{0, 0, 0, 0, 2, .25, .25, .25}));
    const Outcome imager = runCandela({"run", "background", "--size", "2x1"});
    EXPECT_EQ(imager.status, 0) << imager.text();
}

/// One of each kind, through each verb that takes shaders: an answer or a sentence.
TEST(ShaderVerbs, TakeEveryKind) {
    ScratchFolder folder;
    const char *kinds[][2] = {{"surface", "Ci = u; Oi = 1;"},
                              {"light", "solar(vector(0, 0, 1), 0) Cl = 1;"},
                              {"volume", "Ci *= .5; Oi *= .5;"},
                              {"displacement", "P += .1 * N; N = calculatenormal(P);"},
                              {"imager", "Ci = 1; alpha = 1;"},
                              {"transformation", "P += 1;"},
                              {"filter", "setimage(\"Ci\", 0, 0, 1);"}};
    for (const auto &[kind, text] : kinds) {
        const std::string name = std::string("some_") + kind;
        const std::string file = folder.write(name + ".sl", std::string(kind) + " " + name +
                                                                "(float k = 1) { " + text + " }\n");
        EXPECT_EQ(runCandela({"compile", "--quiet", file}).status, 0) << kind;
        EXPECT_EQ(runCandela({"info", file}).status, 0) << kind;
        const bool isFilter = std::string(kind) == "filter";
        for (const std::vector<std::string> &how :
             {std::vector<std::string>{"run", file, "--size", "2x1"},
              {"run", file, "--size", "2x1", "--lanes", "1"}}) {
            const Outcome run = runCandela(how);
            EXPECT_EQ(run.status, isFilter ? 1 : 0) << kind << run.text();
            EXPECT_EQ(runCandela({"run", file, "-o", folder.path("shown.png")}).status,
                      isFilter ? 1 : 0)
                << kind;
            EXPECT_EQ(run.says("candela filter IN OUT -f some_filter"), isFilter) << run.err;
        }
    }
}

TEST(RunVerb, NamesEachColumnOnce) {
    ScratchFolder folder;
    const std::string file =
        folder.write("bump.sl", "displacement bump() { P += u * N; N = calculatenormal(P); }\n");
    const Outcome run = runCandela({"run", file, "--size", "2x1"});
    EXPECT_EQ(run.status, 0) << run.text();
    EXPECT_TRUE(run.out.starts_with("# x y P.0 P.1 P.2 N.0 N.1 N.2 dPdu.0 dPdu.1 dPdu.2 dPdv.0 "
                                    "dPdv.1 dPdv.2\n"))
        << run.out;
    EXPECT_EQ(numbersOf(run.out, 1)[4], -.25) << run.out; // P.z
    EXPECT_EQ(numbersOf(run.out, 1)[10], -1) << run.out;  // dPdu.z
}

TEST(RunVerb, LooksForTextures) {
    ScratchFolder folder;
    const std::string file = folder.write(
        "shown.sl", "surface shown() { Oi = 1; Ci = texture(\"grey.exr\", .5, .5); }\n");
    const std::string grey = folder.write("grey.sl", "surface grey() { Oi = 1; Ci = .25; }\n");
    EXPECT_EQ(runCandela({"run", grey, "--size", "8x8", "-o", folder.path("grey.exr")}).status, 0);
    const Outcome run = runCandela({"run", file, "--size", "1x1", "--texture-path", folder.path()});
    EXPECT_EQ(run.status, 0) << run.text();
    EXPECT_NEAR(numbersOf(run.out, 1)[2], .25, 1e-3) << run.text();
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
