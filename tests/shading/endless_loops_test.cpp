// SPDX-License-Identifier: Apache-2.0
// Loops that do not end are ended where they do not: those points are black, their line is named
// once, all else is as it would be.
#include "image/picture_file.h"
#include "tests/support/program.h"
#include "tests/support/scratch_folder.h"

#include <gtest/gtest.h>

namespace candela::test {
namespace {

struct Endless {
    const char *name;
    const char *surface;
    const char *light;      ///< Of the light that is there; null = a constant one.
    const char *place;      ///< What names the loop.
    bool (*isBlack)(int x); ///< Of 16 columns of pixels.
};

bool all(int) { return true; }
bool none(int) { return false; }
bool rightHalf(int x) { return x >= 8; }

const char *const lit = "surface t() {\n normal n = faceforward(normalize(N), I);\n Oi = 1;\n"
                        " Ci = 0;\n illuminance(P, n, PI / 2) { Ci += Cl * (normalize(L) . n); }\n"
                        " Ci += 1;\n}\n";

const Endless endless[] = {
    {"Everywhere", "surface t() {\n float x = 1;\n while (x > 0) x += u;\n Oi = 1; Ci = x;\n}\n",
     nullptr, "t.sl:3:", all},
    {"WithoutCondition", "surface t() {\n float x = 1;\n while (1) x += u;\n Oi = 1; Ci = x;\n}\n",
     nullptr, "t.sl:3:", all},
    {"InSomeLanes", "surface t() {\n float x = 1;\n while (u > 0.5) x += 1;\n Oi = 1; Ci = x;\n}\n",
     nullptr, "t.sl:3:", rightHalf},
    {"InAFunction",
     "float f(float a) {\n float x = 1;\n while (a > 0.5) x += 1;\n return x;\n}\nsurface t() {\n "
     "Oi = 1; Ci = f(u);\n}\n",
     nullptr, "t.sl:3:", rightHalf},
    {"InsideOfAnother",
     "surface t() {\n float x = 0, i;\n while (x >= 0)\n  for (i = 0; i < 500 * (1 + u); i += 1) x "
     "+= v;\n Oi = 1; Ci = 1 + x;\n}\n",
     nullptr, "t.sl:4:", all},
    {"InsideOfAnotherInSomeLanes",
     "surface t() {\n float x = 0, i = 0;\n for (i = 0; i < 3; i += u * 9)\n  while (u > 0.5 && x "
     ">= "
     "0) x += 1;\n Oi = 1; Ci = 1 + x;\n}\n",
     nullptr, "t.sl:4:", rightHalf},
    {"InALightLoop",
     "surface t() {\n normal n = faceforward(normalize(N), I);\n float x = 1;\n Oi = 1;\n Ci = "
     "1;\n "
     "illuminance(P, n, PI / 2) {\n  while (u > 0.5) x += 1;\n  Ci += x * Cl * (normalize(L) . "
     "n); }\n}\n",
     nullptr, "t.sl:7:", rightHalf},
    {"BesideLight",
     "surface t() {\n normal n = faceforward(normalize(N), I);\n float x = 1;\n Oi = 1;\n"
     " while (u > 0.5) x += 1;\n Ci = diffuse(n) + x * specular(n, -normalize(I), .1);\n}\n",
     nullptr, "t.sl:5:", rightHalf},
    {"BesideEveryKindOfLight",
     "surface t() {\n normal n = faceforward(normalize(N), I);\n float x = 0;\n Oi = 1;\n"
     " while (u > 0.5) x += 1;\n Ci = ambient() + diffuse(n) + .2 * trace(P, n);\n"
     " illuminance(P, n, PI / 2) Ci += Cl * (normalize(L) . n);\n Ci += 1 + x;\n}\n",
     nullptr, "t.sl:5:", rightHalf},
    {"InALight", lit,
     "light l() {\n float x = 1;\n solar(vector(0, 0, 1), 0) {\n  while (x > 0) x += 1;\n  Cl = "
     "x;\n }\n}\n",
     "l.sl:4:", none},
};

class EndlessLoops : public testing::TestWithParam<Endless> {};

TEST_P(EndlessLoops, AreEndedAtTheirPoints) {
    const Endless &test = GetParam();
    for (const char *lanes : {"1", "16"})
        for (const char *integrator : {"path", "classic"}) {
            ScratchFolder folder;
            folder.write("t.sl", test.surface);
            folder.write("l.sl", test.light
                                     ? test.light
                                     : "light l() {\n solar(vector(0, 0, 1), 0) Cl = 1;\n}\n");
            RunSettings settings;
            settings.secondsAllowed = 30;
            const Outcome run = runCandela(
                {folder.write("scene.rib",
                              "Format 16 2 1\nPixelSamples 2 2\nPixelFilter \"box\" 1 1\n"
                              "Option \"shading\" \"integer loopturns\" 20000\n"
                              "Display \"out.exr\" \"openexr\" \"rgba\"\n"
                              "Projection \"orthographic\"\nScreenWindow -1 1 -1 1\n"
                              "WorldBegin\nLightSource \"l\" 1\nSurface \"t\"\n"
                              "Patch \"bilinear\" \"P\" [-1 1 1 1 1 1 -1 -1 1 1 -1 1]\nWorldEnd\n"),
                 "--quiet", "--lanes", lanes, "--integrator", integrator, "--output-dir",
                 folder.path()},
                settings);
            const std::string what =
                std::string(lanes) + " lanes, " + integrator + "\n" + run.text();
            EXPECT_EQ(run.signal, 0) << what;
            EXPECT_EQ(run.status, 1) << what;
            const std::size_t said = run.err.find(test.place);
            EXPECT_NE(said, std::string::npos) << what;
            EXPECT_EQ(run.err.find(test.place, said + 1), std::string::npos) << what;
            EXPECT_TRUE(run.says("does not end")) << what;
            std::string problem;
            const auto picture = readPicture(folder.path("out.exr"), problem);
            ASSERT_TRUE(picture) << problem;
            const auto &red = picture->find("R")->values, &alpha = picture->find("A")->values;
            for (std::size_t i = 0; i < red.size(); ++i) {
                EXPECT_EQ(red[i] == 0, test.isBlack(int(i % 16))) << i << " " << red[i] << what;
                EXPECT_EQ(alpha[i], 1) << i << what;
            }
        }
}

INSTANTIATE_TEST_SUITE_P(All, EndlessLoops, testing::ValuesIn(endless),
                         [](const auto &info) { return std::string(info.param.name); });

} // namespace
} // namespace candela::test
