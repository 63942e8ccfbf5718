// SPDX-License-Identifier: Apache-2.0
// What old shaders say in ways of their own: it means what it meant to them.
#include "tests/old_files/old_scene.h"

namespace candela::test {
namespace {

using OldShaders = OldScene;

/// The eye at the origin sees a wall at z = 4; rays from there meet another one at z = 2, which
/// shines (.25), and behind which nothing is.
const std::string walls =
    "Projection \"orthographic\"\nWorldBegin\nSurface \"asks\"\n"
    "Polygon \"P\" [-9 -9 4  -9 9 4  9 9 4  9 -9 4]\n"
    "Attribute \"visibility\" \"integer camera\" [0]\nSurface \"constant\"\nColor [.25 .25 .25]\n"
    "Polygon \"P\" [-9 -9 2  -9 9 2  9 9 2  9 -9 2]\nWorldEnd\n";

TEST_F(OldShaders, TraceIsADistanceWhereAFloatIsWanted) {
    struct {
        const char *statements;
        float red;
    } const cases[] = {
        {"float d = trace(P, vector (0, 0, -1)); c = color(d / 4, 0, 0);", .5f},
        {"float d = trace(P, vector (0, 0, -3)); c = color(d / 4, 0, 0);", .5f},
        {"float d = trace(P, vector (0, 0, 1)); c = d > 1e20 ? 1 : 0;", 1},
        {"c = trace(P, vector (0, 0, -1));", .25f},
        {"c = .5 * trace(P, vector (0, 0, -1));", .125f},
        {"c = comp(trace(P, vector (0, 0, -1)), 0);", .25f},
    };
    for (const auto &each : cases)
        for (const char *integrator : {"classic", "path"}) {
            folder_.write("asks.sl", "surface asks() { color c = 0; " +
                                         std::string(each.statements) + " Ci = c; Oi = 1; }\n");
            const Outcome run = render(head + walls, {"--integrator", integrator});
            EXPECT_EQ(run.status, 0) << run.text();
            EXPECT_NEAR(red(27), each.red, 1e-3f) << each.statements << integrator;
        }
}

/// A light whose statement has no braces, and a shadow map that is told where its light was.
TEST_F(OldShaders, LightsAreWhatTheyWere) {
    const std::string map = "FrameBegin 1\nFormat 64 64 1\nDisplay \"m.shd\" \"shadow\" \"z\"\n"
                            "Projection \"orthographic\"\nScreenWindow -9 9 -9 9\nWorldBegin\n"
                            "Polygon \"P\" [-9 -9 2  -9 9 2  0 9 2  0 -9 2]\nWorldEnd\nFrameEnd\n";
    struct {
        const char *text, *warning;
        float left, right;
    } const cases[] = {
        {"light lamp(float k = .5;) { solar(vector \"shader\" (0, 0, 1), 0)\nfloat a = k; Cl = a; "
         "}",
         "solar has no { }: all that follows in this block belongs to it", .5f, .5f},
        {"light lamp() { illuminate(point \"shader\" (0, 0, -1e4))\n"
         "  Cl = 1 - shadow(\"m.shd\", Ps, \"source\", point(0, 0, 0), point(1, 0, 0), "
         "point(0, 1, 0), point(1, 1, 0), \"samples\", 1); }",
         "", 0, 1},
    };
    for (const auto &each : cases) {
        folder_.write("lamp.sl", each.text);
        const Outcome run =
            render(map + "FrameBegin 2\n" + head +
                       "Projection \"orthographic\"\nScreenWindow -4 4 -4 4\nWorldBegin\n"
                       "LightSource \"lamp\" 1\n" +
                       wall + "WorldEnd\nFrameEnd\n",
                   {"--integrator", "classic"});
        EXPECT_EQ(run.status, 0) << run.text();
        EXPECT_EQ(run.err.empty(), !*each.warning) << run.text();
        EXPECT_TRUE(run.says(each.warning)) << run.text();
        EXPECT_NEAR(red(25), each.left, .01f) << each.text;
        EXPECT_NEAR(red(30), each.right, .01f) << each.text;
    }
}

/// Every material of material.h, lit straight from the front by white light of intensity 1, in
/// front of a mirror's surroundings that shine.
TEST_F(OldShaders, MaterialsOfTheHeaderAreWhatTheirNamesSay) {
    struct {
        const char *value;
        float least, most;
    } const cases[] = {
        {"MaterialMatte(Nf, .5, 1, .5)", .25f, .25f},
        {"MaterialPlastic(Nf, .5, 0, .5, 0, .1)", .25f, .25f},
        {"MaterialPlastic(Nf, .5, 0, .5, .5, .1)", .75f, .75f},
        {"MaterialRoughMetal(Nf, .5, 0, 0, 1, .1)", .5f, .5f},
        {"MaterialThinPlastic(Nf, -normalize(I), .5, 0, .5, .25, 0, .1)", .25f, .25f},
        {"MaterialShinyMetal(Nf, .5, 0, 0, 0, .1, 1, 0, ENVPARAMS)", .125f, .125f},
        {"MaterialShinyMetal(Nf, .5, 0, 0, 0, .1, 1, 0, 1, ENVPARAMS)", .125f, .125f},
        {"MaterialShinyPlastic(Nf, .5, 0, 0, 0, .1, 1, 0, 1.5, ENVPARAMS)", .01f, .01f},
        {"MaterialShinyPlastic(Nf, .5, 0, 1, 0, .1, 0, 0, 1.5, 1, ENVPARAMS)", .48f, .48f},
        {"MaterialClay(Nf, .5, 0, 1, 0)", .5f, .5f},
        {"MaterialClay(Nf, .5, 0, 1, .5)", .35f, .42f},
        {"MaterialCeramic(Nf, .5, 0, .5, .25, .1, .5)", .5f, .5f},
        {"MaterialGlass(Nf, .5, 0, 0, 0, .1, 1, 0, 0, 0, 1.5, 1, 0, 1, ENVPARAMS)", .01f, .01f},
    };
    for (const auto &each : cases) {
        folder_.write("made.sl", "#include \"material.h\"\n"
                                 "surface made(DECLARE_DEFAULTED_ENVPARAMS;) {\n"
                                 "  normal Nf = faceforward(normalize(N), I);\n"
                                 "  Ci = " +
                                     std::string(each.value) + "; Oi = 1; }\n");
        const Outcome run = render(
            head + "Projection \"orthographic\"\nScreenWindow -.01 .01 -.01 .01\nWorldBegin\n"
                   "LightSource \"distantlight\" 1 \"from\" [0 0 0] \"to\" [0 0 1]\n"
                   "Surface \"made\"\nPolygon \"P\" [-9 -9 4  -9 9 4  9 9 4  9 -9 4]\n"
                   "Attribute \"visibility\" \"integer camera\" [0] \"integer shadow\" [0]\n"
                   "Surface \"constant\"\nColor [.25 .25 .25]\n"
                   "Polygon \"P\" [-9 -9 2  -9 9 2  9 9 2  9 -9 2]\nWorldEnd\n",
            {"--integrator", "classic"});
        EXPECT_EQ(run.err, "") << each.value;
        EXPECT_GE(red(27), each.least - .002f) << each.value;
        EXPECT_LE(red(27), each.most + .002f) << each.value;
    }
}

} // namespace
} // namespace candela::test
