// SPDX-License-Identifier: Apache-2.0
// Legal scenes whose light is not what their authors think: each is told once, and others are not.
#include "tests/support/program.h"
#include "tests/support/scratch_folder.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace candela::test {

namespace {

const std::string sun =
    "LightSource \"distantlight\" \"sun\" \"intensity\" 3 \"from\" [1 3 -2] \"to\" [0 0 0]\n";
const std::string ball = "AttributeBegin Surface \"matte\" Translate 0 0 6 Sphere 1 -1 1 360 "
                         "AttributeEnd\n";
std::string shining(const std::string &shapes) {
    return "AttributeBegin Color .2 .4 .8 Surface \"constant\"\n" + shapes + " AttributeEnd\n";
}
const std::string sky = "Sphere 90 -90 90 360";
/// A room without windows, of walls that only reflect.
const std::string room =
    "AttributeBegin Surface \"matte\" PointsPolygons [4 4 4 4 4 4] [0 1 2 3 4 5 6 7 0 1 5 4 3 2 6 "
    "7 "
    "0 3 7 4 1 2 6 5] \"P\" [-9 -9 -9 -9 9 -9 9 9 -9 9 -9 -9 -9 -9 9 -9 9 9 9 9 9 9 -9 9] "
    "AttributeEnd\n";

std::string lamp(const std::string &surface, const std::string &light = "\"radiance\" 5") {
    return "AttributeBegin AreaLightSource \"arealight\" \"lamp\" " + light + "\n" + surface +
           " Translate 0 4 6 Rotate 90 1 0 0 Disk 0 1 360 AttributeEnd Illuminate \"lamp\" 1\n";
}

int timesSaid(const std::string &text, const std::string &words) {
    int times = 0;
    for (std::size_t at = text.find(words); at != text.npos; at = text.find(words, at + 1))
        ++times;
    return times;
}

struct Trap {
    const char *name;
    std::string world;
    std::string told; ///< Empty: nothing is.
};

const std::string shutOut = "light \"sun\" (\"distantlight\") is shut out: ";
const std::string adds =
    "light \"lamp\" (\"arealight\"): the surface shader of its shapes adds light "
    "of its own, ";

const Trap traps[] = {
    {"SkySphere", sun + shining(sky) + ball,
     shutOut + "a surface with shader \"constant\" (scene.rib:4:"},
    {"SkyDome", sun + shining("Rotate -90 1 0 0 Sphere 90 0 90 360") + ball, shutOut},
    {"SkyBoxWithGround",
     sun +
         shining(
             "Translate 0 0 0 PointsPolygons [4 4 4 4 4] [4 5 6 7 0 1 5 4 3 2 6 7 0 3 7 4 1 2 6 "
             "5] \"P\" [-90 -9 -90 -90 90 -90 90 90 -90 90 -9 -90 -90 -9 90 -90 90 90 90 90 90 "
             "90 -9 90] PointsPolygons [4] [0 1 2 3] \"P\" [-90 -9 -90 -90 90 -90 90 90 -90 90 "
             "-9 -90]") +
         "AttributeBegin Surface \"matte\" Polygon \"P\" [-80 -2 -80 -80 -2 80 80 -2 80 80 -2 -80] "
         "AttributeEnd\n" +
         ball,
     shutOut},
    {"SkyLamp",
     sun +
         "AttributeBegin AreaLightSource \"arealight\" \"dome\" \"radiance\" 1 \"onesided\" 0\n"
         "Surface \"matte\" " +
         sky + " AttributeEnd Illuminate \"dome\" 1\n" + ball,
     shutOut + "light \"dome\" (\"arealight\")"},
    {"SkyInstance",
     "ObjectBegin 1 Surface \"constant\" " + sky + " ObjectEnd\n" + sun +
         "AttributeBegin Scale 2 2 2 ObjectInstance 1 AttributeEnd\n" + ball,
     shutOut},
    {"SkyBehindThings",
     sun + shining(sky) + ball + ball +
         "AttributeBegin Surface \"matte\" Translate 4 12 -8 Sphere 9 -9 9 360 AttributeEnd\n",
     shutOut},
    {"NoSky", sun + ball, ""},
    {"SkyWithoutSun", shining(sky) + ball, ""},
    {"SkyThatSunPasses", sun + shining("Attribute \"visibility\" \"int shadow\" 0 " + sky) + ball,
     ""},
    {"SkyThatIsNotOpaque", sun + shining("Opacity .5 .5 .5 " + sky) + ball, ""},
    {"SkyOpenToTheSun", sun + shining("Rotate 126 0 0 1 Sphere 90 -90 90 250") + ball, ""},
    {"RoomWithoutWindows", sun + room + lamp("Surface \"matte\"") + ball, ""},
    {"RoomInASkyThatSunPasses",
     sun + room + shining("Attribute \"visibility\" \"int shadow\" 0 " + sky) +
         lamp("Surface \"matte\"") + ball,
     ""},
    {"PanelOverhead", sun + shining("Translate 0 4 6 Rotate 90 1 0 0 Disk 0 1 360") + ball, ""},
    {"LampInSky",
     "LightSource \"pointlight\" \"bulb\" \"intensity\" 9 \"from\" [0 4 0]\n" + shining(sky) + ball,
     ""},
    {"ConstantLamp", lamp("Surface \"constant\"") + ball, adds + "1 W m^-2 sr^-1"},
    {"ColouredConstantLamp", lamp("Color .6 .3 0 Surface \"constant\"") + ball,
     adds + "0.3 W m^-2 sr^-1"},
    {"GlowingLamp", lamp("Surface \"glow\" \"radiance\" 2") + ball, adds + "2 W m^-2 sr^-1"},
    {"TwoConstantLamps", lamp("Surface \"constant\"") + lamp("Surface \"matte\"") + ball, adds},
    {"LampInstance",
     "ObjectBegin 1 Disk 0 1 360 ObjectEnd\n" + sun +
         "AttributeBegin AreaLightSource \"arealight\" \"lamp\" \"radiance\" 5 "
         "Surface \"constant\" Translate 0 4 6 Rotate 90 1 0 0 ObjectInstance 1 AttributeEnd "
         "Illuminate \"lamp\" 1\n" +
         ball,
     adds},
    {"MatteLamp", lamp("Surface \"matte\"") + ball, ""},
    {"BlackConstantLamp", lamp("Color 0 0 0 Surface \"constant\"") + ball, ""},
    {"DarkGlowingLamp", lamp("Surface \"glow\" \"radiance\" 0") + ball, ""},
    {"ConstantBesidesALamp",
     lamp("Surface \"matte\"") + shining("Translate 3 0 6 Sphere 1 -1 1 360") + ball, ""},
    {"StrongLamp", lamp("Surface \"constant\"", "\"radiance\" 50000") + ball, ""},
};

class LightTrap : public testing::TestWithParam<
                      std::tuple<Trap, const char *, std::pair<const char *, const char *>>> {};

TEST_P(LightTrap, IsToldOnceOrNotAtAll) {
    const auto &[trap, integrator, space] = GetParam();
    ScratchFolder folder;
    folder.write("glow.sl", "surface glow(float radiance = 1;) { Ci = radiance; Oi = Os; }\n");
    folder.write("scene.rib", "Format 16 12 1 Projection \"perspective\" \"fov\" 40 "
                              "Option \"radiometry\" \"string units\" \"si\"\n" +
                                  std::string(space.second) + " WorldBegin\n" + trap.world +
                                  "WorldEnd\n");
    const Outcome run = runCandela({"scene.rib", "--spp", "1", "--integrator", integrator},
                                   {.folder = folder.path()});
    EXPECT_EQ(run.status, 0) << run.text();
    EXPECT_EQ(run.errBesidesLight(), "");
    const bool isTrap = !trap.told.empty() && std::string(integrator) != "classic";
    EXPECT_EQ(timesSaid(run.err, " is shut out: ") + timesSaid(run.err, " of its own, "), isTrap)
        << run.text();
    EXPECT_TRUE(!isTrap || run.says(trap.told)) << run.text();
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, LightTrap,
    testing::Combine(testing::ValuesIn(traps), testing::Values("path", "classic"),
                     testing::Values(std::pair("asItIs", ""), std::pair("mirrored", "Scale -1 1 1"),
                                     std::pair("small", "Scale .001 .001 .001"),
                                     std::pair("farAway", "Translate 3000 0 0"))),
    [](const auto &info) {
        return std::string(std::get<0>(info.param).name) + "_" + std::get<1>(info.param) + "_" +
               std::get<2>(info.param).first;
    });

} // namespace

} // namespace candela::test
