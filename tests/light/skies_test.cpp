// SPDX-License-Identifier: Apache-2.0
// Skies made by light shaders, solar() over cones, are seen in mirrors and through glass, found by
// directions that surfaces scatter, and weighed against light samples there.
#include "foundation/base/student.h"
#include "tests/light/pictures.h"

#include <cmath>
#include <gtest/gtest.h>
#include <ostream>

namespace candela::test {
namespace {

const std::string si = "Option \"radiometry\" \"string units\" [\"si\"]\n";
struct Integrator {
    const char *name;
    bool followsAll; ///< Directions of finite lobes, too.
};
constexpr Integrator integrators[] = {
    {"path", true}, {"classic", false}, {"bidir", true}, {"vcm", true}};

std::string options(const std::string &integrator) {
    return si + "Option \"render\" \"string integrator\" [\"" + integrator + "\"]\n";
}

std::string sky(const std::string &more = "") {
    return "LightSource \"even_sky\" 1 " + more + "\n";
}

void PrintTo(const Integrator &integrator, std::ostream *stream) { *stream << integrator.name; }

/// What stands before the eye, at z = 3, looks back along -z. Its sky's light travels along +z.
struct Case {
    const char *name;
    std::string world;
    double value;
    bool classic = true;     ///< It means the same under `classic`.
    double tolerance = 2e-5; ///< Beside the noise.
    double mostNoise = 2e-5; ///< Standard error that is borne.
};

void PrintTo(const Case &what, std::ostream *stream) { *stream << what.name; }

const std::string mirror = "Surface \"mirror\"\n" + squareAt(3);
/// A mirror that looks along (-.6, 0, -.8): in it the eye sees along (-.96, 0, -.28).
const std::string tilted = "Surface \"mirror\"\nPolygon \"P\" [-.8 -1 3.6 -.8 1 3.6 .8 1 2.4 "
                           ".8 -1 2.4]\n";
const std::string pane = "AttributeBegin\nSurface \"glass\"\n" + squareAt(3, 2) +
                         "ReverseOrientation\n" + squareAt(3.1, 2) + "AttributeEnd\n";
const std::string matte = "Surface \"matte\" \"Ka\" [0]\nColor [1 1 1]\n" + squareAt(3);
std::string rough(const std::string &alpha) {
    return "Surface \"roughmetal\" \"alpha\" [" + alpha + "]\nColor [1 1 1]\n" + squareAt(3);
}

const Case cases[] = {
    {"Mirror", sky() + mirror, 1},
    {"MirrorOfEverywhere", sky("\"angle\" [360]") + mirror, 1},
    {"MirrorUnderNarrowCone", sky("\"angle\" [3] \"radiance\" [7]") + mirror, 7, true, 3e-4},
    {"MirrorBesideNarrowCone", sky("\"angle\" [3] \"axis\" [.1 0 1]") + mirror, 0},
    {"MirrorThatLooksAside", sky("\"axis\" [-1 0 0]") + tilted, 0},
    {"MirrorThatSeesCosine",
     sky("\"cosine\" [1]") + "LightSource \"even_sky\" 2 \"radiance\" [.5]\n" + tilted, .78},
    {"MirrorThatSeesCosineAside", sky("\"cosine\" [1] \"axis\" [1 0 0]") + tilted, .96},
    {"MirrorOfCosine", sky("\"cosine\" [1] \"axis\" [.6 0 .8]") + mirror, .8},
    {"MirrorOfMirror", sky("\"angle\" [360]") + mirror + "Rotate 30 1 0 0\n" + mirror, 1},
    {"MirrorInMirroredSpace", "Scale -1 1 1\n" + sky("\"cosine\" [1] \"axis\" [.6 0 .8]") + mirror,
     .8},
    {"MirrorInScaledSpace",
     "Scale 1e-4 1e-4 1e-4\n" + sky() + "Surface \"mirror\"\n" + squareAt(3e4, 1e4), 1},
    {"MirrorInInstance",
     "ObjectBegin 1\n" + mirror + "ObjectEnd\n" + sky() + "Translate 0 0 1\nObjectInstance 1\n", 1},
    {"OneSidedMirror", sky() + "Sides 1\nSurface \"mirror\"\n" + squareAt(3), 1},
    {"MirrorFarFromOrigin", "Translate 0 0 1e5\n" + sky() + mirror, 1},
    {"TwoSkiesInMirror", sky() + "LightSource \"even_sky\" 2 \"radiance\" [.5]\n" + mirror, 1.5},
    {"MirrorWhereTheSkyIsOff", sky() + matte + "Illuminate 1 0\nTranslate 0 0 -1\n" + mirror, 0},
    {"NothingButTheSky", sky("\"angle\" [360]"), 0},
    {"SkyBehindWhatIsHalfOpaque",
     sky("\"angle\" [360]") + "Opacity .5 .5 .5\nColor [0 0 0]\n" + "Surface \"constant\"\n" +
         squareAt(3),
     0},
    {"Pane", sky("\"angle\" [360]") + pane, 1, true, 1e-3, 2e-2},
    {"DiscOfItsOwn", "LightSource \"sky_and_disc\" 1 \"to\" [0 0 1]\n" + mirror, 50},
    {"BesideDiscOfItsOwn", "LightSource \"sky_and_disc\" 1\n" + mirror, 1},
    {"DiscWithoutImportance",
     "LightSource \"sky_and_disc\" 1 \"importance\" [0] \"to\" [0 0 1]\n" + mirror, 50},
    {"SkyAndSunOfOneDirection",
     "LightSource \"sky_and_disc\" 1 \"disc\" [1] \"sunImportance\" [1]\n" + mirror, 1},
    // Reflected by finite lobes: light samples and directions share.
    {"Matte", sky() + matte, 1, true, 2e-3, 4e-3},
    {"MatteUnderCosine", sky("\"cosine\" [1]") + matte, 2. / 3, true, 2e-3, 4e-3},
    {"MatteUnderDisc",
     "LightSource \"sky_and_disc\" 1 \"disc\" [1] \"sunImportance\" [1]\n" + matte, 3, true, 2e-3,
     2e-2},
    {"MatteInMatteOfTwoSkies",
     sky() + "LightSource \"even_sky\" 2 \"radiance\" [.5] \"angle\" [60]\n" + matte, 1.125, true,
     2e-3, 1e-2},
    {"FinelyRoughMetal", sky() + rough(".01"), 1, false, 3e-3, 3e-3},
    {"RoughMetal", sky() + rough(".1"), .995, false, 6e-3, 6e-3},
    {"PlasticOfAllDirections",
     sky("\"angle\" [360]") + "Surface \"mirror\" \"Kr\" [.25]\n" + squareAt(3), .25},
};

class Skies : public testing::TestWithParam<std::tuple<Case, Integrator>> {};

TEST_P(Skies, AreSeenAsTheyShine) {
    const auto &[what, integrator] = GetParam();
    if (!integrator.followsAll && !what.classic)
        GTEST_SKIP() << "\"classic\" has all light by samples";
    const SmallPicture seen = takePicture(options(integrator.name), what.world, 64);
    const MeanAndError mean = meanAndError({seen.red.begin(), seen.red.end()});
    // Small frames have few samples beside the light paths of vcm's rounds.
    const double more = integrator.name == std::string("vcm") ? 2 : 1;
    EXPECT_LE(mean.standardError, more * what.mostNoise);
    EXPECT_NEAR(mean.mean, what.value,
                what.tolerance + studentQuantile(1e-6, 63) * mean.standardError);
}

std::string nameOf(const testing::TestParamInfo<std::tuple<Case, Integrator>> &info) {
    const auto &[what, integrator] = info.param;
    return std::string(what.name) + "_" + integrator.name;
}

INSTANTIATE_TEST_SUITE_P(All, Skies,
                         testing::Combine(testing::ValuesIn(cases), testing::ValuesIn(integrators)),
                         nameOf);

} // namespace
} // namespace candela::test
