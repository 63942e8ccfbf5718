// SPDX-License-Identifier: Apache-2.0
// Pictures of `bidir` and `vcm` as wholes: the same bytes however they are made, light that no
// camera path finds, and what is said of lights that begin no paths.
#include "image/picture_file.h"
#include "tests/light_paths/worlds.h"
#include "tests/support/program.h"
#include "tests/support/scratch_folder.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace candela::test {
namespace {

/// A frame of 40 x 30 pixels; the crop of the tests takes whole pixels of it.
std::string sceneOf(const std::string &world, const std::string &options = "",
                    const std::string &integrator = "bidir") {
    return "Option \"radiometry\" \"string units\" \"si\"\n"
           "Option \"render\" \"string integrator\" \"" +
           integrator + "\"\n" + options +
           "Format 40 30 1\nPixelSamples 4 4\nDisplay \"seen.exr\" \"openexr\" \"rgba\"\n"
           "Projection \"perspective\" \"fov\" [60]\nTranslate 0 0 2.6\nWorldBegin\n" +
           world + "WorldEnd\n";
}

const std::string glassAndLamp =
    lamp("Translate .4 .6 -.2\nSphere .05 -.05 .05 360\n", 60) + room() +
    "AttributeBegin\nSurface \"glass\"\nTranslate -.3 -.5 .1\nSphere .4 -.4 .4 360\nAttributeEnd\n";
const std::string taken = "Option \"bidir\" \"float lightpaths\" [1] \"integer connections\" [1]\n";

/// Every way to use paths from lights.
std::vector<std::string> everyScene() {
    return {sceneOf(glassAndLamp, taken), sceneOf(glassAndLamp),
            sceneOf(glassAndLamp, taken, "vcm"), sceneOf(glassAndLamp, "", "vcm")};
}

class LightPaths : public testing::Test {
protected:
    Picture render(const std::string &scene, const std::vector<std::string> &words) {
        const std::string rib = folder.write("scene.rib", scene);
        std::vector<std::string> arguments{rib, "--quiet", "--output-dir", folder.path()};
        arguments.insert(arguments.end(), words.begin(), words.end());
        run = runCandela(arguments);
        EXPECT_EQ(run.status, 0) << run.text();
        std::string problem;
        const std::optional<Picture> picture = readPicture(folder.path("seen.exr"), problem);
        EXPECT_TRUE(picture) << problem;
        return picture.value_or(Picture{});
    }
    static std::vector<float> red(const Picture &picture) { return picture.find("R")->values; }

    ScratchFolder folder;
    Outcome run;
};

TEST_F(LightPaths, GiveTheSameBytesForAnyThreadsAndLanes) {
    for (const std::string &scene : everyScene()) {
        const std::vector<float> one = red(render(scene, {"--threads", "1"}));
        EXPECT_EQ(red(render(scene, {"--threads", "3"})), one);
        EXPECT_EQ(red(render(scene, {"--threads", "2", "--lanes", "1"})), one);
        EXPECT_NE(red(render(scene, {"--threads", "1", "--seed", "1"})), one);
    }
}

TEST_F(LightPaths, OfTheWholeFrameAreTracedForACrop) {
    for (const std::string &scene : everyScene()) {
        const std::vector<float> whole = red(render(scene, {}));
        const std::vector<float> part = red(render(scene, {"--crop", ".25,.75,.2,.6"}));
        ASSERT_EQ(part.size(), 20u * 12u);
        for (int row = 0; row < 12; ++row)
            for (int column = 0; column < 20; ++column)
                EXPECT_EQ(part[row * 20 + column], whole[(row + 6) * 40 + column + 10]);
    }
}

/// A point lamp in the middle of a shell of glass that loses nothing, in a black sphere of radius
/// 1: by symmetry E = I everywhere. No camera path finds it.
TEST_F(LightPaths, FindWhatGlassMakesOfAPointLamp) {
    const std::string scene =
        "Option \"radiometry\" \"string units\" \"si\"\n"
        "Format 16 16 1\nPixelSamples 16 16\nPixelFilter \"box\" 1 1\n"
        "Display \"seen.exr\" \"openexr\" \"rgb\"\nProjection \"orthographic\"\n"
        "ScreenWindow -.02 .02 -.02 .02\nTranslate 0 0 -.9\nWorldBegin\n"
        "LightSource \"pointlight\" 1 \"intensity\" [1]\nSurface \"matte\" \"Ka\" [0]\n"
        "Polygon \"P\" [-.1 -.1 1 .1 -.1 1 .1 .1 1 -.1 .1 1]\n"
        "Surface \"glass\"\nSphere .5 -.5 .5 360\nReverseOrientation\nSphere .45 -.45 .45 360\n"
        "WorldEnd\n";
    const auto irradiance = [&](const std::string &integrator, int seed) {
        double sum = 0;
        const std::vector<float> values =
            red(render(scene, {"--integrator", integrator, "--seed", std::to_string(seed)}));
        for (float value : values)
            sum += value;
        return std::numbers::pi * sum / double(values.size());
    };
    double mean = 0;
    for (int seed = 0; seed < 4; ++seed)
        mean += irradiance("bidir", seed) / 4;
    EXPECT_NEAR(mean, 1, .01);
    EXPECT_LT(irradiance("path", 0), 1e-6);
}

/// The same lamp and shell; of a wall a metre away a patch is seen, in a mirror alone. E = I times
/// the mean of (1 + x^2 + y^2)^(-3/2) there.
TEST_F(LightPaths, MergeWithWhatIsSeenInAMirror) {
    const std::string scene =
        "Option \"radiometry\" \"string units\" \"si\"\n"
        "Option \"bidir\" \"float lightpaths\" [256]\nOption \"vcm\" \"float radius\" [.02]\n"
        "Format 16 16 1\nPixelSamples 4 4\nPixelFilter \"box\" 1 1\n"
        "Display \"seen.exr\" \"openexr\" \"rgb\"\nProjection \"orthographic\"\n"
        "ScreenWindow -.06 .06 -.06 .06\nWorldBegin\n"
        "LightSource \"pointlight\" 1 \"intensity\" [1] \"point from\" [.7 0 .2]\n"
        "Surface \"matte\" \"Ka\" [0]\n"
        "Polygon \"P\" [-.3 -.2 0 -.3 .2 0 -.3 .2 .4 -.3 -.2 .4]\n"
        "Surface \"mirror\"\n"
        "Polygon \"P\" [-.0924 -.1 .5383 .0924 -.1 .4617 .0924 .1 .4617 -.0924 .1 .5383]\n"
        "Surface \"glass\"\nTranslate .7 0 .2\nSphere .5 -.5 .5 360\nReverseOrientation\n"
        "Sphere .45 -.45 .45 360\nWorldEnd\n";
    const auto irradiance = [&](const std::string &integrator) {
        double sum = 0;
        const std::vector<float> values = red(render(scene, {"--integrator", integrator}));
        for (float value : values)
            sum += value;
        return std::numbers::pi * sum / double(values.size());
    };
    EXPECT_NEAR(irradiance("vcm"), .9946, .08);
    EXPECT_LT(irradiance("bidir"), 1e-6);
}

TEST_F(LightPaths, AreNotBegunByEveryLightAndThatIsSaid) {
    render(
        sceneOf("Attribute \"light\" \"string units\" \"classic\"\n"
                "LightSource \"pointlight\" 1\nLightSource \"pointlight\" 2 \"from\" [0 .5 0]\n" +
                room()),
        {});
    EXPECT_TRUE(run.says("\"pointlight\": it has classic units")) << run.err;
    EXPECT_EQ(run.err.find("classic units"), run.err.rfind("classic units")) << run.err;
}

/// Volumes that paths from lights would cross otherwise than camera paths keep them from it.
TEST_F(LightPaths, DoNotCrossEveryVolumeAndThatIsSaid) {
    folder.write("squared.sl", "volume squared() { Ci = Ci * Ci; }\n");
    folder.write("colored.sl", "volume colored() { Ci = Ci * Cs; }\n");
    const std::string point = "LightSource \"pointlight\" 1 \"from\" [0 .5 0]\n";
    const std::string fog = "Atmosphere \"fog\"\n", glass = "Interior \"absorption\"\n";
    const std::pair<std::string, const char *> worlds[] = {
        {point + fog + room() + "Atmosphere \"fog\" \"distance\" [7]\nSphere .1 -.1 .1 360\n",
         "surfaces have different Atmospheres"},
        {point + "Exterior \"fog\"\n" + room(), "surfaces have an Exterior"},
        {point + "Atmosphere \"squared\"\n" + room(), "\"squared\": it does not"},
        {point + "Atmosphere \"colored\"\n" + room(),
         "\"colored\": what it lets through depends on the surface"},
        {point + room() + glass + "Sphere 9 -9 9 360\n", "the camera stands in a body"},
    };
    for (const auto &[world, reason] : worlds) {
        render(sceneOf(world), {"--spp", "1", "--shader-path", folder.path()});
        EXPECT_TRUE(run.says(reason)) << reason << "\n" << run.err;
        EXPECT_TRUE(run.says("no path begins at lights in this frame"));
    }
    render(sceneOf(point + fog + room() + glass + "Sphere .2 -.2 .2 360\n"), {"--spp", "1"});
    EXPECT_EQ(run.err, "");
}

TEST_F(LightPaths, OptionsAreChecked) {
    const std::string rib = folder.write(
        "scene.rib", sceneOf(room(), "Option \"bidir\" \"float lightpaths\" [-1]\n"
                                     "Option \"bidir\" \"integer connections\" [1000]\n"
                                     "Option \"bidir\" \"float trust\" [0]\n"
                                     "Option \"vcm\" \"float radius\" [0]\n"
                                     "Option \"vcm\" \"float trust\" [-1]\n"));
    run = runCandela({rib, "--quiet", "--spp", "1", "--output-dir", folder.path()});
    EXPECT_EQ(run.status, 1);
    for (const char *words :
         {"\"lightpaths\" is how many paths", "\"connections\" is with how many",
          "\"trust\" is what paths from lights count",
          "\"radius\" is how far points that are merged", "\"trust\" is what merging counts"})
        EXPECT_TRUE(run.says(words)) << words << "\n" << run.err;
}

} // namespace
} // namespace candela::test
