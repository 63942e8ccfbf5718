// SPDX-License-Identifier: Apache-2.0
// Output parameters of surface shaders as channels of displays.
#include "tests/between_shaders/shown.h"

#include "foundation/base/student.h"

#include <cmath>

namespace candela::test {

namespace {

const std::string everyType = "Display \"w.exr\" \"openexr\" \"weight\"\n"
                              "Display \"+t.exr\" \"openexr\" \"tint\"\n"
                              "Display \"+m.exr\" \"openexr\" \"way,varying color pair,Ci\"\n";

struct Place {
    const char *name, *before, *after;
};

/// The same square in spaces, objects and orientations that do not change what is seen of it.
const Place places[] = {
    {"world", "", ""},
    {"sides 1", "Sides 1\n", ""},
    {"reversed", "ReverseOrientation\n", ""},
    {"scaled", "Scale 1000 1000 1000\nScale .001 .001 .001\n", ""},
    {"instance", "ObjectBegin 1\n", "ObjectEnd\nSurface \"ramp\"\nObjectInstance 1\n"},
};

} // namespace

TEST_F(Shown, outputsOfEveryTypeOnTheirSurfaceAlone) {
    for (const char *integrator : {"classic", "path"})
        for (const char *lanes : {"1", "16"})
            for (const Place &place : places) {
                const std::string name = std::string(integrator) + " " + lanes + " " + place.name;
                render(smallView(everyType) + "WorldBegin\nSurface \"ramp\"\n" +
                           std::string(place.before) +
                           "Patch \"bilinear\" \"P\" [-1 1 1  1 1 1  -1 0 1  1 0 1]\n" +
                           place.after +
                           "Surface \"constant\"\n"
                           "Patch \"bilinear\" \"P\" [-1 0 1  1 0 1  -1 -1 1  1 -1 1]\nWorldEnd\n",
                       {"--integrator", integrator, "--lanes", lanes});
                const std::vector<float> weight = plane("w.exr", "weight");
                const std::vector<float> red = plane("t.exr", "tint.R");
                const std::vector<float> blue = plane("t.exr", "tint.B");
                const std::vector<float> z = plane("m.exr", "way.Z");
                const std::vector<float> second = plane("m.exr", "pair.1");
                ASSERT_EQ(weight.size(), 64u);
                for (int y = 0; y < 8; ++y)
                    for (int x = 0; x < 8; ++x) {
                        const auto at = std::size_t(8 * y + x);
                        const bool upper = y < 4;
                        const float u = upper ? (float(x) + .5f) / 8 : 0;
                        ASSERT_NEAR(weight[at], u, .07f) << name; // One sample of the pixel.
                        ASSERT_EQ(red[at], weight[at]) << name;
                        ASSERT_EQ(blue[at], upper ? .25f : 0) << name;
                        ASSERT_EQ(z[at], upper ? 3 : 0) << name;
                        ASSERT_NEAR(second[at], upper ? (float(y) + .5f) / 2 : 0, .3f) << name;
                    }
            }
}

/// As colours are composed: what is behind counts as far as it is seen.
TEST_F(Shown, whatShinesThroughCounts) {
    for (const char *integrator : {"classic", "path"}) {
        render(smallView("Display \"t.exr\" \"openexr\" \"tint\"\n") +
                   "WorldBegin\nSurface \"ramp\"\nAttributeBegin\nOpacity .25 .5 1\n" +
                   squareAt("1") + "AttributeEnd\n" + squareAt("2") + "WorldEnd\n",
               {"--integrator", integrator});
        const std::vector<float> red = plane("t.exr", "tint.R"), blue = plane("t.exr", "tint.B");
        render(smallView("Display \"t.exr\" \"openexr\" \"tint\"\n") +
               "WorldBegin\nSurface \"ramp\"\n" + squareAt("2") + "WorldEnd\n");
        const std::vector<float> alone = plane("t.exr", "tint.R");
        for (std::size_t i = 0; i < 64; ++i) {
            EXPECT_NEAR(red[i], alone[i] * 1.75f, 1e-5f) << integrator;
            EXPECT_NEAR(blue[i], .25f, 1e-6f) << integrator;
        }
    }
}

/// One distant light and nothing else: no noise, and channels add up to Ci.
TEST_F(Shown, partsOfDistantLightAddUpToAllOfIt) {
    const char *units[] = {"classic", "si"};
    for (const char *unit : units)
        for (const char *integrator : {"classic", "path"}) {
            render(smallView("Display \"p.exr\" \"openexr\" "
                             "\"diffusePart,highlight,whole,Ci\"\n") +
                       "Option \"radiometry\" \"string units\" \"" + unit +
                       "\"\nWorldBegin\n"
                       "LightSource \"distantlight\" 1 \"to\" [.3 .2 1] \"intensity\" [2]\n"
                       "Surface \"parts\"\nColor .5 .25 1\n" +
                       squareAt("1") + "WorldEnd\n",
                   {"--integrator", integrator});
            const std::vector<float> diffuse = plane("p.exr", "diffusePart.G");
            const std::vector<float> highlight = plane("p.exr", "highlight.G");
            const std::vector<float> whole = plane("p.exr", "whole.G"), all = plane("p.exr", "G");
            for (std::size_t i = 0; i < 64; ++i) {
                EXPECT_GT(diffuse[i], .05f) << unit << integrator;
                EXPECT_NEAR(whole[i], all[i], 1e-5f * all[i]) << unit << integrator;
                EXPECT_NEAR(diffuse[i] + highlight[i], all[i], 1e-5f * all[i])
                    << unit << integrator;
            }
        }
}

/// Lamps, walls that send light on, a surface that shines: the channel of all of a shader's answer
/// has the mean of its Ci, though they are gathered apart.
TEST_F(Shown, partsOfGatheredLightHaveTheMeanOfTheWhole) {
    const std::string world =
        "WorldBegin\nAttributeBegin\nTranslate 0 1.9 3\n"
        "AreaLightSource \"arealight\" 1 \"radiance\" [10]\nSurface \"constant\"\n"
        "Polygon \"P\" [-.4 0 -.4 .4 0 -.4 .4 0 .4 -.4 0 .4]\nAttributeEnd\n"
        "Illuminate 1 1\nSurface \"parts\" \"roughness\" [.5]\nColor .6 .5 .3\n"
        "Polygon \"P\" [-2 -1 1  -2 -1 5  2 -1 5  2 -1 1]\n"
        "Polygon \"P\" [-2 -1 4  -2 2 4  2 2 4  2 -1 4]\n"
        "Polygon \"P\" [-2 -1 1  -2 2 1  -2 2 5  -2 -1 5]\nWorldEnd\n";
    std::vector<double> differences;
    double mean = 0;
    for (int seed = 1; seed <= 12; ++seed) {
        render(smallView("Display \"p.exr\" \"openexr\" \"whole,Ci\"\n") +
                   "Option \"radiometry\" \"string units\" \"si\"\nScreenWindow -2 2 -1 2\n" +
                   world,
               {"--seed", std::to_string(seed), "--spp", "16"});
        const double whole = meanOf(plane("p.exr", "whole.G")), all = meanOf(plane("p.exr", "G"));
        differences.push_back(whole - all), mean += all / 12;
    }
    const MeanAndError difference = meanAndError(differences);
    EXPECT_GT(mean, .05);
    EXPECT_LT(difference.standardError, .02 * mean);
    EXPECT_LT(std::abs(difference.mean), studentQuantile(1e-4, 11) * difference.standardError);
}

/// Light that is thresholded is given to the channel as it is given to Ci.
TEST_F(Shown, shadersThatAreNotAffineShowWhatTheySend) {
    render(smallView("Display \"p.exr\" \"openexr\" \"tone,Ci\"\n") +
               "WorldBegin\nLightSource \"distantlight\" 1 \"intensity\" [1]\nSurface \"tones\"\n" +
               squareAt("1") + "WorldEnd\n",
           {"--integrator", "classic"});
    EXPECT_EQ(plane("p.exr", "tone.R"), plane("p.exr", "R"));
}

/// Who wants channels gets the same picture.
TEST_F(Shown, channelsLeaveThePictureAsItIs) {
    const std::string world = "WorldBegin\nLightSource \"pointlight\" 1 \"intensity\" [9]\n"
                              "Surface \"parts\"\nTranslate 0 0 3\nSphere 1 -1 1 360\nWorldEnd\n";
    for (const char *integrator : {"classic", "path"}) {
        const std::vector<std::string> how{"--integrator", integrator, "--spp", "4"};
        render(smallView("Display \"a.exr\" \"openexr\" \"rgba\"\n") + world, how);
        render(smallView("Display \"b.exr\" \"openexr\" \"rgba\"\n"
                         "Display \"+c.exr\" \"openexr\" \"diffusePart\"\n") +
                   world,
               how);
        for (const char *channel : {"R", "G", "B", "A"})
            EXPECT_EQ(plane("a.exr", channel), plane("b.exr", channel)) << integrator;
    }
}

/// No channel takes the place of another in a file, the picture's least of all.
TEST_F(Shown, channelsWithTheNameOfAnotherPlaneGetOneOfTheirOwn) {
    const std::string rib = smallView("Display \"c.exr\" \"openexr\" \"rgba,R,list,rgb\"\n") +
                            "WorldBegin\nSurface \"lettered\"\n" + squareAt("1") + "WorldEnd\n";
    const Outcome outcome =
        runCandela({folder_.write("scene.rib", rib), "--output-dir", folder_.path(),
                    "--shader-path", CANDELA_SOURCE_DIR "/tests/between_shaders/shaders"});
    EXPECT_EQ(outcome.status, 0) << outcome.text();
    EXPECT_NE(outcome.err.find("R as shader.R"), std::string::npos) << outcome.text();
    struct Channel {
        const char *plane;
        float value;
    };
    for (const Channel &channel :
         {Channel{"R", .5f}, {"A", 1}, {"shader.R", .125f}, {"list.0", 1}, {"list.2", 3}})
        for (float value : plane("c.exr", channel.plane))
            ASSERT_EQ(value, channel.value) << channel.plane;
}

/// Whatever an output parameter is called, it is the shader's own.
TEST_F(Shown, namesOfTheCompilersOwnAreNamesLikeOthers) {
    struct Channel {
        const char *plane;
        float value;
    };
    const Channel ofSurface[] = {
        {"g", .125f},         {"L.R", 1},      {"L.B", 3},     {"Cl.G", 5},         {"dPdu.Z", 9},
        {"completed", .375f}, {"Ca.R", .625f}, {"Ce.R", .75f}, {"CiOfCi.R", .875f}, {"R", .5f}};
    const Channel ofVolume[] = {{"CiOfCi.G", 2}, {"g", .125f}};
    for (const char *integrator : {"classic", "path"})
        for (const char *lanes : {"1", "16"}) {
            const std::vector<std::string> how{"--integrator", integrator, "--lanes", lanes};
            const std::string light = "WorldBegin\nLightSource \"distantlight\" 1\n";
            render(smallView("Display \"c.exr\" \"openexr\" "
                             "\"g,L,Cl,dPdu,completed,Ca,Ce,CiOfCi,Ci\"\n") +
                       light + "Surface \"clashing\"\n" + squareAt("1") + "WorldEnd\n",
                   how);
            for (const Channel &channel : ofSurface)
                for (float value : plane("c.exr", channel.plane))
                    ASSERT_NEAR(value, channel.value, 1e-6f) << channel.plane << integrator;
            render(smallView("Display \"v.exr\" \"openexr\" \"CiOfCi,g\"\n") + light +
                       "Atmosphere \"clashing_air\"\nSurface \"constant\"\n" + squareAt("1") +
                       "WorldEnd\n",
                   how);
            for (const Channel &channel : ofVolume)
                for (float value : plane("v.exr", channel.plane))
                    ASSERT_NEAR(value, channel.value, 1e-6f) << channel.plane << integrator;
        }
}

TEST_F(Shown, channelsOfNoShaderAreAnErrorThatNamesWhatThereIs) {
    const std::string rib = smallView("Display \"a.exr\" \"openexr\" \"nosuch\"\n") +
                            "WorldBegin\nSurface \"ramp\"\n" + squareAt("1") + "WorldEnd\n";
    const Outcome outcome =
        runCandela({folder_.write("scene.rib", rib), "--output-dir", folder_.path(),
                    "--shader-path", CANDELA_SOURCE_DIR "/tests/between_shaders/shaders"});
    EXPECT_EQ(outcome.status, 1) << outcome.text();
    EXPECT_NE(outcome.err.find("nosuch"), std::string::npos) << outcome.text();
    EXPECT_NE(outcome.err.find("weight"), std::string::npos) << outcome.text();
}

} // namespace candela::test
