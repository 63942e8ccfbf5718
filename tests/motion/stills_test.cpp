// SPDX-License-Identifier: Apache-2.0
// A picture of what moves is the mean of pictures of it where it is at times: light and shadow,
// patterns, in company of all that places things.
#include "foundation/base/student.h"
#include "tests/support/frames.h"

#include <cmath>
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

std::string request(const char *name, std::initializer_list<double> numbers) {
    std::ostringstream text;
    text.precision(9);
    text << name;
    for (double number : numbers)
        text << ' ' << number;
    text << '\n';
    return text.str();
}

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

/// What stands in the place of "@\n" in the world: the motion, or the thing at a time.
std::string withMotion(std::string world, const std::string &motion) {
    for (std::size_t at; (at = world.find("@\n")) != std::string::npos;)
        world.replace(at, 2, motion);
    return world;
}

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

/// A quarter of a picture of 8 x 8 pixels.
FramePixels quarterOf(const FramePixels &picture, int quarter) {
    FramePixels part;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            part.red.push_back(
                picture.red[std::size_t(8 * (row + quarter / 2 * 4) + column + quarter % 2 * 4)]);
    return part;
}

class MovingScenes : public testing::TestWithParam<Scene> {};

TEST_P(MovingScenes, AreTheMeanOfStills) {
    constexpr int moments = 24, samples = 16;
    for (const char *integrator : {"classic", "path"})
        for (const Move &move : moves) {
            if (std::string(integrator) == "classic" &&
                std::string(GetParam().name) == "ShiningSurface")
                continue;
            SCOPED_TRACE(std::string(integrator) + " " + move.name);
            const std::string options =
                "Option \"render\" \"string integrator\" \"" + std::string(integrator) +
                "\"\nShutter 0 1\nProjection \"orthographic\"\nScreenWindow -1 1 -1 1\n";
            // At the ends alone, and where what turns may not go straight.
            const std::string motion =
                "MotionBegin [0 1]\n" + move.at(0) + move.at(1) + "MotionEnd\n";
            std::vector<Frame> stills;
            for (int moment = 0; moment < moments; ++moment)
                stills.push_back({"still", options,
                                  withMotion(GetParam().world, move.at((moment + .5) / moments))});
            const auto each = render(stills, {samples, 1, "motion/shaders"});
            const auto moving = render({{"moving", options, withMotion(GetParam().world, motion)}},
                                       {samples * moments, 2, "motion/shaders"});
            ASSERT_EQ(each.size(), stills.size());
            ASSERT_EQ(moving.size(), 1u);
            FramePixels mean = each.front();
            for (std::size_t k = 0; k < mean.red.size(); ++k) {
                mean.red[k] = 0;
                for (const FramePixels &still : each)
                    mean.red[k] += still.red[k] / moments;
            }
            const RedComparison found = compareRed(moving.front(), mean);
            EXPECT_GT(found.mean, .01);
            // The mean over moments is that of an integral by its midpoints.
            EXPECT_NEAR(found.difference.mean, 0,
                        4 * found.difference.standardError + .003 * found.mean);
            for (int quarter = 0; quarter < 4; ++quarter) {
                SCOPED_TRACE("quarter " + std::to_string(quarter));
                const RedComparison part =
                    compareRed(quarterOf(moving.front(), quarter), quarterOf(mean, quarter));
                EXPECT_NEAR(part.difference.mean, 0,
                            6 * part.difference.standardError + .01 * found.mean);
            }
        }
}

INSTANTIATE_TEST_SUITE_P(, MovingScenes, testing::ValuesIn(scenes),
                         [](const auto &param) { return std::string(param.param.name); });

} // namespace

} // namespace candela::test
