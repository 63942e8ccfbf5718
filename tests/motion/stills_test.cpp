// SPDX-License-Identifier: Apache-2.0
// A picture of what moves is the mean of pictures of it where it is at times: light and shadow,
// patterns, in company of all that places things.
#include "tests/motion/stills.h"

#include <gtest/gtest.h>
#include <ostream>
#include <sstream>

namespace candela::test {

namespace {

/// A transformation request, by the share of the shutter's interval that has passed.
struct Move {
    const char *name;
    std::function<std::string(double share)> at;
};

const Move moves[] = {
    {"Translate",
     [](double s) {
         return request("Translate", {1.2 * s - .6, .3 * s, .2 * s});
     }},
    {"Rotate",
     [](double s) {
         return request("Rotate", {100 * s, .2, .3, 1});
     }},
    {"Scale",
     [](double s) {
         return request("Scale", {1 + s, 1 - .4 * s, 1 + .5 * s});
     }},
};

struct Scene {
    const char *name, *world;
};

void PrintTo(const Scene &scene, std::ostream *stream) { *stream << scene.name; }

/// Seen from above, a white floor at z = 4 that is two metres wide.
#define FLOOR "Illuminate 1 1\n" UNLIT_FLOOR
#define UNLIT_FLOOR "Surface \"matte\"\nPolygon \"P\" [-2 -2 4 -2 2 4 2 2 4 2 -2 4]\n"
#define LAMP "AreaLightSource \"arealight\" 1 \"radiance\" 4\nSurface \"constant\"\n"
#define QUAD "Polygon \"P\" [-.4 -.2 0 .4 -.2 0 .4 .2 0 -.4 .2 0]\n"

const Scene scenes[] = {
    {"FlatLamp", "AttributeBegin\nTranslate 0 0 3\n@\n" LAMP QUAD "AttributeEnd\n" FLOOR},
    {"LampOfPieces", "AttributeBegin\nTranslate 0 0 2.6\n@\n" LAMP
                     "Rotate 70 1 0 0\nTorus .4 .1 0 360 360\nAttributeEnd\n" FLOOR},
    {"RoundLamp", "AttributeBegin\nTranslate 0 0 3\n@\nTranslate .1 0 0\n" LAMP
                  "Sphere .2 -.2 .2 360\nAttributeEnd\n" FLOOR},
    {"LampInAMirror",
     "AttributeBegin\nTranslate 0 0 3\nScale 1 -1 1\n@\n" LAMP QUAD "AttributeEnd\n" FLOOR},
    {"OneSidedLamp",
     "AttributeBegin\nSides 1\nTranslate 0 0 3\n@\n" LAMP QUAD "AttributeEnd\n" FLOOR},
    {"ShiningSurface", "AttributeBegin\nTranslate 0 0 3\n@\nSurface \"glow\" \"radiance\" 4\n" QUAD
                       "AttributeEnd\n" UNLIT_FLOOR},
    {"LampsInObjects", "ObjectBegin 1\n" QUAD "ObjectEnd\nAttributeBegin\nTranslate 0 0 3\n@\n" LAMP
                       "ObjectInstance 1\nAttributeEnd\nAttributeBegin\n"
                       "Translate 0 0 2\n@\nTranslate 0 .5 0\nScale .5 .5 .5\n"
                       "AreaLightSource \"arealight\" 2 \"radiance\" 9\nSurface \"constant\"\n"
                       "ObjectInstance 1\nAttributeEnd\nIlluminate 2 1\n" FLOOR},
    {"LampMovingInItsObject", "ObjectBegin 1\n@\n" QUAD "ObjectEnd\n"
                              "AttributeBegin\nTranslate 0 0 3\n" LAMP
                              "ObjectInstance 1\nTranslate 0 .6 0\nObjectInstance 1\n"
                              "AttributeEnd\n" FLOOR},
    {"PointLight",
     "AttributeBegin\nTranslate 0 0 3\n@\nLightSource \"pointlight\" 1 \"intensity\" 1 "
     "\"from\" [.3 0 0]\nAttributeEnd\n" FLOOR},
    {"SpotLight", "AttributeBegin\nTranslate 0 0 2\n@\nLightSource \"spotlight\" 1 \"intensity\" 3 "
                  "\"from\" [.3 0 0] \"to\" [0 0 2] \"coneangle\" .5 \"conedeltaangle\" .1\n"
                  "AttributeEnd\n" FLOOR},
    {"Shadow", "Attribute \"light\" \"string shadows\" \"on\"\nLightSource \"pointlight\" 1 "
               "\"intensity\" 9 \"from\" [.5 0 -1]\nAttributeBegin\nTranslate 0 0 3\n@\n"
               "Surface \"matte\"\n" QUAD "AttributeEnd\n" FLOOR},
    {"PatternThatMovesAlong", "Translate 0 0 3\n@\nSurface \"stripes\"\n"
                              "Polygon \"P\" [-2 -2 0 -2 2 0 2 2 0 2 -2 0]\n"},
    {"ObjectSpace", "Translate 0 0 3\n@\nSurface \"stripes\" \"space\" \"object\"\n"
                    "Polygon \"P\" [-2 -2 0 -2 2 0 2 2 0 2 -2 0]\n"},
    {"PatternThatStands", "Surface \"stripes\"\nTranslate 0 0 3\n@\n"
                          "Polygon \"P\" [-2 -2 0 -2 2 0 2 2 0 2 -2 0]\n"},
    {"ParameterThatMovesAlong", "Translate 0 0 3\n@\nSurface \"place\" \"centre\" [.1 .2 .3]\n"
                                "Polygon \"P\" [-2 -2 0 -2 2 0 2 2 0 2 -2 0]\n"},
    {"RoundThings", "LightSource \"pointlight\" 1 \"intensity\" 9 \"from\" [2 1 -2]\n"
                    "Surface \"matte\"\nTranslate 0 0 3\n@\nSphere .4 -.4 .4 360\n"
                    "Translate 0 .5 0\nTorus .3 .1 0 360 360\n"},
};

class MovingScenes : public testing::TestWithParam<Scene> {};

TEST_P(MovingScenes, AreTheMeanOfStills) {
    for (const char *integrator : {"classic", "path"})
        for (const Move &move : moves) {
            if (std::string(integrator) == "classic" &&
                std::string(GetParam().name) == "ShiningSurface")
                continue;
            SCOPED_TRACE(std::string(integrator) + " " + move.name);
            expectMeanOfStills(integrator, GetParam().world, move.at);
        }
}

INSTANTIATE_TEST_SUITE_P(, MovingScenes, testing::ValuesIn(scenes),
                         [](const auto &param) { return std::string(param.param.name); });

} // namespace

} // namespace candela::test
