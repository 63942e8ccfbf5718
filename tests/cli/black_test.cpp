// SPDX-License-Identifier: Apache-2.0
// Scenes that are legal, and black: each is told why.
#include "tests/support/program.h"
#include "tests/support/scratch_folder.h"

#include <gtest/gtest.h>

namespace candela::test {

namespace {

/// What stands before WorldBegin, in the world before the surface, and of the surface on.
struct BlackScene {
    const char *name;
    std::string options, lights, shapes, reason;
    std::string alsoSays{};
};

const std::string lamp = "LightSource \"pointlight\" \"lamp\" \"intensity\" 40 \"from\" [2 4 -2]\n";
const std::string ball = "Translate 0 0 6\nSphere 1 -1 1 360\n";
const std::string areaLamp = "AreaLightSource \"arealight\" \"panel\" \"radiance\" 5 ";
const std::string disk = "Translate 0 4 6 Rotate 90 1 0 0 Disk 0 1 360 ";

const BlackScene scenes[] = {
    {"Nothing", "", lamp, "", "there is nothing in the world"},
    {"BehindTheCamera", "", lamp, "Translate 0 0 -6 Sphere 1 -1 1 360", "lies behind the camera"},
    {"BeforeTheNearPlane", "Clipping 10 20\n", lamp, ball, "before the nearer of the clipping"},
    {"BeyondTheFarPlane", "Clipping 1 4\n", lamp, ball, "beyond the farther of the clipping"},
    {"BesideTheFrame", "", lamp, "Translate 50 0 6 Sphere 1 -1 1 360", "beside what the camera"},
    {"TooSmall", "", lamp, "Translate .02 0 6 Sphere .0001 -.0001 .0001 360", "too small"},
    {"Hidden", "", lamp, "Attribute \"visibility\" \"int camera\" 0\n" + ball, "hidden from it"},
    {"OneSided", "", lamp,
     "Sides 1 Translate 0 0 6 ReverseOrientation Rotate 180 1 0 0 Disk 0 1 360", "Sides 1"},
    {"Clear", "", lamp, "Opacity 0 0 0\n" + ball, "transparent"},
    {"Matte", "", lamp, "Matte 1\n" + ball, "Matte"},
    {"NoLight", "", "", ball, "nothing shines: there is no light source"},
    {"OffOutsideItsBlock", "", "AttributeBegin\n" + lamp + "AttributeEnd\n", ball,
     "light \"lamp\" (\"pointlight\") (scene.rib:4:1) is on for nothing that is seen",
     "scene.rib:4:1: warning: light \"lamp\" (\"pointlight\") shines on nothing"},
    {"TurnedOff", "", lamp + "Illuminate \"lamp\" 0\n", ball, "is on for nothing that is seen"},
    {"PanelInABlock", "", "AttributeBegin " + areaLamp + disk + "AttributeEnd\n", ball,
     "light \"panel\" (\"arealight\") (scene.rib:3:16) is on for nothing that is seen",
     "shines on nothing, unless on its own shapes"},
    {"PanelWithoutShapes", "",
     "AttributeBegin " + areaLamp + "AttributeEnd Illuminate \"panel\" 1\n", ball,
     "light \"panel\" (\"arealight\") (scene.rib:3:16) has nothing to shine with",
     "no primitive stands between its AreaLightSource and the end of its block"},
    {"PanelTurnedRound", "",
     "AttributeBegin ReverseOrientation " + areaLamp + disk +
         "AttributeEnd Illuminate \"panel\" 1\n",
     ball, "ReverseOrientation turns"},
    {"IntensityOfNothing", "", "LightSource \"pointlight\" 1 \"intensity\" 0\n", ball,
     "light \"1\" (\"pointlight\") (scene.rib:3:1) sends nothing to what is seen"},
    {"BlackSurface", "", lamp, "Color 0 0 0\n" + ball, "nothing comes back from it"},
    {"AmbientLightAlone", "", "LightSource \"ambientlight\" 1\n",
     "Surface \"matte\" \"Ka\" [0]\n" + ball, "Ka for ambient light"},
    {"LitFromBehind", "", "LightSource \"pointlight\" 1 \"intensity\" 40 \"from\" [0 0 60]\n",
     "Translate 0 0 6 Disk 0 8 360", "turns its back to light \"1\""},
    {"InShadow", "Attribute \"light\" \"string shadows\" \"on\"\n",
     "LightSource \"pointlight\" 1 \"intensity\" 40 \"from\" [0 0 2]\n",
     "AttributeBegin Translate 0 0 2 Sphere .2 -.2 .2 360 AttributeEnd Translate 1 0 6 "
     "Sphere 1 -1 1 360",
     "lies in shadow: something stands between it and light \"1\""},
    {"InShadowOfWhatIsFarOff", "Attribute \"light\" \"string shadows\" \"on\"\n",
     "LightSource \"distantlight\" 1 \"from\" [0 0 0] \"to\" [0 -1 0]\n",
     "AttributeBegin Translate 0 50 6 Rotate 90 1 0 0 Disk 0 9 360 AttributeEnd " + ball,
     "lies in shadow: something stands between it and light \"1\""},
};

class Black : public testing::TestWithParam<std::tuple<BlackScene, const char *, const char *>> {};

TEST_P(Black, SaysWhy) {
    const auto &[scene, integrator, space] = GetParam();
    const bool isSi = std::string(integrator) != "classic";
    if (std::string(space) != "" && scene.reason.find("camera") != std::string::npos)
        return; // The whole space is moved, and with it what is before the camera.
    ScratchFolder folder;
    folder.write("scene.rib", "Format 48 36 1 Projection \"perspective\" \"fov\" 40 " +
                                  scene.options +
                                  (isSi ? "Option \"radiometry\" \"string units\" \"si\"" : "") +
                                  "\n" + std::string(space) + "WorldBegin\n" + scene.lights +
                                  "Surface \"matte\"\n" + scene.shapes + "\nWorldEnd\n");
    const Outcome run = runCandela({"scene.rib", "--spp", "4", "--integrator", integrator},
                                   {.folder = folder.path()});
    const std::size_t at = run.err.find("the picture is black: ");
    ASSERT_NE(at, std::string::npos) << run.text();
    EXPECT_NE(run.err.find(scene.reason, at), std::string::npos) << run.text();
    EXPECT_TRUE(run.says(scene.alsoSays)) << run.text();
}

INSTANTIATE_TEST_SUITE_P(Scenes, Black,
                         testing::Combine(testing::ValuesIn(scenes),
                                          testing::Values("classic", "path"),
                                          testing::Values("", "Scale -1 1 1 ")),
                         [](const auto &info) {
                             return std::string(std::get<0>(info.param).name) + "_" +
                                    std::get<1>(info.param) +
                                    (std::get<2>(info.param)[0] ? "_mirrored" : "");
                         });

TEST(NotBlack, IsNotExplained) {
    ScratchFolder folder;
    folder.write("scene.rib", "Format 48 36 1 Projection \"perspective\" \"fov\" 40\nWorldBegin\n" +
                                  lamp + "Surface \"matte\"\n" + ball + "WorldEnd\n");
    const Outcome run = runCandela({"scene.rib"}, {.folder = folder.path()});
    EXPECT_FALSE(run.says("black")) << run.text();
    EXPECT_FALSE(run.says("shines on nothing")) << run.text();
    EXPECT_EQ(run.err, "");
    EXPECT_NE(run.out.find("cast no shadows under the integrator \"classic\""), std::string::npos)
        << run.out;
    const Outcome path =
        runCandela({"scene.rib", "--integrator", "path"}, {.folder = folder.path()});
    EXPECT_EQ(path.out.find("shadows"), std::string::npos) << path.out;
}

} // namespace

} // namespace candela::test
