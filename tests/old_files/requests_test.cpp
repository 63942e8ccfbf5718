// SPDX-License-Identifier: Apache-2.0
// Requests that stand in many old files and change no picture here: what is said of them, once, and
// that the rest is drawn.
#include "tests/old_files/old_scene.h"

namespace candela::test {
namespace {

using OldRequests = OldScene;

struct Said {
    const char *options, *attributes;
    const char *words; ///< Empty: nothing at all.
};
const Said all[] = {
    {"Hider \"hidden\" \"jitter\" [1]\n", "", ""},
    {"Hider \"hidden\" \"jitter\" 0 \"samplemotion\" 1 \"depthfilter\" \"min\"\n", "", ""},
    {"Option \"light\" \"nsamples\" [4]\nOption \"light\" \"nsamples\" [9]\n", "", ""},
    {"Option \"radiosity\" \"steps\" [0] \"minpatchsamples\" [2]\n", "", ""},
    {"Option \"render\" \"max_raylevel\" [4] \"minshadowbias\" [.01] \"prmanspecular\" [1]\n", "",
     ""},
    {"", "Attribute \"light\" \"nsamples\" [4]\nAttribute \"radiosity\" \"zonal\" \"none\"\n", ""},
    {"", "Attribute \"indirect\" \"maxerror\" [.1]\nAttribute \"caustic\" \"ngather\" [75]\n", ""},
    {"", "GeometricRepresentation \"primitive\"\n", ""},
    {"", "GeometricRepresentation \"lines\"\nGeometricRepresentation \"lines\"\n",
     "GeometricRepresentation \"lines\": surfaces are drawn all the same"},
    {"", "GeometricRepresentation \"bounding box\"\n", "surfaces are drawn all the same"},
    {"", "Procedural \"DynamicLoad\" [\"x.so\" \"3.0\"] [-1 1 -1 1 -1 1]\n",
     "\"DynamicLoad\" asks for machine code of another renderer"},
};

TEST_F(OldRequests, ChangeNothing) {
    for (const Said &each : all) {
        const Outcome run =
            render(head + each.options + "WorldBegin\n" + each.attributes +
                   "Surface \"constant\"\n" + wall.substr(wall.find("Polygon")) + "WorldEnd\n");
        EXPECT_EQ(run.status, 0) << run.text();
        EXPECT_EQ(run.err.empty(), !*each.words) << run.text();
        EXPECT_TRUE(run.says(each.words)) << run.text();
        EXPECT_EQ(run.err.find("warning", run.err.find("warning") + 1), std::string::npos)
            << run.text();
        EXPECT_EQ(red(27), 1) << run.text();
    }
}

/// What is written instead of a deep shadow map is looked up as a map of depths.
TEST_F(OldRequests, DeepShadowsBecomeDepths) {
    folder_.write("reads.sl",
                  "surface reads() { float hidden = shadow(\"d.shd\", P, \"samples\", 1);\n"
                  "  Ci = color(hidden, hidden, hidden); Oi = 1; }\n");
    const std::string part = "Polygon \"P\" [-9 -9 2  -9 9 2  0 9 2  0 -9 2]\n";
    const Outcome run =
        render("Format 8 8 1\nProjection \"orthographic\"\nScreenWindow -4 4 -4 4\n"
               "FrameBegin 1\nDisplay \"d.shd\" \"deepshad\" \"deepopacity\"\nWorldBegin\n" +
               part +
               "WorldEnd\nFrameEnd\nFrameBegin 2\nPixelFilter \"box\" 1 1\n"
               "Display \"out.exr\" \"openexr\" \"rgb\"\nWorldBegin\nSurface \"reads\"\n" +
               wall.substr(wall.find("Polygon")) + "WorldEnd\nFrameEnd\n");
    EXPECT_EQ(run.status, 0) << run.text();
    EXPECT_TRUE(run.says("there are no deep shadow maps: it will be a shadow map of depths"));
    EXPECT_NEAR(red(25), 1, .01f);
    EXPECT_NEAR(red(30), 0, .01f);
}

/// Who looks up shadows has them; only other lights are told of.
TEST_F(OldRequests, LightsThatLookUpShadowsAreNotSaidToCastNone) {
    const std::string map = "FrameBegin 1\nDisplay \"n.z\" \"zfile\" \"z\"\nTranslate 0 0 4\n"
                            "WorldBegin\nSphere 1 -1 1 360\nWorldEnd\nFrameEnd\n"
                            "MakeShadow \"n.z\" \"n.shad\"\n";
    struct {
        const char *lights;
        bool told;
    } const cases[] = {
        {"LightSource \"shadowspot\" 1 \"shadowname\" \"n.shad\" \"from\" [0 0 -4]\n", false},
        {"LightSource \"shadowspot\" 1 \"shadowname\" \"n.shad\" \"from\" [0 0 -4]\n"
         "LightSource \"ambientlight\" 2\n",
         false},
        {"LightSource \"spotlight\" 1 \"from\" [0 0 -4]\n", true},
        {"LightSource \"shadowspot\" 1 \"shadowname\" \"n.shad\" \"from\" [0 0 -4]\n"
         "LightSource \"spotlight\" 2 \"from\" [0 0 -4]\n",
         true},
        {"LightSource \"shadowspot\" 1 \"shadowname\" \"\" \"from\" [0 0 -4]\n", true},
    };
    for (const auto &each : cases) {
        const Outcome run =
            runCandela({folder_.write("scene.rib", "Format 8 8 1\n" + map + "FrameBegin 2\n" +
                                                       head + "WorldBegin\n" + each.lights + wall +
                                                       "WorldEnd\nFrameEnd\n"),
                        "--output-dir", folder_.path(), "--spp", "1", "--integrator", "classic"});
        EXPECT_EQ(run.status, 0) << run.text();
        EXPECT_EQ(run.text().find("lights cast no shadows under") != std::string::npos, each.told)
            << each.lights << run.text();
    }
}

} // namespace
} // namespace candela::test
