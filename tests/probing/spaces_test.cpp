// SPDX-License-Identifier: Apache-2.0
// The same room everywhere: mirrored, stretched, far off, tiny, in an object; and who hears whom.
#include "tests/probing/probing.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace candela::test {

namespace {

constexpr double pi = std::numbers::pi;

/// A disc of radius 1 at height 1 over the origin; at (1, 0, 0) it makes .8683149.
const std::string disc = "AttributeBegin\nTranslate 0 0 1\nRotate 180 1 0 0\nDisk 0 1 360\n"
                         "AttributeEnd\n";
/// A black floor, so that sensors lie on something.
const std::string floor = "Surface \"matte\" \"Kd\" [0] \"Ka\" [0]\n"
                          "Polygon \"P\" [-5 -5 0  5 -5 0  5 5 0  -5 5 0]\n";

struct Space {
    std::string name;
    std::string camera; ///< Before WorldBegin.
    std::string place;  ///< Before the room.
    std::string origin; ///< The sensor at the origin and
    std::string beside; ///< at (1, 0, 0) of the room, in world space.
};

void PrintTo(const Space &space, std::ostream *out) { *out << space.name; }

class InSpace : public testing::TestWithParam<Space> {};

} // namespace

TEST_P(InSpace, TheRoomIsTheSame) {
    const Space &space = GetParam();
    const std::string room = space.place + lamp(disc) + floor;
    const Probed probed =
        probe(siWorld(room, space.camera), space.origin + "\n" + space.beside, {"--spp", "65536"});
    ASSERT_EQ(probed.answers.size(), 2u) << probed.run.text();
    EXPECT_NEAR(probed.answers[0].total, pi / 2, 2e-3);
    EXPECT_NEAR(probed.answers[1].total, .8683149, 1.5e-3);
}

INSTANTIATE_TEST_SUITE_P(
    Probe, InSpace,
    testing::Values(
        Space{"atTheEye", "", "", "0 0 0 0 0 1", "1 0 0 0 0 1"},
        Space{"seenFromTheSide", "Rotate 77 1 2 3\nTranslate 4 5 6\n", "", "0 0 0 0 0 1",
              "1 0 0 0 0 1"},
        Space{"mirroredCamera", "Translate 1 2 9\nScale -1 1 1\nRotate 30 1 1 0\n", "",
              "0 0 0 0 0 1", "1 0 0 0 0 1"},
        Space{"mirroredWorld", "Translate 1 2 9\n", "Scale 1 1 -1\n", "0 0 0 0 0 -1",
              "1 0 0 0 0 -1"},
        Space{"centimetres", "Translate 0 0 3\nScale .01 .01 .01\n", "Scale 100 100 100\n",
              "0 0 0 0 0 1", "100 0 0 0 0 1"},
        Space{"stretchedCamera", "Translate 0 0 3\nScale 1 .5 2\n", "Scale 1 2 .5\n", "0 0 0 0 0 1",
              "1 0 0 0 0 1"},
        Space{"tiny", "Translate 0 0 .003\n", "Scale .001 .001 .001\n", "0 0 0 0 0 1",
              ".001 0 0 0 0 1"},
        Space{"huge", "Translate 0 0 1000\n", "Scale 1e5 1e5 1e5\n", "0 0 0 0 0 1",
              "1e5 0 0 0 0 1"},
        Space{"farOff", "Translate 0 0 7\nRotate 33 1 2 3\nTranslate -1e5 -2e5 3e5\n",
              "Translate 1e5 2e5 -3e5\n", "1e5 2e5 -3e5 0 0 1", "100001 2e5 -3e5 0 0 1"},
        Space{"turned", "Translate 0 0 5\n", "Rotate 90 0 1 0\n", "0 0 0 1 0 0", "0 0 -1 1 0 0"}),
    [](const auto &info) { return info.param.name; });

TEST(Instances, HideLikeAnythingElse) {
    const std::string screen = "ObjectBegin 1\nPolygon \"P\" [0 -40 .5  -40 -40 .5  -40 40 .5  "
                               "0 40 .5]\nObjectEnd\nSurface \"matte\" \"Kd\" [0]\n"
                               "ObjectInstance 1\n";
    const Probed probed = probe(siWorld(screen + lamp(disc)), "0 0 0 0 0 1\n", {"--spp", "65536"});
    ASSERT_EQ(probed.answers.size(), 1u) << probed.run.text();
    EXPECT_NEAR(probed.answers[0].total, pi / 4, 2e-3);
}

TEST(Sides, OneSidedLampsShineToTheirs) {
    for (bool oneSided : {true, false}) {
        const Probed probed = probe(siWorld(lamp(disc, 1, oneSided)), "0 0 0 0 0 1\n0 0 2 0 0 -1\n",
                                    {"--spp", "65536"});
        ASSERT_EQ(probed.answers.size(), 2u) << probed.run.text();
        EXPECT_NEAR(probed.answers[0].total, pi / 2, 2e-3);
        EXPECT_NEAR(probed.answers[1].total, oneSided ? 0 : pi / 2, 2e-3);
    }
}

/// A sensor hears every light that is on for some surface.
TEST(Linking, SensorsHearWhatIsOnForAnySurface) {
    const std::string lights = "LightSource \"distantlight\" 1 \"from\" [0 0 1] \"to\" [0 0 0]\n"
                               "LightSource \"distantlight\" 2 \"from\" [0 0 1] \"to\" [0 0 0] "
                               "\"intensity\" [10]\n";
    const std::string surface = "Surface \"matte\" \"Kd\" [0]\n"
                                "Polygon \"P\" [0 0 -9  1 0 -9  1 1 -9]\n";
    const auto heard = [&](const std::string &world) {
        const Probed probed = probe(siWorld(lights + world), "0 0 0 0 0 1\n");
        EXPECT_EQ(probed.answers.size(), 1u) << probed.run.text();
        return probed.answers.empty() ? -1 : std::round(1e4 * probed.answers[0].total) / 1e4;
    };
    EXPECT_EQ(heard(""), 11);
    EXPECT_EQ(heard(surface), 11);
    EXPECT_EQ(heard("Illuminate 2 0\n" + surface), 1);
    EXPECT_EQ(heard("Illuminate 2 0\n" + surface + "Illuminate 2 1\nIlluminate 1 0\n" + surface),
              11);
}

/// Where some surface lets shadow rays pass alone, lamps are left to samples, and to these whole.
TEST(Linking, LampsAreWholeWhereSomethingCastsNoShadow) {
    const std::string ghost = "Attribute \"render\" \"string casts_shadows\" \"none\"\n"
                              "Polygon \"P\" [-9 -9 .5  9 -9 .5  9 9 .5  -9 9 .5]\n";
    const Probed probed = probe(siWorld(lamp(disc) + "Surface \"matte\" \"Kd\" [0]\n" + ghost),
                                "0 0 0 0 0 1\n", {"--spp", "65536"});
    ASSERT_EQ(probed.answers.size(), 1u) << probed.run.text();
    EXPECT_NEAR(probed.answers[0].total, pi / 2, 2e-3);
}

} // namespace candela::test
