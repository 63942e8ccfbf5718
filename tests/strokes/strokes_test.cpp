// SPDX-License-Identifier: Apache-2.0
// Points and curves: how much they cover, how they are shaded, what light they send and stop, in
// every space.
#include "tests/support/frames.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <numeric>

namespace candela::test {
namespace {

constexpr double pi = std::numbers::pi;

/// What is drawn, and its area as seen along z, of x and y scaled by 1.
struct Stroke {
    const char *name, *rib;
    double area;
};
const Stroke strokes[] = {
    {"a line",
     "Curves \"linear\" [2] \"nonperiodic\" \"P\" [-.75 0 0 .75 0 0] \"constantwidth\" .25", .375},
    {"lines with a corner",
     "Curves \"linear\" [3] \"nonperiodic\" \"P\" [-.5 -.5 0 .5 -.5 0 .5 .5 0] "
     "\"constantwidth\" .2",
     .4},
    {"a slender line",
     "Curves \"linear\" [2] \"nonperiodic\" \"P\" [-.75 .003 0 .75 .003 0] \"constantwidth\" .001",
     .0015},
    {"cubics that taper",
     "Curves \"cubic\" [7] \"nonperiodic\" \"P\" [-.75 0 0 -.5 0 0 -.25 0 0 0 0 0 .25 0 0 .5 0 0 "
     ".75 0 0] \"width\" [.5 .25 0]",
     .375},
    {"a spline",
     "Basis \"b-spline\" 1 \"b-spline\" 1 Curves \"cubic\" [6] \"nonperiodic\" \"P\" [-1.25 0 0 "
     "-.75 0 0 -.25 0 0 .25 0 0 .75 0 0 1.25 0 0] \"constantwidth\" .25",
     .375},
    {"a ribbon",
     "Curves \"linear\" [2] \"nonperiodic\" \"P\" [-.75 0 0 .75 0 0] \"constantwidth\" .25 "
     "\"uniform normal N\" [0 .6 -.8]",
     .375 * .8},
    {"points", "Points \"P\" [-.5 0 0 .5 0 0 0 .5 0] \"width\" [.4 .6 .2]", pi *(.04 + .09 + .01)},
    {"one point", "Points \"P\" [0 0 0] \"constantwidth\" [.8]", pi * .16},
};

/// Where it stands: the area that is seen grows by `grown`.
struct Space {
    const char *name, *before, *place;
    double grown = 1;
    const char *window = "-1 1 -1 1";
};
const Space spaces[] = {
    {"plain", "", "%s"},
    {"mirrored", "", "Scale -1 1 1 %s"},
    {"mirrored before the world", "Scale 1 1 -1 Translate 0 0 -10", "%s"},
    {"turned", "", "Rotate 90 0 0 1 %s"},
    {"inside out", "", "ReverseOrientation %s"},
    {"one-sided", "", "Sides 1 %s"},
    {"wide", "", "Scale 1 .5 2 %s", .5},
    {"skewed", "", "ConcatTransform [1 0 0 0 .5 1 0 0 0 0 1 0 0 0 0 1] %s"},
    {"an object", "", "ObjectBegin 1 %s ObjectEnd ObjectInstance 1"},
    {"one of two instances", "",
     "ObjectBegin 1 %s ObjectEnd ObjectInstance 1 Translate 9 0 0 ObjectInstance 1"},
    {"instances, mirrored and wide", "",
     "ObjectBegin 1 %s ObjectEnd Scale -1 .5 1 ObjectInstance 1 Translate 9 0 0 ObjectInstance 1",
     .5},
    {"tiny", "Translate 0 0 -4.9995", "Scale 1e-4 1e-4 1e-4 %s", 1, "-1e-4 1e-4 -1e-4 1e-4"},
    {"huge", "Translate 0 0 1e6", "Scale 1e4 1e4 1e4 %s", 1, "-1e4 1e4 -1e4 1e4"},
    {"far from the origin of its world", "Translate -1000 300 50", "Translate 1000 -300 -50 %s"},
};

std::string placed(const Space &space, const std::string &rib) {
    std::string text = space.place;
    return text.replace(text.find("%s"), 2, rib);
}

std::string optionsIn(const Space &space, const char *integrator) {
    return std::string("Option \"render\" \"string integrator\" [\"") + integrator +
           "\"]\nFormat 64 64 1\nProjection \"orthographic\"\nScreenWindow " + space.window +
           "\nTranslate 0 0 5\n" + space.before + "\n";
}

double meanOf(const std::vector<float> &values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
}

class Strokes : public testing::TestWithParam<Stroke> {};
void PrintTo(const Stroke &stroke, std::ostream *stream) { *stream << stroke.name; }

TEST_P(Strokes, CoverWhatTheyShouldInEverySpace) {
    const Stroke &stroke = GetParam();
    // Pixels are thirty times as wide, and where lines overlap opacities multiply.
    const bool isSlender = stroke.area < .01,
               overlaps = std::string(stroke.name) == "lines with a corner";
    for (const char *integrator : {"classic", "path"})
        for (const char *opacity : {"1", ".4"}) {
            if (overlaps && opacity[0] != '1')
                continue;
            std::vector<Frame> frames;
            for (const Space &space : spaces)
                frames.push_back({space.name, optionsIn(space, integrator),
                                  std::string("Surface \"constant\" Opacity [") + opacity + " " +
                                      opacity + " " + opacity + "]\n" + placed(space, stroke.rib) +
                                      "\n"});
            const auto pictures = render(frames, {isSlender ? 64 : 16, 1, ""});
            ASSERT_EQ(pictures.size(), frames.size());
            for (std::size_t i = 0; i < frames.size(); ++i) {
                SCOPED_TRACE(std::string(spaces[i].name) + ", " + integrator + ", " + opacity);
                const double wanted = std::stod(opacity) * stroke.area * spaces[i].grown / 4;
                EXPECT_NEAR(meanOf(pictures[i].alpha) / wanted, 1, isSlender ? .08 : .01);
            }
        }
}

TEST_P(Strokes, SendTheLightOfTheirArea) {
    // As lamps they are as bright as they are to the eye, whatever form sampling gives them.
    const Stroke &stroke = GetParam();
    std::vector<Frame> frames;
    for (const Space &space : spaces)
        frames.push_back({space.name, optionsIn(space, "path"),
                          "Surface \"matte\" \"float Kd\" 0 \"float Ka\" 0 AreaLightSource "
                          "\"arealight\" 1 \"color lightcolor\" [2 2 2] "
                          "\"float onesided\" 0\n" +
                              placed(space, stroke.rib) + "\n"});
    const auto pictures = render(frames, {16, 1, ""});
    ASSERT_EQ(pictures.size(), frames.size());
    for (std::size_t i = 0; i < frames.size(); ++i) {
        SCOPED_TRACE(spaces[i].name);
        const double alpha = meanOf(pictures[i].alpha);
        EXPECT_NEAR(meanOf(pictures[i].red), 2 * alpha, 1e-3 * alpha);
        if (stroke.area > .01) {
            EXPECT_NEAR(alpha / (stroke.area * spaces[i].grown / 4), 1, .01);
        }
    }
}

std::string nameOf(const testing::TestParamInfo<Stroke> &info) {
    std::string name = info.param.name;
    std::ranges::replace(name, ' ', '_');
    return name;
}
INSTANTIATE_TEST_SUITE_P(All, Strokes, testing::ValuesIn(strokes), nameOf);

TEST(StrokeNormals, PointOutwardsInEverySpace) {
    const char *ball = "Points \"P\" [0 0 0 9 9 9] \"constantwidth\" [1]";
    const char *tube =
        "Curves \"cubic\" [4] \"nonperiodic\" \"P\" [-.75 0 0 -.25 0 0 .25 0 0 .75 0 0] "
        "\"constantwidth\" 1";
    for (const char *integrator : {"classic", "path"})
        for (bool isTube : {false, true})
            for (const char *which : {"0", "1"}) {
                std::vector<Frame> frames;
                for (const Space &space : spaces)
                    frames.push_back({space.name, optionsIn(space, integrator),
                                      placed(space, std::string("Surface \"outward\" \"float "
                                                                "radius\" .5 \"float axis\" ") +
                                                        (isTube ? "1" : "0") + " \"float which\" " +
                                                        which + "\n" + (isTube ? tube : ball)) +
                                          "\n"});
                // Objects take their shaders from their instances.
                std::erase_if(frames, [](const Frame &frame) {
                    return frame.world.find("Object") != std::string::npos;
                });
                const auto pictures = render(frames, {1, 1, "strokes/shaders"});
                ASSERT_EQ(pictures.size(), frames.size());
                for (std::size_t i = 0; i < frames.size(); ++i) {
                    SCOPED_TRACE(frames[i].name + ", " + integrator + (isTube ? ", tube" : ""));
                    const FramePixels &picture = pictures[i];
                    const bool isTurned = frames[i].name == "inside out";
                    float place = 0, normal = 0;
                    for (std::size_t k = 0; k < picture.alpha.size(); ++k) {
                        if (picture.alpha[k] < 1)
                            continue;
                        place = std::max(place, picture.red[k]);
                        normal = std::max(normal, std::abs(picture.green[k] - (isTurned ? 2 : 0)));
                    }
                    EXPECT_LT(place, 2e-3f);
                    EXPECT_LT(normal, 5e-3f);
                }
            }
}

/// A floor under a lamp, which a quadric is and the stroke of its form.
TEST(StrokeLamps, LightAsQuadricsDo) {
    const std::pair<const char *, const char *> pairs[] = {
        {"TransformBegin Translate -.5 1 0 Sphere .2 -.2 .2 360 TransformEnd Translate .5 1 0 "
         "Sphere .3 -.3 .3 360",
         "Points \"P\" [-.5 1 0 .5 1 0] \"width\" [.4 .6]"},
        {"Translate -.75 1 0 Rotate 90 0 1 0 Cylinder .1 0 1.5 360",
         "Curves \"linear\" [2] \"nonperiodic\" \"P\" [-.75 1 0 .75 1 0] \"constantwidth\" .2"},
    };
    const std::string options = "Option \"render\" \"string integrator\" [\"path\"]\n"
                                "Format 16 16 1\nProjection \"perspective\" \"fov\" 40\n"
                                "Translate 0 -1 5\nRotate -30 1 0 0\n";
    const std::string floor =
        "Surface \"matte\" \"float Kd\" 1 Polygon \"P\" [-2 0 -2 -2 0 2 2 0 2 "
        "2 0 -2]\n";
    for (const char *mirror : {"", "Scale -1 1 1 "}) {
        std::vector<Frame> frames;
        for (const auto &[quadric, stroke] : pairs)
            for (const char *lamp : {quadric, stroke})
                frames.push_back(
                    {lamp, options,
                     std::string("AttributeBegin Attribute \"visibility\" \"int camera\" 0\n"
                                 "Surface \"matte\" \"float Kd\" 0 \"float Ka\" 0\n"
                                 "AreaLightSource \"arealight\" 1 \"float radiance\" 5\n") +
                         mirror + lamp + "\nAttributeEnd Illuminate 1 1\n" + floor});
        const auto pictures = render(frames, {256, 1, "", true});
        ASSERT_EQ(pictures.size(), frames.size());
        for (std::size_t i = 0; i < frames.size(); i += 2) {
            SCOPED_TRACE(frames[i + 1].name);
            const RedComparison found = compareRed(pictures[i + 1], pictures[i]);
            EXPECT_GT(found.mean, .01);
            EXPECT_NEAR(found.difference.mean / found.mean, 0, .01);
        }
    }
}

/// What a see-through stroke lets pass it does once, wherever rays come from.
TEST(StrokeShadows, CountOpacityOnce) {
    const char *strokesAbove[] = {
        "Points \"P\" [0 1 0 5 5 5] \"constantwidth\" 1",
        "Curves \"linear\" [2] \"nonperiodic\" \"P\" [-3 1 0 3 1 0] \"constantwidth\" 1",
        "ObjectBegin 1 Points \"P\" [0 1 0 5 5 5] \"constantwidth\" 1 ObjectEnd ObjectInstance 1 "
        "Translate 9 0 0 ObjectInstance 1",
        "Scale 1 2 1 Curves \"linear\" [2] \"nonperiodic\" \"P\" [-3 1 0 3 1 0] "
        "\"constantwidth\" 1",
    };
    for (const char *integrator : {"classic", "path", "bidir"}) {
        std::vector<Frame> frames;
        for (const char *stroke : strokesAbove)
            frames.push_back(
                {stroke,
                 std::string("Option \"render\" \"string integrator\" [\"") + integrator +
                     "\"]\nOption \"trace\" \"integer maxdepth\" 1\nFormat 1 1 1\n"
                     "Projection \"orthographic\"\nScreenWindow -.02 .02 -.02 .02\n"
                     "Translate 0 0 5\nRotate -20 1 0 0\n",
                 std::string(
                     "Attribute \"light\" \"string shadows\" [\"on\"]\nLightSource "
                     "\"distantlight\" 1 \"from\" [0 1 0] \"to\" [0 0 0]\n"
                     "Surface \"matte\" \"float Ka\" 0 \"float Kd\" 1\nPolygon \"P\" [-2 0 -2 "
                     "-2 0 2 2 0 2 2 0 -2]\nSurface \"constant\" Color [0 0 0] Opacity [.4 .4 "
                     ".4]\n") +
                     stroke + "\n"});
        const auto pictures = render(frames, {64, 1, "", true});
        ASSERT_EQ(pictures.size(), frames.size());
        for (std::size_t i = 0; i < frames.size(); ++i)
            EXPECT_NEAR(pictures[i].red[0], .6 / pi, 2e-3) << integrator << " " << frames[i].name;
    }
}

} // namespace
} // namespace candela::test
