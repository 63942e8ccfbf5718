// SPDX-License-Identifier: Apache-2.0
// Light shaders that look at what they light: environments and occlusion as lights, as many public
// shaders have them (illuminate(Ps + N)).
#include "tests/old_files/old_scene.h"

#include <cmath>

namespace candela::test {
namespace {

using NormalsInLights = OldScene;

/// A wall that the eye sees all over, turned by that many degrees about y.
std::string turnedWall(const std::string &degrees) {
    return "AttributeBegin\nSurface \"matte\"\nTranslate 0 0 4\nRotate " + degrees +
           " 0 1 0\nPolygon \"P\" [-50 -50 0  -50 50 0  50 50 0  50 -50 0]\nAttributeEnd\n";
}

struct Reading {
    const char *name, *light;
    float lit;
};

/// Of light from the side that the normal faces all arrives. Each light tells red how much of the
/// normal is along the eye's axis, too: .8660254 of a wall that is turned by 30 degrees.
const Reading readings[] = {
    {"N, with a place", "illuminate(Ps + normalize(faceforward(N, I))) Cl = 1;", 1},
    {"Ns, with a place", "normal n = faceforward(normalize(Ns), I); illuminate(Ps + n) Cl = 1;", 1},
    {"N, with a direction", "solar(-normalize(faceforward(N, I)), 0) Cl = 1;", 1},
    {"without illuminate", "Cl = abs(zcomp(ntransform(\"camera\", normalize(N))));", .8660254f},
    {"Ns without illuminate", "Cl = abs(zcomp(ntransform(\"camera\", normalize(Ns))));", .8660254f},
    {"Ng", "illuminate(Ps + normalize(faceforward(Ng, I))) Cl = 1;", 1},
    {"one component", "Cl = abs(zcomp(N)) / length(N);", .8660254f},
    {"assigned", "N = normalize(faceforward(N, I)); illuminate(Ps + N) Cl = 1;", 1},
};

TEST_F(NormalsInLights, AreThoseOfWhatIsLit) {
    for (const Reading &reading : readings)
        for (const char *integrator : {"classic", "path"})
            for (const char *world : {"", "Scale -1 1 1\n", "Scale 1 1 -1\nRotate 180 0 1 0\n",
                                      "Translate 0 0 0\nScale .01 .01 .01\n"}) {
                folder_.write("looking.sl",
                              "light looking() { " + std::string(reading.light) + " }\n");
                const Outcome run =
                    render(head +
                               "Option \"radiometry\" \"string units\" [\"classic\"]\n"
                               "Projection \"perspective\" \"fov\" 20\nWorldBegin\n" +
                               std::string(world) + "LightSource \"looking\" 1\n" +
                               turnedWall("30") + "WorldEnd\n",
                           {"--integrator", integrator});
                EXPECT_EQ(run.err, "") << reading.name << integrator << world;
                EXPECT_NEAR(red(27), reading.lit, 1e-4f) << reading.name << integrator << world;
            }
}

/// In instances, of which one is mirrored, and under several lights at once, which share the batch.
TEST_F(NormalsInLights, HoldInInstancesAmongOtherLights) {
    folder_.write("looking.sl", "light looking() { normal n = faceforward(normalize(N), I);\n"
                                "  illuminate(Ps + n) Cl = abs(zcomp(n)); }\n");
    const std::string wallObject = "ObjectBegin 1\n" + turnedWall("30") + "ObjectEnd\n";
    for (const char *integrator : {"classic", "path"})
        for (const char *placed : {"", "Scale -1 1 1\n"}) {
            const Outcome run = render(head +
                                           "Option \"radiometry\" \"string units\" [\"classic\"]\n"
                                           "Projection \"perspective\" \"fov\" 1\n" +
                                           wallObject +
                                           "WorldBegin\nLightSource \"looking\" 1\n"
                                           "LightSource \"distantlight\" 2 \"intensity\" [.5]\n"
                                           "LightSource \"ambientlight\" 3 \"intensity\" [.25]\n" +
                                           placed + "ObjectInstance 1\nWorldEnd\n",
                                       {"--integrator", integrator, "--spp", "256"});
            const float slant = .8660254f;
            EXPECT_EQ(run.err, "") << integrator << placed;
            EXPECT_NEAR(red(27), slant + .5f * slant + .25f, .03f) << integrator << placed;
        }
}

/// Behind what the eye sees in a mirror: I is that of the ray that comes from there.
TEST_F(NormalsInLights, FaceWhoeverLooks) {
    folder_.write("looking.sl", "light looking() { normal n = faceforward(normalize(N), I);\n"
                                "  illuminate(Ps + n) Cl = 1; }\n");
    folder_.write("mirror.sl", "surface mirror() { Oi = 1;\n"
                               "  Ci = trace(P, reflect(normalize(I), normalize(N))); }\n");
    for (const char *integrator : {"classic", "path"}) {
        const Outcome run =
            render(head + "Option \"radiometry\" \"string units\" [\"classic\"]\n"
                          "Projection \"perspective\" \"fov\" 20\nWorldBegin\n"
                          "LightSource \"looking\" 1\nSurface \"mirror\"\n"
                          "Polygon \"P\" [-9 -9 4  -9 9 4  9 9 4  9 -9 4]\nSurface \"matte\"\n"
                          "Polygon \"P\" [-9 -9 -2  -9 9 -2  9 9 -2  9 -9 -2]\nWorldEnd\n",
                   {"--integrator", integrator});
        EXPECT_EQ(run.err, "") << integrator;
        // What the wall sends to the mirror comes back to it under "path".
        EXPECT_GE(red(27), 1 - 1e-4f) << integrator;
        EXPECT_LE(red(27), integrator == std::string("classic") ? 1 + 1e-4f : 2) << integrator;
    }
}

/// A lamp of its own shape has its own normals; Ns leads to it.
TEST_F(NormalsInLights, OfLampsAreTheirOwn) {
    folder_.write("lamp.sl",
                  "light lamp() { illuminate(P, N, PI / 2)\n"
                  "  Cl = abs(zcomp(normalize(N))) * -(normalize(Ns) . normalize(L)); }\n");
    for (const char *integrator : {"classic", "path"}) {
        const Outcome run =
            render(head +
                       "Option \"radiometry\" \"string units\" [\"classic\"]\n"
                       "Projection \"perspective\" \"fov\" 1\nWorldBegin\n"
                       "AttributeBegin\nAreaLightSource \"lamp\" 1\n"
                       "Attribute \"visibility\" \"integer camera\" [0]\n"
                       "Polygon \"P\" [-.01 -.01 0  .01 -.01 0  .01 .01 0  -.01 .01 0]\n"
                       "AttributeEnd\nIlluminate 1 1\n" +
                       turnedWall("0") + "WorldEnd\n",
                   {"--integrator", integrator});
        EXPECT_EQ(run.err, "") << integrator;
        EXPECT_NEAR(red(27), 1, .01f) << integrator;
    }
}

/// Occlusion as a light: open ground is lit in full, and beside an endless wall by half of the sky.
TEST_F(NormalsInLights, MakeLightsOfOcclusion) {
    folder_.write("sky.sl", "light sky(float samples = 64; output float __nonspecular = 1;) {\n"
                            "  normal n = normalize(faceforward(normalize(N), I));\n"
                            "  illuminate(Ps + n) Cl = 1 - occlusion(Ps, n, samples); }\n");
    const std::string beside =
        "Color [0 0 0]\n"
        "Polygon \"P\" [1.1 -1e5 4  1.1 1e5 4  1.1 1e5 -1e5  1.1 -1e5 -1e5]\n";
    for (const char *integrator : {"classic", "path"})
        for (const bool isOpen : {true, false}) {
            const Outcome run = render(head +
                                           "Option \"radiometry\" \"string units\" [\"classic\"]\n"
                                           "Projection \"orthographic\"\n"
                                           "ScreenWindow -4 4 -4 4\nWorldBegin\n"
                                           "LightSource \"sky\" 1\n" +
                                           wall + (isOpen ? "" : beside) + "WorldEnd\n",
                                       {"--integrator", integrator, "--spp", "64"});
            EXPECT_EQ(run.err, "") << integrator;
            for (const std::size_t pixel : {24u, 28u, 31u})
                EXPECT_NEAR(red(pixel), isOpen ? 1 : .5f, .04f) << integrator << pixel;
        }
}

/// Where such a light stands means nothing: what is between hides nothing that occlusion() has not
/// found.
TEST_F(NormalsInLights, OcclusionIsAllTheirShadow) {
    folder_.write("sky.sl", "light sky() { normal n = normalize(faceforward(normalize(N), I));\n"
                            "  illuminate(Ps + n) Cl = .5 + .0001 * occlusion(Ps, n, 4); }\n");
    for (const char *integrator : {"classic", "path"}) {
        const Outcome run =
            render(head +
                       "Option \"radiometry\" \"string units\" [\"classic\"]\n"
                       "Projection \"orthographic\"\nWorldBegin\nLightSource \"sky\" 1\n" +
                       wall +
                       "Attribute \"visibility\" \"integer camera\" [0]\nColor [0 0 0]\n"
                       "Polygon \"P\" [-9 -9 3.5  -9 9 3.5  9 9 3.5  9 -9 3.5]\nWorldEnd\n",
                   {"--integrator", integrator});
        EXPECT_EQ(run.err, "") << integrator;
        EXPECT_NEAR(red(27), .5f, 1e-3f) << integrator;
    }
}

} // namespace
} // namespace candela::test
