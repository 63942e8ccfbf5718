// SPDX-License-Identifier: Apache-2.0
// printf() in shaders: each point that is shaded speaks once, on standard output.
#include "tests/support/program.h"
#include "tests/support/scratch_folder.h"

#include <gtest/gtest.h>
#include <set>
#include <sstream>

namespace candela::test {
namespace {

/// Eight by eight points and a margin of a square that fills the view, with nothing else to be lit
/// by or to hit.
std::string frame(const std::string &integrator, const std::string &parameters) {
    return "FrameBegin 1\nOption \"render\" \"string integrator\" [\"" + integrator +
           "\"]\nFormat 8 8 1\nPixelFilter \"box\" 1 1\nPixelSamples 1 1\n"
           "Display \"out.exr\" \"openexr\" \"rgb\"\nProjection \"orthographic\"\n"
           "ScreenWindow -.2 .2 -.2 .2\nWorldBegin\n"
           "LightSource \"distantlight\" 1 \"point from\" [0 0 0] \"point to\" [0 0 1]\n"
           "Surface \"talking\" " +
           parameters +
           "\nTranslate 0 0 1\nPolygon \"P\" [-.5 -.5 0 .5 -.5 0 .5 .5 0 -.5 .5 0]\n"
           "WorldEnd\nFrameEnd\n";
}

std::string outputOf(const std::string &rib) {
    ScratchFolder folder;
    const Outcome run =
        runCandela({folder.write("scene.rib", rib), "--quiet", "--shader-path",
                    CANDELA_SOURCE_DIR "/tests/shading/shaders", "--output-dir", folder.path()});
    EXPECT_EQ(run.status, 0) << run.text();
    return run.out;
}

/// Points are thrown at random, so that no two are shaded at the same place.
void expectPointsSpeakOnce(const std::string &rib) {
    std::istringstream lines(outputOf(rib));
    std::set<std::string> places;
    for (std::string line; std::getline(lines, line);) {
        EXPECT_TRUE(line.starts_with("shaded at ")) << line;
        EXPECT_TRUE(places.insert(line).second) << line << " twice";
    }
    EXPECT_GE(places.size(), 64u);
}

TEST(Print, EachShadedPointSpeaksOnce) {
    for (const char *integrator : {"path", "classic"})
        expectPointsSpeakOnce(frame(integrator, ""));
}

// They are asked Shade besides Prepare.
TEST(Print, ShadersThatAreNotAffineToo) {
    for (const char *integrator : {"path", "classic"})
        expectPointsSpeakOnce(frame(integrator, "\"float threshold\" [.5]"));
}

/// What the shader of these statements says, sorted.
std::set<std::string> linesOf(const std::string &integrator, const std::string &body,
                              std::string &errors) {
    ScratchFolder folder;
    folder.write("says.sl", "surface says() {\n normal n = faceforward(normalize(N), I);\n Oi = "
                            "1;\n Ci = .5 * diffuse(n);\n" +
                                body + "\n}\n");
    const Outcome run = runCandela(
        {folder.write("scene.rib",
                      "Format 1 1 1\nPixelSamples 1 1\nPixelFilter \"box\" 1 1\nDisplay "
                      "\"out.exr\" \"openexr\" \"rgb\"\nProjection \"orthographic\"\n"
                      "ScreenWindow -1 1 -1 1\nWorldBegin\n"
                      "LightSource \"distantlight\" 1 \"intensity\" [3]\n"
                      "LightSource \"distantlight\" 2 \"intensity\" [5]\nSurface \"says\"\n"
                      "Polygon \"P\" [-9 -9 1 9 -9 1 9 9 1 -9 9 1]\nWorldEnd\n"),
         "--quiet", "--integrator", integrator, "--output-dir", folder.path()});
    EXPECT_EQ(run.status, 0) << run.text();
    errors = run.err;
    std::istringstream all(run.out);
    std::set<std::string> lines;
    for (std::string line; std::getline(all, line);)
        if (!line.starts_with("after "))
            lines.insert(line);
    return lines;
}

using Lines = std::set<std::string>;

TEST(Print, LightIsToldWhereAllOfItIsThere) {
    const std::string loop = "illuminance(P, n, PI / 2) {\n  if (comp(Cl, 0) > 4) printf(\"bright "
                             "%c\\n\", Cl);\n  Ci += Cl * .1;\n }";
    const std::string sum =
        " color d = diffuse(n);\n if (comp(d, 0) > 1) printf(\"sum %c\\n\", d);";
    std::string errors;
    EXPECT_EQ(linesOf("classic", loop, errors), Lines{"bright 5.000000 5.000000 5.000000"});
    EXPECT_EQ(errors, "");
    EXPECT_EQ(linesOf("classic", sum, errors), Lines{"sum 8.000000 8.000000 8.000000"});
    EXPECT_EQ(linesOf("classic", " printf(\"here\\n\");", errors), Lines{"here"});
    for (const std::string &body : {loop, sum}) {
        EXPECT_EQ(linesOf("path", body, errors), Lines{});
        EXPECT_NE(errors.find("--integrator classic prints it lit"), std::string::npos) << errors;
    }
    EXPECT_EQ(linesOf("path", " printf(\"here\\n\");", errors), Lines{"here"});
    EXPECT_EQ(errors, "");
}

TEST(Print, WhatIsPrintedHasAnEnd) {
    ScratchFolder folder;
    folder.write("floods.sl",
                 "surface floods() { float k;\n"
                 "for (k = 0; k < 1000; k += 1) printf(\"%f of very much\\n\", k); Ci = 1; }");
    const Outcome run = runCandela(
        {folder.write("scene.rib",
                      "Format 64 64 1\nPixelFilter \"box\" 1 1\nPixelSamples 2 1\nWorldBegin\n"
                      "Surface \"floods\"\nPolygon \"P\" [-9 -9 1 9 -9 1 9 9 1 -9 9 1]\n"
                      "WorldEnd\n"),
         "--quiet", "--integrator", "classic", "--output-dir", folder.path()});
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_GT(run.out.size(), 16u << 20);
    EXPECT_LT(run.out.size(), (16u << 20) + 4096u);
    EXPECT_NE(run.err.find("shaders have printed 16777216 bytes"), std::string::npos) << run.err;
}

/// Which lights there are to choose from is found out in silence: lines come from the plane that is
/// lit alone.
TEST(Print, LightsThatAreProbedAreSilent) {
    const char *lights[] = {"light probe() { illuminate(point \"shader\" (0, 0, 0)) { Cl = 1; "
                            "printf(\"lit %p\\n\", Ps); } }",
                            "light probe() { solar(vector(0, 0, 1), 0) { Cl = 1; "
                            "printf(\"lit %p\\n\", Ps); } }",
                            "light probe() { illuminate(P, N, PI/2) { Cl = 1; "
                            "printf(\"lit %p\\n\", Ps); } }"};
    for (const std::string light : lights)
        for (const char *integrator : {"path", "classic"}) {
            const bool isArea = light.find("(P, N") != std::string::npos;
            ScratchFolder folder;
            folder.write("probe.sl", light);
            const std::string declared =
                isArea ? "AttributeBegin\nAreaLightSource \"probe\" 1\nPolygon \"P\" "
                         "[-1 -1 -1 -1 1 -1 1 1 -1 1 -1 -1]\nAttributeEnd\nIlluminate 1 1\n"
                       : "LightSource \"probe\" 1\n";
            const Outcome run = runCandela(
                {folder.write("scene.rib", "Option \"render\" \"string integrator\" [\"" +
                                               std::string(integrator) +
                                               "\"]\nFormat 1 1 1\nPixelSamples 1 1\n"
                                               "PixelFilter \"box\" 1 1\n"
                                               "Display \"out.exr\" \"openexr\" \"rgb\"\n"
                                               "Projection \"orthographic\"\nWorldBegin\n" +
                                               declared +
                                               "Surface \"matte\"\nTranslate 0 0 5\nPolygon \"P\" "
                                               "[-1 -1 0 1 -1 0 1 1 0 -1 1 0]\nWorldEnd\n"),
                 "--quiet", "--shader-path", folder.path(), "--output-dir", folder.path()});
            EXPECT_EQ(run.status, 0) << run.text();
            std::istringstream lines(run.out);
            int count = 0;
            for (std::string line; std::getline(lines, line); ++count) {
                float x = 0, y = 0, z = 0;
                ASSERT_EQ(std::sscanf(line.c_str(), "lit (%f, %f, %f)", &x, &y, &z) +
                              std::sscanf(line.c_str(), "lit %f %f %f", &x, &y, &z),
                          3)
                    << line;
                EXPECT_NEAR(z, 5, 1e-4) << light << line;
            }
            EXPECT_LT(count, 50) << light << integrator;
            EXPECT_TRUE(isArea || count > 0) << light << integrator;
        }
}

} // namespace
} // namespace candela::test
