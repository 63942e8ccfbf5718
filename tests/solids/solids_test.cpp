// SPDX-License-Identifier: Apache-2.0
// Solids: how much of them is where, what is seen of them, which way they look, in every space.
#include "tests/solids/solids.h"
#include "tests/support/frames.h"
#include "tests/support/program.h"
#include "tests/support/scratch_folder.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numeric>

namespace candela::test {
namespace {

/// Where a solid stands so that the look along z sees the same of it, mirrored or turned.
struct Space {
    const char *name, *before, *place;
    double size = 1;
    const char *behind = ""; ///< What brings a wall behind it.
};
const Space spaces[] = {
    {"plain", "", "%s"},
    {"mirrored", "", "Scale -1 1 1\n%s"},
    {"mirrored before the world", "Scale 1 1 -1\nTranslate 0 0 -10\n", "%s", 1, "Scale 1 1 -1\n"},
    {"turned", "", "Rotate 90 0 0 1\n%s"},
    {"far from the origin of its world", "Translate -1000 300 50\n", "Translate 1000 -300 -50\n%s",
     1, "Translate 1000 -300 -50\n"},
    {"an object", "", "ObjectBegin 1\n%sObjectEnd\nObjectInstance 1\n"},
    {"one of two instances", "",
     "ObjectBegin 1\n%sObjectEnd\nObjectInstance 1\nTranslate 9 0 0\nObjectInstance 1\n"},
    {"instances, mirrored", "",
     "ObjectBegin 1\n%sObjectEnd\nScale 1 -1 1\nObjectInstance 1\nTranslate 9 0 0\n"
     "ObjectInstance 1\n"},
    {"an object of many looks", "",
     "ObjectBegin 1\nColor 1 0 0\n%sObjectEnd\nObjectInstance 1\nTranslate 9 0 0\n"
     "ObjectInstance 1\n"},
    {"tiny", "Translate 0 0 -4.9995\n", "Scale 1e-4 1e-4 1e-4\n%s", 1e-4},
    {"huge", "Translate 0 0 1e6\n", "Scale 1e4 1e4 1e4\n%s", 1e4},
};

std::string placed(const Space &space, const std::string &rib) {
    std::string text = space.place;
    return text.replace(text.find("%s"), 2, rib);
}

std::string optionsIn(const Space &space, const std::string &integrator) {
    const std::string half = std::to_string(1.6 * space.size);
    return "Option \"render\" \"string integrator\" [\"" + integrator +
           "\"]\nFormat 64 64 1\nProjection \"orthographic\"\nScreenWindow -" + half + " " + half +
           " -" + half + " " + half + "\nTranslate 0 0 5\n" + space.before;
}

/// White, behind everything.
std::string wall(const Space &space) {
    const std::string half = std::to_string(3 * space.size), z = std::to_string(3 * space.size);
    return std::string("AttributeBegin\n") + space.behind +
           "Surface \"constant\"\nPolygon \"P\" [-" + half + " -" + half + " " + z + " " + half +
           " -" + half + " " + z + " " + half + " " + half + " " + z + " -" + half + " " + half +
           " " + z + "]\nAttributeEnd\n";
}

double meanOf(const std::vector<float> &values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
}

class Solids : public testing::TestWithParam<SolidCase> {};
[[maybe_unused]] void PrintTo(const SolidCase &solid, std::ostream *stream) {
    *stream << solid.name;
}

TEST_P(Solids, HoldWhatTheyShouldInEverySpace) {
    const SolidCase &solid = GetParam();
    const Seen seen = lookThrough(solid.inside);
    std::vector<Frame> frames;
    std::vector<std::string> names;
    for (const char *integrator : {"classic", "path"})
        for (const Space &space : spaces) {
            const std::string substance = "Surface \"constant\"\nOpacity [0 0 0]\nInterior "
                                          "\"absorption\" \"color transmittance\" [.5 .5 .5] "
                                          "\"float distance\" [" +
                                          std::to_string(space.size) + "]\n";
            frames.push_back({space.name, optionsIn(space, integrator),
                              wall(space) + solid.before + substance + placed(space, solid.rib)});
        }
    const auto pictures = render(frames, {4, 1, ""});
    ASSERT_EQ(pictures.size(), frames.size());
    for (std::size_t i = 0; i < frames.size(); ++i) {
        SCOPED_TRACE(frames[i].name);
        EXPECT_NEAR(meanOf(pictures[i].red), seen.halvedOften, .002);
    }
}

TEST_P(Solids, ShowTheirOutsideAlone) {
    const SolidCase &solid = GetParam();
    const Seen seen = lookThrough(solid.inside, 320);
    std::vector<Frame> frames;
    for (const char *integrator : {"classic", "path"})
        for (const char *sides : {"Sides 2\n", "Sides 1\n"})
            for (const Space &space : spaces)
                frames.push_back({space.name, optionsIn(space, integrator),
                                  solid.before + "Surface \"outward\"\n" + std::string(sides) +
                                      placed(space, solid.rib)});
    const auto pictures = render(frames, {4, 1, "solids/shaders"});
    ASSERT_EQ(pictures.size(), frames.size());
    for (std::size_t i = 0; i < frames.size(); ++i) {
        SCOPED_TRACE(frames[i].name);
        const double covered = meanOf(pictures[i].alpha);
        EXPECT_NEAR(covered, seen.covered, .004);
        EXPECT_NEAR(meanOf(pictures[i].red), covered, 1e-3 * covered);
    }
}

std::string nameOf(const testing::TestParamInfo<SolidCase> &info) {
    std::string name = info.param.name;
    std::ranges::replace(name, ' ', '_');
    return name;
}
INSTANTIATE_TEST_SUITE_P(All, Solids, testing::ValuesIn(solidCases()), nameOf);

TEST(CutFaces, AreThoseOfWhatCuts) {
    // A bowl: within, the normal leads to the centre of the ball that has made it.
    const Space &space = spaces[0];
    const std::string bowl =
        combined("difference", box(-1.5, 1.5, -1.5, 1.5, -1, 1) + ball(0, 0, -1, 1.2));
    for (const char *integrator : {"classic", "path"}) {
        const auto pictures =
            render({{"bowl", optionsIn(space, integrator), "Surface \"outward\"\n" + bowl}},
                   {16, 1, "solids/shaders"});
        ASSERT_EQ(pictures.size(), 1u);
        for (int column : {20, 28, 32, 40}) { // A row above the middle.
            const double x = ((column + .5) / 64 * 2 - 1) * 1.6, y = .5 / 32 * 1.6;
            ASSERT_LT(std::hypot(x, y), 1.2);
            EXPECT_NEAR(pictures[0].green[31 * 64 + std::size_t(column)], .5 - .5 * x / 1.2, .004);
        }
    }
}

TEST(CoincidentFaces, AreOneFaceOrNone) {
    // Each line through it meets two faces, which let half through, wherever rounding puts them.
    const std::string halves = "Opacity [.5 .5 .5]\nSurface \"constant\"\n";
    const std::pair<const char *, std::string> solids[] = {
        {"blocks in a row",
         combined("union", box(-9, 9, -9, 9, -1, -.3) + box(-9, 9, -9, 9, -.3, .4) +
                               box(-9, 9, -9, 9, .4, 1))},
        {"twice the same",
         combined("intersection", box(-9, 9, -9, 9, -1, 1) + box(-9, 9, -9, 9, -1, 1))},
        {"cut down to its lower half",
         combined("difference", box(-9, 9, -9, 9, -1, 1) + box(-9, 9, -9, 9, -1, 0))},
        {"filled again", combined("union", combined("difference", box(-9, 9, -9, 9, -1, 1) +
                                                                      box(-9, 9, -9, 9, -.5, .5)) +
                                               box(-9, 9, -9, 9, -.5, .5))},
    };
    const char *places[] = {"", "Rotate 33 1 2 .3\n", "Rotate 160 .3 1 .2\nTranslate .123 .4 .77\n",
                            "Scale 1000 1000 1000\nRotate 20 1 .4 .1\n",
                            "Scale 1e-3 1e-3 1e-3\nRotate 40 1 .4 .1\n"};
    std::vector<Frame> frames;
    for (const char *integrator : {"classic", "path"})
        for (const auto &[name, rib] : solids)
            for (const char *place : places) {
                const double size = std::string(place).find("1000") != std::string::npos  ? 1000
                                    : std::string(place).find("e-3") != std::string::npos ? 1e-3
                                                                                          : 1;
                frames.push_back({std::string(name) + " " + place + integrator,
                                  std::string("Option \"render\" \"string integrator\" [\"") +
                                      integrator +
                                      "\"]\nFormat 64 64 1\nProjection "
                                      "\"perspective\" \"fov\" 12\nTranslate 0 0 " +
                                      std::to_string(14 * size) + "\n",
                                  halves + place + rib});
            }
    const auto pictures = render(frames, {4, 1, ""});
    ASSERT_EQ(pictures.size(), frames.size());
    for (std::size_t i = 0; i < frames.size(); ++i) {
        SCOPED_TRACE(frames[i].name);
        const auto [least, most] = std::ranges::minmax(pictures[i].alpha);
        EXPECT_EQ(least, .75f);
        EXPECT_EQ(most, .75f);
    }
}

TEST(MovingSolids, AreCutWhereTheirPartsAreThen) {
    const std::string sweeping = "AttributeBegin\nMotionBegin [0 1]\nTranslate -1 0 0\nTranslate 1 "
                                 "0 0\nMotionEnd\n" +
                                 ball(0, 0, -1, .7) + "AttributeEnd\n";
    const std::string solid = combined("difference", box(-1, 1, -1, 1, -1, 1) + sweeping);
    const Seen seen = lookThrough([](double x, double y, double z, double share) {
        const double at = 2 * share - 1;
        return std::max({std::abs(x), std::abs(y), std::abs(z)}) < 1 &&
               std::hypot(x - at, y, z + 1) > .7;
    });
    const Space plain = spaces[0], instanced = spaces[6];
    std::vector<Frame> frames;
    for (const Space &space : {plain, instanced})
        for (const char *integrator : {"classic", "path"})
            frames.push_back({std::string(space.name) + integrator,
                              "Shutter 0 1\n" + optionsIn(space, integrator),
                              wall(space) +
                                  "Surface \"constant\"\nOpacity [0 0 0]\nInterior \"absorption\" "
                                  "\"color transmittance\" [.5 .5 .5] \"float distance\" [1]\n" +
                                  placed(space, solid)});
    const auto pictures = render(frames, {16, 1, ""});
    ASSERT_EQ(pictures.size(), frames.size());
    for (std::size_t i = 0; i < frames.size(); ++i) {
        SCOPED_TRACE(frames[i].name);
        EXPECT_NEAR(meanOf(pictures[i].red), seen.halvedOften, .003);
    }
}

TEST(GlassSolids, AreInvisibleInAFurnace) {
    // All that arrives is as bright as what surrounds it, whichever way it took.
    const std::string furnace = "AttributeBegin\nSurface \"constant\"\nSphere 20 -20 20 "
                                "360\nAttributeEnd\n";
    for (const SolidCase &solid : solidCases()) {
        SCOPED_TRACE(solid.name);
        const auto pictures =
            render({{solid.name,
                     "Option \"render\" \"string integrator\" [\"path\"]\nFormat 32 32 1\n"
                     "Projection \"perspective\" \"fov\" 40\nTranslate 0 0 5\nRotate 25 1 .5 .2\n",
                     furnace + solid.before + "Surface \"glass\"\n" + solid.rib}},
                   {64, 1, ""});
        ASSERT_EQ(pictures.size(), 1u);
        EXPECT_NEAR(meanOf(pictures[0].red), 1, .01);
    }
}

/// A half ball, closed, by its own surfaces or cut from more.
const std::string halfBall =
    "SolidBegin \"primitive\"\nSphere 1 0 1 360\nReverseOrientation\nDisk 0 1 "
    "360\nSolidEnd\n";
const std::string cutBall =
    combined("intersection", ball(0, 0, 0, 1) + box(-1.1, 1.1, -1.1, 1.1, 0, 1.1));

TEST(SolidLamps, ShineAsTheirSurfacesDo) {
    // On a floor under the flat side and beside it; both ways to make it send the same.
    const std::string floor =
        "AttributeBegin\nSurface \"matte\"\nPolygon \"P\" [-3 -3 3 3 -3 3 3 3 "
        "3 -3 3 3]\nAttributeEnd\n";
    const auto world = [&](const std::string &lamp, const std::string &body, const char *place) {
        return "AttributeBegin\nTranslate 0 0 1\n" + std::string(place) + lamp + body +
               "AttributeEnd\n" + floor;
    };
    const char *lamps[] = {
        "AreaLightSource \"arealight\" 1 \"color lightcolor\" [2 2 2]\n",
        "AreaLightSource \"arealight\" 1 \"color lightcolor\" [2 2 2] \"float onesided\" [0]\n"};
    const char *places[] = {"Rotate 180 1 0 0\n", "Rotate 100 1 0 0\n", "Scale 1 1 -1\n", ""};
    for (const char *integrator : {"path", "bidir", "classic"}) {
        std::vector<Frame> frames;
        for (const char *lamp : lamps)
            for (const char *place : places)
                for (const std::string &body : {halfBall, cutBall})
                    frames.push_back({place,
                                      std::string("Option \"render\" \"string integrator\" [\"") +
                                          integrator +
                                          "\"]\nFormat 32 32 1\nProjection "
                                          "\"orthographic\"\nScreenWindow -3 3 -3 3\n"
                                          "Translate 0 0 5\n",
                                      world(lamp, body, place)});
        const auto pictures = render(frames, {64, 1, ""});
        ASSERT_EQ(pictures.size(), frames.size());
        for (std::size_t i = 0; i < frames.size(); i += 2) {
            SCOPED_TRACE(std::string(integrator) + ": " + frames[i].name);
            const double whole = meanOf(pictures[i].red), cut = meanOf(pictures[i + 1].red);
            EXPECT_NEAR(cut / whole, 1, .01);
        }
    }
}

TEST(SolidLamps, AreMeansOverWhatIsLeftInClassicUnits) {
    const std::string floor =
        "Illuminate 1 1\nSurface \"matte\"\nTranslate 0 0 3\nPolygon \"P\" [-3 "
        "-3 0 3 -3 0 3 3 0 -3 3 0]\n";
    std::vector<Frame> frames;
    for (const char *integrator : {"path", "classic"})
        for (const std::string &body : {halfBall, cutBall})
            frames.push_back({integrator,
                              std::string("Option \"radiometry\" \"string units\" [\"classic\"]\n"
                                          "Option \"render\" \"string integrator\" [\"") +
                                  integrator +
                                  "\"]\nFormat 32 32 1\nProjection "
                                  "\"orthographic\"\nScreenWindow -3 3 -3 3\nTranslate 0 0 5\n",
                              "AttributeBegin\nAreaLightSource \"classic_lamp\" 1\nSurface "
                              "\"matte\" \"Kd\" [0]\nRotate 120 1 0 0\n" +
                                  body + "AttributeEnd\n" + floor});
    const auto pictures = render(frames, {1024, 1, "light/shaders"});
    ASSERT_EQ(pictures.size(), frames.size());
    for (std::size_t i = 0; i < frames.size(); i += 2) {
        SCOPED_TRACE(frames[i].name);
        EXPECT_GT(meanOf(pictures[i].red), .01);
        EXPECT_NEAR(meanOf(pictures[i + 1].red) / meanOf(pictures[i].red), 1, .01);
    }
}

Outcome run(const std::string &world) {
    ScratchFolder folder;
    const std::string rib = folder.write(
        "scene.rib", "Format 32 32 1\nDisplay \"a.exr\" \"openexr\" \"rgba\"\nProjection "
                     "\"orthographic\"\nScreenWindow -2 2 -2 2\nTranslate 0 0 5\nWorldBegin\n" +
                         world + "WorldEnd\n");
    return runCandela({rib, "--quiet", "--spp", "4", "--output-dir", folder.path()});
}

TEST(BadSolids, AreToldOfAndDrawn) {
    const Outcome open =
        run(combined("difference", ball(0, 0, 0, 1) + "SolidBegin \"primitive\"\nDisk 0 .5 "
                                                      "360\nSolidEnd\n"));
    EXPECT_EQ(open.status, 0);
    EXPECT_TRUE(open.says("not closed")) << open.text();
    const Outcome unknown = run(combined("exclusion", ball(0, 0, 0, 1) + ball(1, 0, 0, 1)));
    EXPECT_TRUE(unknown.says("'exclusion' is unknown")) << unknown.text();
    const Outcome unfinished = run("SolidBegin \"union\"\n" + ball(0, 0, 0, 1));
    EXPECT_EQ(unfinished.signal, 0);
    const Outcome empty = run(combined("intersection", "") + combined("primitive", ""));
    EXPECT_EQ(empty.status, 0) << empty.text();
    const Outcome strokes = run(combined(
        "union", ball(0, 0, 0, 1) + "Curves \"linear\" [2] \"nonperiodic\" \"P\" [-2 0 0 2 0 0] "
                                    "\"constantwidth\" .2\n"));
    EXPECT_EQ(strokes.status, 0) << strokes.text();
}

TEST(ManyParts, CostWhatRaysMeetOfThem) {
    std::string parts;
    for (int k = 0; k < 1000; ++k)
        parts += ball(-1 + k % 10 * .2, -1 + k / 10 % 10 * .2, -1 + k / 100 * .2, .13);
    const Outcome all =
        run("Surface \"constant\"\n" + combined("difference", box(-1, 1, -1, 1, -1, 1) + parts));
    EXPECT_EQ(all.status, 0) << all.text();
}

} // namespace
} // namespace candela::test
