// SPDX-License-Identifier: Apache-2.0
// Levels of detail: which are drawn at what size, and what is dissolved into another adds up to
// one.
#include "tests/presence/views.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace candela::test {
namespace {

/// A square of side 1, 16 pixels wide: 256 of them, a sixteenth of the picture.
const std::string square = "Polygon \"P\" [-.5 -.5 0 .5 -.5 0 .5 .5 0 -.5 .5 0]\n";
const std::string detail = "Detail [-.5 .5 -.5 .5 0 0]\n";

struct Level {
    const char *range;
    double share; ///< Of paths that meet it.
};
const Level levels[] = {
    {"DetailRange [0 0 1e38 1e38]\n", 1},       {"DetailRange [0 0 100 200]\n", 0},
    {"DetailRange [300 300 400 400]\n", 0},     {"DetailRange [0 0 256 300]\n", 1},
    {"DetailRange [192 448 1e38 1e38]\n", .25}, {"DetailRange [0 0 192 448]\n", .75},
    {"DetailRange [10 20 240 272]\n", .5},      {"DetailRange [100 256 256 300]\n", 1},
};

/// Where and how a level is said; %s is its range.
struct Place {
    const char *name, *text;
};
const Place places[] = {
    {"plain", "DETAIL%sSQUARE"},
    {"mirrored", "Scale -1 1 1\nDETAIL%sSQUARE"},
    {"turned", "Rotate 90 0 0 1\nDETAIL%sSQUARE"},
    {"of an instance", "ObjectBegin 1\nSQUAREObjectEnd\nDETAIL%sObjectInstance 1\n"},
    {"of an object", "ObjectBegin 1\nDETAIL%sSQUAREObjectEnd\nObjectInstance 1\n"},
    {"of an object that its instances make larger",
     "ObjectBegin 1\nScale .5 .5 .5\nDETAIL%sSQUAREObjectEnd\nScale 2 2 1\nObjectInstance 1\n"
     "Translate 9 0 0\nObjectInstance 1\n"},
    {"one-sided", "Sides 1\nReverseOrientation\nDETAIL%sSQUARE"},
    {"a cut square", "SolidBegin \"union\"\nDETAIL%sSolidBegin \"primitive\"\nTranslate -.5 -.5 "
                     "0\nPointsPolygons [4 4 4 4 4 4] [0 2 3 1 4 5 7 6 0 1 5 4 2 6 7 3 0 4 6 2 1 3 "
                     "7 5] \"P\" [0 0 0 1 0 0 0 1 0 1 1 0 0 0 1 1 0 1 0 1 1 1 1 1]\nSolidEnd\n"
                     "SolidBegin \"primitive\"\nTranslate 9 0 0\nSphere 1 -1 1 360\nSolidEnd\n"
                     "SolidEnd\n"},
};

std::string said(const Place &place, const std::string &range) {
    std::string text = place.text;
    for (const auto &[word, rib] :
         {std::pair<std::string, std::string>{"DETAIL", detail}, {"%s", range}, {"SQUARE", square}})
        if (const std::size_t at = text.find(word); at != std::string::npos)
            text.replace(at, word.size(), rib);
    return text;
}

TEST(LevelOfDetail, IsDrawnAsItsSizeSays) {
    std::vector<Frame> frames;
    std::vector<double> wanted;
    for (const char *integrator : {"classic", "path"})
        for (const char *shutter : {"", "Shutter 0 1\n"})
            for (const Place &place : places)
                for (const Level &level : levels) {
                    frames.push_back({std::string(place.name) + ", " + level.range,
                                      shutter + view(integrator),
                                      "Surface \"constant\"\n" + said(place, level.range)});
                    wanted.push_back(level.share / 16);
                }
    const auto pictures = render(frames, {64, 1, ""});
    ASSERT_EQ(pictures.size(), frames.size());
    for (std::size_t i = 0; i < frames.size(); ++i) {
        SCOPED_TRACE(frames[i].name);
        EXPECT_NEAR(meanOf(pictures[i].alpha), wanted[i], 2e-3 * wanted[i]);
    }
}

TEST(LevelOfDetail, GoesByRelativeDetail) {
    const auto pictures =
        render({{"half", "RelativeDetail .5\n" + view("path"),
                 "Surface \"constant\"\n" + detail + "DetailRange [64 192 1e38 1e38]\n" + square},
                {"nothing", "RelativeDetail 0\n" + view("path"),
                 "Surface \"constant\"\n" + detail + "DetailRange [1 1 1e38 1e38]\n" + square}},
               {64, 1, ""});
    ASSERT_EQ(pictures.size(), 2u);
    EXPECT_NEAR(meanOf(pictures[0].alpha) * 16, .5, 1e-3);
    EXPECT_EQ(meanOf(pictures[1].alpha), 0);
}

TEST(LevelOfDetail, TwoInTransitionAreWorthOne) {
    // Each path meets one of both, with its shadow and its reflection; as one alone would show it.
    const std::string rest = "LightSource \"pointlight\" 1 \"from\" [1 1 -2] \"intensity\" 20\n"
                             "Surface \"matte\"\nTranslate 0 0 1\nPolygon \"P\" [-2 -2 0 2 -2 0 2 "
                             "2 0 -2 2 0]\nTranslate 0 0 -1\n";
    const std::string first = "DetailRange [0 0 180 400]\n", second = "DetailRange [180 400 1e38 "
                                                                      "1e38]\n";
    std::vector<Frame> frames;
    for (const char *integrator : {"classic", "path"})
        for (const char *shutter : {"", "Shutter 0 1\n"})
            for (const std::string &body :
                 {square, detail + first + square + second + square,
                  "ObjectBegin 1\n" + square + "ObjectEnd\n" + detail + first +
                      "ObjectInstance 1\n" + second + "ObjectInstance 1\n"})
                frames.push_back({integrator, shutter + view(integrator), rest + body});
    const auto pictures = render(frames, {16, 1, ""});
    ASSERT_EQ(pictures.size(), frames.size());
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const FramePixels &one = pictures[i / 3 * 3], &two = pictures[i];
        EXPECT_EQ(two.alpha, one.alpha) << frames[i].name;
        EXPECT_NEAR(meanOf(two.red), meanOf(one.red), 1e-3 * meanOf(one.red)) << frames[i].name;
        // Instances are rounded otherwise, so some paths go elsewhere.
        for (std::size_t k = 0; i % 3 < 2 && k < one.red.size(); ++k)
            ASSERT_NEAR(two.red[k], one.red[k], 1e-5) << frames[i].name << " at " << k;
    }
}

TEST(LevelOfDetail, OfLampsInTransitionIsWorthOneLamp) {
    const std::string lamp = "AttributeBegin\nAreaLightSource \"arealight\" 1 \"color lightcolor\" "
                             "[3 3 3]\nTranslate 0 0 -1\n";
    const std::string floor = "Illuminate 1 1\nSurface \"matte\"\nPolygon \"P\" [-2 -2 1 2 -2 1 2 "
                              "2 1 -2 2 1]\n";
    const auto two = [&](const std::string &body) {
        return lamp + detail + "DetailRange [0 0 180 400]\n" + body +
               "DetailRange [180 400 1e38 1e38]\n" + body + "AttributeEnd\n" + floor;
    };
    for (const char *integrator : {"classic", "path"})
        for (const std::string &body : {square, std::string("Sphere .5 -.5 .5 360\n")}) {
            const auto pictures =
                render({{"one", view(integrator), lamp + body + "AttributeEnd\n" + floor},
                        {"two", view(integrator), two(body)}},
                       {64, 1, ""});
            ASSERT_EQ(pictures.size(), 2u);
            EXPECT_NEAR(meanOf(pictures[1].red) / meanOf(pictures[0].red), 1, .01) << integrator;
        }
}

TEST(LevelOfDetail, IsToldOfWhereItIsWrong) {
    const Outcome bad =
        run("Detail [1 0 0 1 0 1]\nDetailRange [3 2 4 5]\nDetailRange [0 1 2 1]\n" + square);
    EXPECT_EQ(bad.status, 1);
    EXPECT_TRUE(bad.says("Detail: expected minima below maxima")) << bad.text();
    EXPECT_TRUE(bad.says("DetailRange: expected four areas")) << bad.text();
    const std::string both =
        "Surface \"constant\"\n" + detail + "DetailRange [10 1e4 1e38 1e38]\n" + square;
    EXPECT_TRUE(run(both, "bidir").says("all paths begin at the camera"));
    EXPECT_TRUE(run(both, "radiosity").says("rendered as under \"path\""));
}

} // namespace
} // namespace candela::test
