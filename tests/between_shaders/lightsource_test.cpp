// SPDX-License-Identifier: Apache-2.0
// lightsource(): what surfaces learn of the light that an illuminance loop is at.
#include "tests/between_shaders/shown.h"

namespace candela::test {

namespace {

const std::string picture = "Display \"out.exr\" \"openexr\" \"rgb\"\n";

const std::string twoLights =
    "LightSource \"tagged\" 1 \"string tag\" [\"key\"] \"gain\" [.25] \"color tint\" [0 0 .5]\n"
    "LightSource \"tagged\" 2 \"string tag\" [\"fill\"] \"gain\" [.5]\n";

} // namespace

/// Numbers, colours and strings of each light; what it does not have, or has of another type,
/// leaves the variable as it is. The sums are not affine in the light, so `path` gathers.
TEST_F(Shown, listenersHearEachLight) {
    struct Case {
        const char *before;
        float red, green, blue;
    };
    const Case table[] = {
        {"", .75f, .125f, .625f},
        {"Illuminate 2 0\n", .25f, .125f, .625f},
        {"Illuminate 1 0\n", .5f, 0, .125f},
        {"Illuminate 1 0\nIlluminate 2 0\n", 0, 0, .125f},
        {"Scale -1 1 1\n", .75f, .125f, .625f},
        {"Sides 1\n", .75f, .125f, .625f},
    };
    for (const char *lanes : {"1", "16"})
        for (const Case &test : table) {
            render(smallView(picture) + "WorldBegin\n" + twoLights + test.before +
                       "Surface \"listener\"\n" + squareAt("1") + "WorldEnd\n",
                   {"--integrator", "classic", "--lanes", lanes});
            for (float value : plane("out.exr", "R"))
                ASSERT_NEAR(value, test.red, 1e-6f) << test.before;
            for (float value : plane("out.exr", "G"))
                ASSERT_NEAR(value, test.green, 1e-6f) << test.before;
            for (float value : plane("out.exr", "B"))
                ASSERT_NEAR(value, test.blue, 1e-6f) << test.before;
        }
}

/// A light's string is compared with strings that the file gives, as with those of the text.
TEST_F(Shown, stringsOfLightsAreComparedWithParameters) {
    struct Case {
        const char *parameters;
        float heard, others;
    };
    const Case table[] = {
        {"", 0, 0},
        {"\"string wanted\" [\"key\"]", .25f, 0},
        {"\"string wanted\" [\"fill\"]", .25f, 0},
        {"\"string wanted\" [\"Fill\"]", 0, 0},
        {"\"string wanted\" [\"key\"] \"string[2] others\" [\"x\" \"fill\"]", .25f, .25f},
        {"\"string[2] others\" [\"key\" \"fill\"]", 0, .5f},
        {"\"string wanted\" [\"none\"]", .25f, 0},
    };
    for (const char *lanes : {"1", "16"})
        for (const char *place : {"", "Scale -1 1 1\n", "Sides 1\n"})
            for (const Case &test : table) {
                render(smallView(picture) + "WorldBegin\n" + twoLights +
                           "LightSource \"tagged\" 3\n" + place + "Surface \"chooser\" " +
                           test.parameters + "\n" + squareAt("1") + "WorldEnd\n",
                       {"--integrator", "classic", "--lanes", lanes});
                EXPECT_NEAR(meanOf(plane("out.exr", "R")), test.heard, 1e-6) << test.parameters;
                EXPECT_NEAR(meanOf(plane("out.exr", "G")), test.others, 1e-6) << test.parameters;
            }
}

/// Two lights of the same strength that tell different weights; each path hears one of them by
/// chance, and with it its own number.
TEST_F(Shown, lightsThatArePickedByChanceTellTheirOwn) {
    for (const char *integrator : {"classic", "path"})
        for (const char *lanes : {"1", "16"}) {
            render(smallView(picture) + "WorldBegin\n" + twoLights + "Surface \"chosen\"\n" +
                       squareAt("1") + "WorldEnd\n",
                   {"--integrator", integrator, "--lanes", lanes, "--spp", "256"});
            const double mean = meanOf(plane("out.exr", "R"));
            EXPECT_NEAR(mean, .75, std::string(integrator) == "path" ? .01 : 1e-6)
                << integrator << lanes;
        }
}

} // namespace candela::test
