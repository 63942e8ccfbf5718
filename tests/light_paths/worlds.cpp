// SPDX-License-Identifier: Apache-2.0
#include "tests/light_paths/worlds.h"

namespace candela::test {

namespace {

/// Under the ceiling, shining down.
const std::string ceilingLamp = "Polygon \"P\" [-.3 .99 -.3 .3 .99 -.3 .3 .99 .3 -.3 .99 .3]\n";
const std::string ball = "Translate .3 .5 0\nSphere .1 -.1 .1 360\n";

std::string block(const std::string &text) { return "AttributeBegin\n" + text + "AttributeEnd\n"; }

const std::string plasticBall =
    block("Surface \"plastic\" \"Kd\" [.4] \"Ks\" [.4] \"roughness\" [.1]\nTranslate -.4 -.6 .3\n"
          "Sphere .4 -.4 .4 360\n");
const std::string sheet = "Polygon \"P\" [-.8 .1 -.8 .8 .1 -.8 .8 .2 .8 -.8 .2 .8]\n";

const std::string fog =
    "Atmosphere \"fog\" \"float distance\" [1.5] \"color background\" [.01 .02 .01]\n";
/// The volume of a body.
const std::string inside =
    "Interior \"absorption\" \"color transmittance\" [.1 .4 .2] \"float distance\" [.3]\n";

/// Lets most light through and holds a volume: what 30 cm leave of white light.
std::string shell(const std::string &transmittance, const std::string &shape) {
    return block("Surface \"matte\" \"Ka\" [0] \"Kd\" [.5]\nOpacity .2 .2 .2\n"
                 "Interior \"absorption\" \"color transmittance\" [" +
                 transmittance + "] \"float distance\" [.3]\n" + shape);
}
const std::string innerBall = block("Surface \"matte\" \"Ka\" [0] \"Kd\" [.7]\n"
                                    "Translate -.1 -.3 0\nSphere .35 -.35 .35 360\n");

std::string bodyOf(const std::string &surface, const std::string &shape) {
    return block("Surface " + surface + "\nTranslate -.3 -.5 .1\n" + shape);
}

std::string pointLight(int number, const std::string &from) {
    return "LightSource \"pointlight\" " + std::to_string(number) +
           " \"float intensity\" [2] \"point from\" [" + from + "]\n";
}

/// Quadrics and patches as lamps; all of them shine to both sides.
std::vector<World> lampsOfEachShape() {
    const std::pair<const char *, const char *> shapes[] = {
        {"Disk", "Disk 0 .2 360\n"},
        {"Cylinder", "Cylinder .1 -.2 .2 360\n"},
        {"Cone", "Cone .3 .15 360\n"},
        {"Paraboloid", "Paraboloid .2 0 .3 360\n"},
        {"Hyperboloid", "Hyperboloid .1 0 -.1 .15 .1 .2 360\n"},
        {"Torus", "Torus .15 .05 0 360 360\n"},
        {"Bilinear", "Patch \"bilinear\" \"P\" [-.2 0 0 .2 0 .1 -.2 .2 0 .2 .2 0]\n"},
        {"Triangle", "Polygon \"P\" [-.2 0 0 .2 0 0 0 .3 .1]\n"},
    };
    std::vector<World> all;
    for (const auto &[name, shape] : shapes)
        all.push_back({std::string("LampOf") + name, "",
                       lamp("Translate .2 .4 .1\nRotate 60 1 0 0\n" + std::string(shape), 5,
                            "\"float onesided\" [0]") +
                           room()});
    return all;
}

/// Surfaces of the library that no other world has.
std::vector<World> otherSurfaces() {
    std::vector<World> all;
    for (const char *name : {"defaultsurface", "metal", "paintedmatte", "paintedplastic", "phong"})
        all.push_back({"SurfaceOf" + std::string(name), "",
                       lamp(ceilingLamp, 10) + room() +
                           bodyOf("\"" + std::string(name) + "\"", "Sphere .45 -.45 .45 360\n")});
    return all;
}

} // namespace

std::string room() {
    return block("Surface \"matte\" \"Ka\" [0] \"Kd\" [.7]\nColor [.8 .2 .2]\n"
                 "Polygon \"P\" [-1 -1 -1 -1 -1 1 -1 1 1 -1 1 -1]\nColor [.2 .8 .2]\n"
                 "Polygon \"P\" [1 -1 -1 1 -1 1 1 1 1 1 1 -1]\nColor [.8 .8 .8]\n"
                 "Polygon \"P\" [-1 -1 -1 1 -1 -1 1 -1 1 -1 -1 1]\n"
                 "Polygon \"P\" [-1 1 -1 1 1 -1 1 1 1 -1 1 1]\n"
                 "Polygon \"P\" [-1 -1 1 1 -1 1 1 1 1 -1 1 1]\n");
}

std::string lamp(const std::string &shape, double radiance, const std::string &more) {
    return block("AreaLightSource \"arealight\" 1 \"float radiance\" [" + std::to_string(radiance) +
                 "] " + more + "\nSurface \"matte\" \"Ka\" [0] \"Kd\" [0]\n" + shape) +
           "Illuminate 1 1\n";
}

std::vector<World> worlds() {
    const std::string walls = room();
    std::vector<World> all = {
        {"Room", "", lamp(ceilingLamp, 10) + walls + plasticBall},
        {"Mirrored", "Scale -1 1 1\n", lamp(ceilingLamp, 10) + walls + plasticBall},
        {"Tiny", "", "Scale .001 .001 .001\n" + lamp(ceilingLamp, 10) + walls + plasticBall},
        {"Huge", "", "Scale 1000 1000 1000\n" + lamp(ceilingLamp, 10) + walls + plasticBall},
        {"FarAway", "Translate -100000 0 0\n",
         "Translate 100000 0 0\n" + lamp(ceilingLamp, 10) + walls},
        {"LampOfBothSides", "",
         lamp("Polygon \"P\" [-.3 .6 -.3 .3 .6 -.3 .3 .6 .3 -.3 .6 .3]\n", 5,
              "\"float onesided\" [0]") +
             walls},
        {"SphereLamp", "", lamp(ball, 20) + walls + plasticBall},
        {"LampByASurface", "",
         block("Surface \"constant\"\nColor [6 5 4]\n" + ceilingLamp) + walls + plasticBall},
        {"PointLight", "", pointLight(2, ".2 .5 0") + walls + plasticBall},
        {"Spot", "",
         "LightSource \"spotlight\" 3 \"float intensity\" [5] \"point from\" [.6 .9 -.5] "
         "\"point to\" [0 -1 0] \"float coneangle\" [.4]\n" +
             walls + plasticBall},
        {"Sun", "",
         "LightSource \"distantlight\" 2 \"float intensity\" [3] \"point from\" [.3 .5 -1] "
         "\"point to\" [0 0 0]\n" +
             walls + plasticBall},
        {"Sky", "",
         lamp("ReverseOrientation\nSphere 50 -50 50 360\n", .5) + pointLight(2, ".2 .5 0") + walls,
         true},
        {"Linked", "",
         pointLight(2, ".2 .5 0") + pointLight(3, "-.5 .5 0") + "Illuminate 3 0\n" + walls +
             "Illuminate 3 1\nIlluminate 2 0\n" + plasticBall},
        {"Opacity", "",
         lamp(ball, 20) + walls +
             block("Surface \"matte\" \"Ka\" [0] \"Kd\" [.5]\nOpacity .3 .6 .8\n" + sheet)},
        {"OpacityUnderAPoint", "",
         pointLight(2, ".2 .7 0") + walls +
             block("Surface \"matte\" \"Ka\" [0] \"Kd\" [.5]\nOpacity .3 .6 .8\n" + sheet)},
        {"OneSided", "",
         lamp(ball, 20) + walls +
             block("Sides 1\nSurface \"matte\" \"Ka\" [0] \"Kd\" [.8]\n" + sheet +
                   "Polygon \"P\" [-.6 -.3 .8 .6 -.3 .8 .6 -.2 -.8 -.6 -.2 -.8]\n")},
        {"RoughMetal", "",
         lamp(ceilingLamp, 10) + walls +
             bodyOf("\"roughmetal\" \"alpha\" [.2]", "Sphere .45 -.45 .45 360\n")},
        {"TwoScatterings", "Option \"trace\" \"integer maxdepth\" [2]\n",
         lamp(ceilingLamp, 10) + walls + plasticBall},
        {"Mirror", "",
         lamp(ceilingLamp, 10) + walls + bodyOf("\"mirror\"", "Sphere .4 -.4 .4 360\n")},
        {"Glass", "",
         lamp("Translate .4 .6 -.2\nSphere .2 -.2 .2 360\n", 8) + walls +
             bodyOf("\"glass\"", "Sphere .4 -.4 .4 360\n")},
        {"BallInGlass", "",
         lamp("Translate .4 .6 -.2\nSphere .2 -.2 .2 360\n", 8) + walls +
             bodyOf("\"glass\"",
                    "Sphere .45 -.45 .45 360\nSurface \"matte\" \"Ka\" [0] \"Kd\" [.7]\n"
                    "Sphere .25 -.25 .25 360\n")},
        {"BumpyBall", "",
         lamp(ceilingLamp, 10) + walls + bodyOf("\"turned\"", "Sphere .45 -.45 .45 360\n")},
        {"TurnedCones", "",
         lamp(ceilingLamp, 10) + walls + bodyOf("\"stated\"", "Sphere .45 -.45 .45 360\n")},
        {"EyeOfTheCamera", "",
         lamp(ceilingLamp, 10) + walls + bodyOf("\"eyed\"", "Sphere .45 -.45 .45 360\n")},
        {"Toon", "",
         lamp(ceilingLamp, 10) + walls + bodyOf("\"squared\"", "Sphere .45 -.45 .45 360\n"), true},
        {"Instances", "",
         lamp(ceilingLamp, 10) + "ObjectBegin 1\nSphere .4 -.4 .4 360\nObjectEnd\n" + walls +
             block("Surface \"plastic\" \"Ka\" [0]\nTranslate -.4 -.6 .3\nScale -1 .7 1\n"
                   "ObjectInstance 1\n") +
             block("Surface \"matte\" \"Ka\" [0]\nTranslate .4 -.3 .3\nScale .4 .7 .3\n"
                   "ObjectInstance 1\n")},
        {"Fog", "", fog + lamp(ceilingLamp, 10) + walls + plasticBall},
        {"FogUnderAPoint", "", fog + pointLight(2, ".2 .5 0") + walls + plasticBall},
        {"FogUnderASun", "",
         fog +
             "LightSource \"distantlight\" 2 \"float intensity\" [3] \"point from\" [.3 .5 -1] "
             "\"point to\" [0 0 0]\n" +
             walls + plasticBall},
        {"FogBehindAGlassySheet", "",
         fog + lamp(ball, 20) + walls +
             block("Atmosphere \"fog\" \"float distance\" [1]\nSurface \"matte\" \"Ka\" [0] \"Kd\" "
                   "[.5]\nOpacity .3 .6 .8\n" +
                   sheet)},
        {"FogFromTheEyeOn", "Clipping 2 100\n", fog + lamp(ceilingLamp, 10) + walls},
        {"DarkGlass", "",
         lamp("Translate .4 .6 -.2\nSphere .2 -.2 .2 360\n", 8) + walls +
             bodyOf("\"glass\"\n" + inside, "Sphere .45 -.45 .45 360\nInterior \"null\"\nSurface "
                                            "\"matte\" \"Ka\" [0] \"Kd\" [.7]\n"
                                            "Sphere .25 -.25 .25 360\n")},
        {"LampInAColoredBody", "",
         shell(".1 .4 .2", "Sphere .9 -.9 .9 360\n") + lamp(ball, 40) + innerBall + walls},
        {"BallInAColoredBody", "",
         lamp("Translate .6 .8 -.6\nSphere .1 -.1 .1 360\n", 40) +
             shell(".1 .4 .2", "Translate 0 -.3 0\nSphere .6 -.6 .6 360\n") + innerBall + walls},
        {"BodiesThatOverlap", "",
         lamp("Translate -.8 .6 -.2\nSphere .1 -.1 .1 360\n", 40) +
             shell(".6 .95 .8", "Translate .1 -.1 .1\nSphere .6 -.6 .6 360\n") +
             shell(".95 .6 .8", "Translate .25 -.2 .1\nSphere .6 -.6 .6 360\n") + walls},
        {"BodyInFog", "",
         fog + lamp(ball, 20) + walls + bodyOf("\"glass\"\n" + inside, "Sphere .4 -.4 .4 360\n")},
        {"TwoKindsOfLight", "", lamp(ceilingLamp, 3) + pointLight(2, "-.5 0 -.5") + walls},
    };
    for (const std::vector<World> &more : {lampsOfEachShape(), otherSurfaces()})
        all.insert(all.end(), more.begin(), more.end());
    return all;
}

} // namespace candela::test
