// SPDX-License-Identifier: Apache-2.0
// What shaders of a primitive tell each other, and volumes' output parameters.
#include "tests/between_shaders/shown.h"

namespace candela::test {

namespace {

const std::string picture = "Display \"out.exr\" \"openexr\" \"rgb\"\n";

} // namespace

TEST_F(Shown, surfacesHearTheOtherShadersOfTheirPrimitive) {
    struct Case {
        const char *shaders;
        float red, green, blue; ///< Beside .1, .2, .3 of the displacement's tint.
        bool displaced = true;
    };
    const Case table[] = {
        {"Displacement \"bumped\"\n", 20.125f, 0, .5f},
        {"Displacement \"bumped\" \"amount\" [.5] \"string kind\" [\"rough\"]\n", 60.5f, 0, .5f},
        {"", 0, 0, .5f, false},
        {"Displacement \"bumped\"\nAtmosphere \"air\" \"density\" [2]\n", 20.125f, 2, .5f},
        {"Displacement \"bumped\"\nInterior \"air\" \"density\" [.125]\nExterior \"air\"\n",
         20.125f, 26.25f, .5f},
    };
    for (const char *integrator : {"classic", "path"})
        for (const char *place : {"", "Sides 1\n", "Scale 3 3 1\n"})
            for (const Case &test : table) {
                render(smallView(picture) + "WorldBegin\n" + test.shaders + place +
                           "Surface \"asker\"\n" + squareAt("1") + "WorldEnd\n",
                       {"--integrator", integrator});
                const float tint = test.displaced ? 1.0f : 0.0f;
                for (float value : plane("out.exr", "R"))
                    ASSERT_NEAR(value, test.red + .1f * tint, 1e-4f) << test.shaders << integrator;
                for (float value : plane("out.exr", "G"))
                    ASSERT_NEAR(value, test.green + .2f * tint, 1e-4f)
                        << test.shaders << integrator;
                for (float value : plane("out.exr", "B"))
                    ASSERT_NEAR(value, test.blue + .3f * tint, 1e-4f) << test.shaders << integrator;
            }
}

/// The square is moved towards the eye by as much as its surface says.
TEST_F(Shown, displacementsHearTheSurface) {
    render(smallView("Display \"out.exr\" \"openexr\" \"z\"\n") +
           "WorldBegin\nReverseOrientation\nDisplacement \"bumped\"\nSurface \"asker\" \"reach\" "
           "[.25]\n" +
           squareAt("2") + "WorldEnd\n");
    for (float z : plane("out.exr", "Z"))
        ASSERT_NEAR(std::abs(z - 2), .25f, 1e-3f);
}

TEST_F(Shown, volumesShowTheirOutputsAndHearTheSurface) {
    for (const char *integrator : {"classic", "path"})
        for (const char *lanes : {"1", "16"}) {
            render(smallView(picture + "Display \"+a.exr\" \"openexr\" \"depth,heard\"\n") +
                       "WorldBegin\nAtmosphere \"air\"\nSurface \"asker\" \"reach\" [.5]\n"
                       "Patch \"bilinear\" \"P\" [-1 1 2  1 1 2  -1 0 2  1 0 2]\n"
                       "Surface \"constant\"\n"
                       "Patch \"bilinear\" \"P\" [-1 0 4  1 0 4  -1 -1 4  1 -1 4]\nWorldEnd\n",
                   {"--integrator", integrator, "--lanes", lanes});
            const std::vector<float> depth = plane("a.exr", "depth");
            const std::vector<float> heard = plane("a.exr", "heard");
            for (std::size_t i = 0; i < 64; ++i) {
                ASSERT_NEAR(depth[i], i < 32 ? .5f : 1, 1e-4f) << integrator << lanes;
                ASSERT_NEAR(heard[i], i < 32 ? .5f : -1, 1e-6f) << integrator << lanes;
            }
        }
}

/// Who asks where nobody answers is told so, also while rendering.
TEST_F(Shown, shadersThatAskInVainAreTold) {
    folder_.write("asks.sl", "light asks() {\n"
                             "float k = 0;\n"
                             "k += surface(\"Kd\", k) + atmosphere(\"density\", k);\n"
                             "k += attribute(\"ShadingRate\", k);\n"
                             "illuminate(point (0, 0, 0)) Cl = k + Cs; }\n");
    folder_.write("wonders.sl",
                  "volume wonders() { float k = 0; Ci += attribute(\"Sides\", k); }\n");
    const std::string rib =
        smallView("Display \"a.exr\" \"openexr\" \"rgb\"\n") +
        "WorldBegin\nLightSource \"asks\" 1\nAtmosphere \"wonders\"\nSurface \"matte\"\n" +
        squareAt("1") + "WorldEnd\n";
    const Outcome outcome = runCandela({folder_.write("scene.rib", rib), "--output-dir",
                                        folder_.path(), "--shader-path", folder_.path()});
    EXPECT_EQ(outcome.status, 0) << outcome.text();
    for (const char *words :
         {"asks.sl:3:6: warning: surface() asks another shader",
          "asks.sl:3:25: warning: atmosphere() asks another shader",
          "asks.sl:4:6: warning: attribute() is told to surface shaders alone; in a light shader",
          "lights are not told Cs",
          "attribute() is told to surface shaders alone; in a volume shader"})
        EXPECT_NE(outcome.err.find(words), std::string::npos) << words << outcome.text();
}

} // namespace candela::test
