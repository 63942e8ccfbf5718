// SPDX-License-Identifier: Apache-2.0
// Scenes whose files are not all at hand, or are somewhere else than where they were once: what can
// be drawn is drawn, and what stands in for the rest is told.
#include "tests/old_files/old_scene.h"

#include <cmath>
#include <numbers>

namespace candela::test {
namespace {

using OldFiles = OldScene;

// The library's lights stand in, by what names and parameters tell: (0,0,4) is lit at right angles
// from (0,0,0) or along z.
TEST_F(OldFiles, LightsWithoutShadersHaveStandIns) {
    struct {
        const char *light, *standIn;
        float lit;
    } const cases[] = {
        {"\"nosuchlamp\" 1 \"intensity\" [.5]", "pointnofalloff", .5f},
        {"\"nosuchlamp\" 1 \"float intensity\" [.5] \"float decay\" [2]", "pointnofalloff", .5f},
        {"\"nosuchpoint\" 1 \"intensity\" [8] \"from\" [0 0 0]", "pointlight", .5f},
        {"\"nosuchsun\" 1 \"intensity\" [.5]", "distantlight", .5f},
        {"\"shaders/nosuch\" 1 \"intensity\" [.5] \"to\" [0 0 2]", "distantlight", .5f},
        {"\"nosuchspot\" 1 \"intensity\" [8] \"from\" [0 0 0] \"to\" [0 0 4]", "spotlight", .5f},
        {"\"nosuch\" 1 \"intensity\" [8] \"coneangle\" [.5]", "spotlight", .5f},
        {"\"nosuchenvironment\" 1 \"intensity\" [.5]", "ambientlight", .5f},
        {"\"nosuch\" 1 \"intensity\" [.5] \"lightcolor\" [.5 1 1]", "pointnofalloff", .25f},
    };
    for (const auto &each : cases)
        for (const char *integrator : {"classic", "path"}) {
            const Outcome run = render(head +
                                           "Projection \"perspective\" \"fov\" 5\nWorldBegin\n"
                                           "LightSource " +
                                           each.light + "\n" + wall + "WorldEnd\n",
                                       {"--integrator", integrator});
            EXPECT_EQ(run.status, 1) << each.light << run.text();
            EXPECT_TRUE(run.says("library's \"" + std::string(each.standIn) + "\" stands in"))
                << each.light << run.text();
            EXPECT_NEAR(red(27), each.lit, .02f) << each.light << integrator;
        }
}

// Those of PRMan 17 to 20, whose shaders no file brings along: a square of radiance 3, parallel to
// the wall at a distance of 1. By the contour of its quarters.
TEST_F(OldFiles, AreaLightsWithoutShadersSendTheirRadiance) {
    const float a = .5f / std::sqrt(1.25f);
    const float square = 4 / (2 * std::numbers::pi_v<float>)*2 * a * std::atan(a);
    struct {
        const char *name, *before, *light, *shape;
        float lit;
    } const cases[] = {
        {"plain", "",
         "\"PxrStdAreaLight\" \"lamp\" \"float intensity\" [1.5] \"float exposure\" [1]",
         "Geometry \"rectlight\"", 3 * square},
        {"colored", "",
         "\"lib/plausibleArealight\" \"lamp\" \"intensity\" [6] \"lightcolor\" [.5 1 1] "
         "\"string shape\" [\"rect\"] \"coneangle\" [20]",
         "Geometry \"rectlight\"", 3 * square},
        {"turned round", "Rotate 180 1 0 0\n",
         "\"plausibleArealight\" \"lamp\" \"float intensity\" [3]",
         "Sides 1\nReverseOrientation\nGeometry \"rectlight\"", 3 * square},
        {"turned away", "Rotate 180 1 0 0\n", "\"plausibleArealight\" \"lamp\" \"intensity\" [3]",
         "Geometry \"rectlight\"", 0},
        {"mirrored", "Scale -1 1 1\n", "\"GeoAreaLight\" \"lamp\" \"intensity\" [3]",
         "Geometry \"rectlight\"", 3 * square},
        {"a disk", "", "\"PxrAreaLight\" \"lamp\" \"intensity\" [3]", "Geometry \"disklight\"",
         3 * .25f / 1.25f},
        {"an instance", "ObjectBegin 1\nGeometry \"rectlight\"\nObjectEnd\n",
         "\"PxrStdAreaLight\" \"lamp\" \"intensity\" [3]", "ObjectInstance 1", 3 * square},
    };
    for (const auto &each : cases)
        for (const char *integrator : {"classic", "path"}) {
            SCOPED_TRACE(std::string(each.name) + " " + integrator);
            const Outcome run =
                render(head +
                           "Projection \"perspective\" \"fov\" 5\nWorldBegin\nAttributeBegin\n"
                           "Attribute \"visibility\" \"integer camera\" [0]\nTranslate 0 0 3\n" +
                           each.before + "Color [0 0 0]\nSurface \"matte\"\nAreaLightSource " +
                           each.light + "\n" + each.shape +
                           "\nAttributeEnd\nIlluminate \"lamp\" 1\n" + wall + "WorldEnd\n",
                       {"--integrator", integrator, "--spp", "256"});
            EXPECT_EQ(run.status, 1) << run.text();
            EXPECT_TRUE(run.says("library's \"arealight\" stands in")) << run.text();
            EXPECT_NEAR(red(27), each.lit, .03f * square + .02f * each.lit);
        }
}

// A block between light and wall: dark behind it, whoever finds its shadow.
TEST_F(OldFiles, ShadowMapsThatAreNotThereAreTraced) {
    const std::string block = "Color [0 0 0]\nAttributeBegin\n"
                              "Polygon \"P\" [.5 -9 2  .5 9 2  9 9 2  9 -9 2]\nAttributeEnd\n";
    struct {
        const char *name, *map;
        float dark;
        bool warns;
    } const cases[] = {{"missing", "nowhere.sm", 0, true},
                       {"raytrace", "raytrace", 0, false},
                       {"none asked for", "", .5f, false}};
    for (const auto &each : cases)
        for (const char *integrator : {"classic", "path"}) {
            if (!*each.map && std::string(integrator) == "path")
                continue; // There shadows come of themselves.
            const Outcome run =
                render(head +
                           "Projection \"orthographic\"\nScreenWindow -4 4 -4 4\nWorldBegin\n"
                           "LightSource \"shadowdistant\" 1 \"intensity\" [.5] \"shadowname\" [\"" +
                           each.map + "\"] \"from\" [-2 0 0] \"to\" [0 0 2]\n" + wall +
                           "AttributeBegin\nAttribute \"visibility\" \"integer camera\" [0]\n" +
                           block + "AttributeEnd\nWorldEnd\n",
                       {"--integrator", integrator});
            EXPECT_EQ(run.status, 0) << each.name << run.text();
            EXPECT_EQ(run.says("shadows by rays"), each.warns) << run.text();
            const float slant = std::sqrt(.5f); // The wall's cosine.
            EXPECT_NEAR(red(24), .5f * slant, .02f) << each.name << integrator;
            EXPECT_NEAR(red(31), each.dark * slant, .02f) << each.name << integrator;
        }
}

// Folders of other people and other systems: the last part of the name counts.
TEST_F(OldFiles, NamesOfOtherFoldersAreFoundHere) {
    folder_.write("part.rib", "Polygon \"P\" [-9 -9 4  -9 9 4  9 9 4  9 -9 4]\n");
    folder_.write("shaders/grey.sl", "surface grey() { Ci = color(.25, .25, .25); Oi = 1; }\n");
    for (const char *part : {"/home/somebody/models/part.rib", "C:\\\\models\\\\part.rib"})
        for (const char *shader : {"grey", "/usr/somebody/grey", "D:\\\\lib\\\\grey.slo"})
            for (const char *display : {"/tmp/somebody/out.exr", "C:\\\\out.exr", "../out.exr"}) {
                RunSettings elsewhere;
                elsewhere.folder = "/";
                const Outcome run =
                    render("Format 8 8 1\nDisplay \"" + std::string(display) +
                               "\" \"openexr\" \"rgb\"\nWorldBegin\nSurface \"" + shader +
                               "\"\nReadArchive \"" + part + "\"\nWorldEnd\n",
                           {}, elsewhere);
                EXPECT_EQ(run.status, 0) << run.text();
                EXPECT_NEAR(red(27), .25f, 1e-6f) << part << shader << display;
            }
}

// A scene read in another one's world brings its shapes alone.
TEST_F(OldFiles, WholeScenesMayBeArchives) {
    folder_.write("inner.rib", "FrameBegin 1\nDisplay \"inner.exr\" \"openexr\" \"rgb\"\n"
                               "WorldBegin\nColor [.25 0 0]\nAttributeBegin\n" +
                                   std::string("Polygon \"P\" [-9 -9 4  -9 9 4  0 9 4  0 -9 4]\n") +
                                   "WorldEnd\nFrameEnd\n");
    const std::string rest = "Polygon \"P\" [0 -9 4  0 9 4  9 9 4  9 -9 4]\nWorldEnd\n";
    for (const char *read :
         {"ReadArchive \"inner.rib\"\n",
          "Procedural \"DelayedReadArchive\" [\"inner.rib\"] [-9 9 -9 9 0 9]\n"}) {
        const Outcome run = render(head + "WorldBegin\nSurface \"constant\"\n" + read + rest);
        EXPECT_EQ(run.status, 1) << "its AttributeBegin is not closed" << run.text();
        EXPECT_NEAR(red(24), .25f, 1e-6f) << run.text();
        EXPECT_NEAR(red(31), 1, 1e-6f) << run.text();
        EXPECT_FALSE(folder_.has("inner.exr"));
    }
    // A world that its own file has forgotten to close is no archive's.
    const Outcome run = render(head + "WorldBegin\nSurface \"constant\"\nWorldBegin\n" + rest);
    EXPECT_TRUE(run.says("WorldBegin is not legal between")) << run.text();
    EXPECT_NEAR(red(31), 1, 1e-6f);
}

// Search paths are meant from where the scene lies, too.
TEST_F(OldFiles, SearchPathsCountFromTheScene) {
    folder_.write("lib/grey.sl", "surface grey() { Ci = color(.25, .25, .25); Oi = 1; }\n");
    folder_.write("models/part.rib", "Polygon \"P\" [-9 -9 4  -9 9 4  9 9 4  9 -9 4]\n");
    RunSettings elsewhere;
    elsewhere.folder = "/";
    for (const char *separator : {":", ";"}) {
        const Outcome run = render(head + "Option \"searchpath\" \"shader\" [\"nowhere" +
                                       separator + "./lib" + separator +
                                       "@\"]\nOption \"searchpath\" \"archive\" [\"models\"]\n"
                                       "WorldBegin\nSurface \"grey\"\n"
                                       "ReadArchive \"part.rib\"\nWorldEnd\n",
                                   {}, elsewhere);
        EXPECT_EQ(run.status, 0) << run.text();
        EXPECT_NEAR(red(27), .25f, 1e-6f) << separator;
    }
}

// Type "file" writes under the very name, and what makes textures finds it there.
TEST_F(OldFiles, FacesOfAnyNameMakeAnEnvironment) {
    folder_.write("mirrored.sl", "surface mirrored(string map = \"\";) {\n"
                                 "  Oi = 1; Ci = environment(map, vector(0, 0, 1)); }\n");
    std::string rib = "Projection \"perspective\" \"fov\" 90\n";
    for (const char *face : {"px", "nx", "py", "ny", "pz", "nz"})
        rib += "FrameBegin 1\nFormat 16 16 1\nDisplay \"env." + std::string(face) +
               "\" \"file\" \"rgb\"\nWorldBegin\nSurface \"constant\"\nColor [" +
               (face == std::string("pz") ? "1" : "0") +
               " 0 0]\nPolygon \"P\" [-9 -9 4  -9 9 4  9 9 4  9 -9 4]\nWorldEnd\nFrameEnd\n";
    rib += "MakeCubeFaceEnvironment \"env.px\" \"env.nx\" \"env.py\" \"env.ny\" \"env.pz\" "
           "\"env.nz\" \"all.env\" 90 \"gaussian\" 2 2\n" +
           head +
           "WorldBegin\nSurface \"mirrored\" \"string map\" [\"all.env\"]\n"
           "Polygon \"P\" [-9 -9 4  -9 9 4  9 9 4  9 -9 4]\nWorldEnd\n";
    const Outcome run = render(rib);
    EXPECT_EQ(run.status, 0) << run.text();
    EXPECT_TRUE(folder_.has("env.px"));
    EXPECT_NEAR(red(27), 1, .02f);
}

// Headers that shaders of others include are in the library; one beside the shader comes first.
TEST_F(OldFiles, HeadersOfOldShadersAreAtHand) {
    struct {
        const char *header, *value;
        float red;
    } const cases[] = {
        {"rmannotes.sl", "repeat(.3, 5)", .5f},
        {"rmannotes.sl", "whichtile(.3, 5) / 4", .25f},
        {"rmannotes.sl", "pulse(.2, .6, .1, .4)", 1},
        {"rmannotes.sl", "union(.5, .5) - intersection(.5, .5)", .5f},
        {"rmannotes.sl", "blend(difference(.5, .5), complement(.25), .5)", .5f},
        {"rmannotes.sl", "odd(3) && even(4) ? boxstep(1, 3, 2) : 0", .5f},
        {"patterns.h", "filteredpulse(0, 1, 0, .5)", .5f},
        {"patterns.h", "filteredpulsetrain(.75, 1, .3, 1)", .25f},
        {"patterns.h", "pulsetrain(.5, 1, 1.75) * smoothpulsetrain(0, .2, .6, .8, 1, 2.7)", .5f},
        {"rmannotes.h", "repeat(.3, 5)", .5f},
        {"noises.h", "cells3(point(.5, .5, .5))", .5f},
        {"noises.h", "cells2(.5, 1.5)", .5f},
        {"noises.h", "fBm(P, 1, 3, 2, .5) + turbulence(P, 1, 3, 2, .5) + .25", .25f},
    };
    for (const auto &each : cases) {
        std::string text = "#include \"" + std::string(each.header) + "\"\n";
        if (text.find("noises") != text.npos)
            text +=
                "float cells3(point p) { float near, next; point a, b;\n"
                "  voronoi_f1f2_3d(p, 0, near, a, next, b); return next / 2 + near; }\n"
                "float cells2(float x, y) { float near, next, a, b, c, d;\n"
                "  voronoi_f1f2_2d(x, y, 0, near, a, b, next, c, d); return next / 2 + near; }\n";
        text += "surface noted() { float f = " + std::string(each.value) +
                "; Ci = color(f, 0, 0); Oi = 1; }\n";
        const std::string file = folder_.write("noted.sl", text);
        const Outcome run =
            render(head + "WorldBegin\nSurface \"noted\"\n"
                          "Polygon \"P\" [-9 -9 4  -9 9 4  9 9 4  9 -9 4]\nWorldEnd\n");
        EXPECT_EQ(run.status, 0) << each.value << run.text();
        EXPECT_NEAR(red(27), each.red, 1e-4f) << each.value;
        EXPECT_EQ(runCandela({"compile", file, "--quiet"}).status, 0) << each.value;
    }
    folder_.write("patterns.h", "#define pulse(a) (a)\n");
    folder_.write("noted.sl", "#include \"patterns.h\"\n"
                              "surface noted() { Ci = color(pulse(.125), 0, 0); Oi = 1; }\n");
    render(head + "WorldBegin\nSurface \"noted\"\n" + wall.substr(wall.find("Polygon")) +
           "WorldEnd\n");
    EXPECT_NEAR(red(27), .125f, 1e-6f);
}

// Exporters of right-handed programs turn faces round and give the normals of what is outside then;
// others give normals by the faces. Both are lit.
TEST_F(OldFiles, NormalsOfFacesThatAreTurnedRoundAreLitEitherWay) {
    const std::string light = "LightSource \"distantlight\" 1 \"from\" [0 0 0] \"to\" [0 0 1]\n";
    for (const char *turn :
         {"Orientation \"rh\"\nScale 1 1 -1\n", "Scale 1 1 -1\nReverseOrientation\n"})
        for (const char *integrator : {"classic", "path"})
            for (int side : {-1, 1}) {
                std::string normals;
                for (int k = 0; k < 4; ++k)
                    normals += "0 0 " + std::to_string(side) + " ";
                const Outcome run =
                    render(head + turn + "WorldBegin\nScale 1 1 -1\n" + light +
                               "Scale 1 1 -1\nSurface \"matte\"\nColor [.5 .5 .5]\n"
                               "Polygon \"P\" [-9 -9 -4  9 -9 -4  9 9 -4  -9 9 -4] \"N\" [" +
                               normals + "]\nWorldEnd\n",
                           {"--integrator", integrator});
                EXPECT_EQ(run.status, 0) << run.text();
                EXPECT_NEAR(red(27), .5f, .02f) << turn << side << integrator;
            }
}

TEST_F(OldFiles, TextureCoordinatesAreShown) {
    const Outcome run = render(head + "WorldBegin\nSurface \"show_st\"\n"
                                      "Polygon \"P\" [-9 -9 4  -9 9 4  9 9 4  9 -9 4] \"st\" "
                                      "[.25 .5 .25 .5 .25 .5 .25 .5]\nWorldEnd\n");
    EXPECT_EQ(run.status, 0) << run.text();
    EXPECT_NEAR(red(27), .25f, 1e-5f);
}

} // namespace
} // namespace candela::test
