// SPDX-License-Identifier: Apache-2.0
// Irradiance and radiance against closed forms.
#include "tests/probing/probing.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace candela::test {

namespace {

constexpr double pi = std::numbers::pi;
const std::string up = " 0 0 1\n"; ///< A sensor at the place before it.

/// What a point is answered, and how far off that may be, as a part of it.
struct Row {
    std::string name;
    std::string world;
    std::string point; ///< x y z dx dy dz
    double expected;   ///< W m^-2
    double tolerance = 1e-3;
};

void PrintTo(const Row &row, std::ostream *out) { *out << row.name; }

std::string disc(const std::string &height, const std::string &radius) {
    return "Translate 0 0 " + height + "\nRotate 180 1 0 0\nDisk 0 " + radius + " 360\n";
}

std::string sphere(const std::string &place, const std::string &r) {
    return "Translate " + place + "\nSphere " + r + " -" + r + " " + r + " 360\n";
}

const std::string pointLight = "LightSource \"pointlight\" 1 \"from\" [0 0 2]\n";
const std::string square = "Polygon \"P\" [-.5 -.5 1  -.5 .5 1  .5 .5 1  .5 -.5 1]\n";
const std::string candle =
    "LightSource \"pointlight\" 1 \"from\" [0 0 1] \"intensity\" [0.00558659217877095]\n";
/// Half of what shines from above, x < 0, is hidden.
const std::string screen = "Polygon \"P\" [0 -40 .5  -40 -40 .5  -40 40 .5  0 40 .5]\n";

std::vector<Row> rows() {
    constexpr double exactly = 1e-5;
    const std::string wall = "Surface \"matte\" \"Ka\" [0] \"Kd\" [.5]\n" + sphere("0 0 0", "1");
    // A6: the indirect part is the same all over the wall of a sphere.
    const double indirect = .5 / (1 - .5) * 4 * pi / (4 * pi);
    // A lamp around the eye, which is at the origin where no camera is said, lights what is below.
    const std::string aroundEye = lamp(sphere("0 0 0", ".05")), below = "1 0 -1" + up;
    const double ofLamp = pi * .0025 / 2 / std::sqrt(2.0);
    const std::string floor = "Surface \"matte\" \"Ka\" [0] \"Kd\" [0]\n"
                              "Polygon \"P\" [-5 -5 -1  -5 5 -1  5 5 -1  5 -5 -1]\n";
    return {
        {"candela", candle, "0 0 0" + up, 1.0 / 179, exactly},
        {"point", pointLight, "0 0 0" + up, .25, exactly},
        {"pointBeside", pointLight, "2 0 0" + up, .0883883476, exactly},
        {"pointBehind", pointLight, "0 0 0 0 0 -1\n", 0},
        {"pointSlanted", pointLight, "0 0 0 1 0 1\n", .25 / std::sqrt(2.0), exactly},
        {"distant", "LightSource \"distantlight\" 1 \"from\" [0 3 4] \"to\" [0 0 0]\n",
         "5 6 7" + up, .8, exactly},
        {"spot", "LightSource \"spotlight\" 1 \"from\" [0 0 2] \"to\" [0 0 0]\n", "0 0 0" + up, .25,
         exactly},
        {"spotBeside", "LightSource \"spotlight\" 1 \"from\" [0 0 2] \"to\" [0 0 0]\n",
         "1.2 0 0" + up, 0},
        {"ambient", "LightSource \"ambientlight\" 1 \"intensity\" [2]\n", "0 0 0" + up, 2 * pi,
         exactly},
        {"discNear", lamp(disc(".5", "1")), "0 0 0" + up, 2.513274},
        {"discFar", lamp(disc("10", "1")), "0 0 0" + up, .03110488},
        {"discBeside", lamp(disc("1", "1")), "1 0 0" + up, .8683149},
        {"discFarBeside", lamp(disc("1", "1")), "2 0 0" + up, .1658334},
        {"square", lamp(square), "0 0 0" + up, .7522747},
        {"squareBeside", lamp(square), "1 0 0" + up, .2650049},
        {"sphere", lamp(sphere("0 0 2", ".5")), "0 0 0" + up, .1963495},
        {"sphereBeside", lamp(sphere("0 0 2", ".5")), "3 0 0" + up, .0335123},
        {"halfHidden", lamp(disc("1", "1")) + screen, "0 0 0" + up, pi / 4},
        {"dome", lamp("ReverseOrientation\n" + sphere("0 0 0", "100")), "0 0 0" + up, pi},
        {"domeOnWall",
         lamp("ReverseOrientation\n" + sphere("0 0 0", "100")) +
             "Surface \"constant\"\nColor [0 0 0]\n"
             "Polygon \"P\" [-1e5 -1e5 -1  1e5 -1e5 -1  1e5 1e5 -1  -1e5 1e5 -1]\n",
         "0 0 -.99999 1 0 0\n", pi / 2},
        {"lampAroundEye", aroundEye, below, ofLamp},
        {"lampAroundEyeOverFloor", aroundEye + floor, below, ofLamp},
        {"lampAroundEyeAndSun",
         "LightSource \"distantlight\" 2 \"from\" [0 0 1] \"to\" [0 0 0] \"intensity\" [.01]\n" +
             aroundEye,
         below, ofLamp + .01},
        {"sunBehindALampAlone",
         lamp(sphere("0 0 -5", ".05")) +
             "LightSource \"distantlight\" 2 \"from\" [0 0 1] \"to\" [0 0 0]\n",
         "0 0 0" + up, 1, exactly},
        {"lampAroundEyeWithin", aroundEye + lamp(sphere("0 0 0", ".02"), 100, false), below,
         ofLamp},
        {"lampAroundEyeBesideAnother", aroundEye + lamp(sphere("1 0 1", ".05")), below,
         ofLamp + pi * .0025 / 4},
        {"lampAroundEyeUnderSky",
         aroundEye + lamp("ReverseOrientation\n" + sphere("0 0 0", "100"), .001), below,
         ofLamp + .001 * (pi - pi * .0025 / 2 / std::sqrt(2.0))},
        {"furnace",
         "Surface \"matte\" \"Ka\" [0] \"Kd\" [.5]\n"
         "AreaLightSource \"arealight\" 1 \"radiance\" [1] \"onesided\" [0]\n" +
             sphere("0 0 0", "1"),
         ".3 .2 .1" + up, 2 * pi, 5e-3},
        {"sphereWallNear", "LightSource \"pointlight\" 1 \"from\" [.5 0 0]\n" + wall,
         "1 0 0 -1 0 0\n", 4 + indirect, 5e-3},
        {"sphereWallFar", "LightSource \"pointlight\" 1 \"from\" [.5 0 0]\n" + wall,
         "-1 0 0 1 0 0\n", 1 / 2.25 + indirect, 5e-3},
    };
}

class ClosedForm : public testing::TestWithParam<Row> {};

} // namespace

static void expectAnswer(const Row &row, const std::string &integrator) {
    SCOPED_TRACE(integrator);
    const Probed probed =
        probe(siWorld(row.world), row.point, {"--spp", "65536", "--integrator", integrator});
    ASSERT_EQ(probed.run.status, 0) << probed.run.text();
    ASSERT_EQ(probed.answers.size(), 1u) << probed.run.text();
    const Answer &a = probed.answers[0];
    EXPECT_NEAR(a.total, row.expected, row.tolerance * row.expected);
    EXPECT_NEAR(a.photometric, 179 * row.expected, 179 * row.tolerance * row.expected);
    EXPECT_EQ(a.R, a.G);
    EXPECT_EQ(a.R, a.B);
    EXPECT_EQ(a.samples, 65536);
    EXPECT_LE(a.halfWidth, 179 * row.tolerance * row.expected);
}

TEST_P(ClosedForm, IsAnswered) {
    for (const char *integrator : {"path", "bidir"})
        expectAnswer(GetParam(), integrator);
}

INSTANTIATE_TEST_SUITE_P(Probe, ClosedForm, testing::ValuesIn(rows()),
                         [](const auto &info) { return info.param.name; });

/// A furnace of two half spaces: L and E of light that has been scattered D times at most.
TEST(Depth, CountsScatteringsOnTheWay) {
    const std::string world = "Surface \"matte\" \"Ka\" [0] \"Kd\" [.5]\n"
                              "AreaLightSource \"arealight\" 1 \"radiance\" [1] \"onesided\" [0]\n"
                              "Sphere 1 -1 1 360\n";
    for (int depth : {0, 1, 8}) {
        const std::string option = "Option \"trace\" \"integer maxdepth\" " + std::to_string(depth);
        const double expected = 2 * (1 - std::pow(.5, depth + 1));
        const Probed E = probe(siWorld(world, option + "\n"), ".2 0 0 0 0 1\n", {"--spp", "4096"});
        const Probed L =
            probe(siWorld(world, option + "\n"), ".2 0 0 0 0 1\n", {"--spp", "4096", "--radiance"});
        ASSERT_EQ(E.answers.size(), 1u) << E.run.text();
        ASSERT_EQ(L.answers.size(), 1u) << L.run.text();
        EXPECT_NEAR(E.answers[0].total, pi * expected, 5e-3 * pi * expected) << depth;
        EXPECT_NEAR(L.answers[0].total, expected, 5e-3 * expected) << depth;
    }
}

TEST(Radiance, IsWhatALampSendsInWattsAndCandelas) {
    const Probed probed = probe(siWorld(lamp(disc("1", "1"), 2)),
                                "0 0 0 0 0 3\n0 0 0 0 0 -1\n.5 0 3 0 0 -1\n", {"--radiance"});
    ASSERT_EQ(probed.answers.size(), 3u) << probed.run.text();
    EXPECT_EQ(probed.answers[0].total, 2);
    EXPECT_EQ(probed.answers[0].photometric, 358);
    EXPECT_EQ(probed.answers[1].total, 0);
    EXPECT_EQ(probed.answers[2].total, 0); // Its back.
}

TEST(Units, ColorsCountByTheirLuminance) {
    const Probed probed =
        probe(siWorld("LightSource \"distantlight\" 1 \"lightcolor\" [1 2 4] \"from\" [0 0 1] "
                      "\"to\" [0 0 0]\n"),
              "0 0 0 0 0 1\n");
    ASSERT_EQ(probed.answers.size(), 1u) << probed.run.text();
    const Answer &a = probed.answers[0];
    EXPECT_NEAR(a.R, 1, 1e-6);
    EXPECT_NEAR(a.G, 2, 1e-6);
    EXPECT_NEAR(a.B, 4, 1e-6);
    EXPECT_NEAR(a.total, 7.0 / 3, 1e-6);
    EXPECT_NEAR(a.photometric, 179 * (.2126 + 2 * .7152 + 4 * .0722), 1e-3);
}

/// An intensity of 1 at a distance of 1 makes a white matte surface 1: it gets pi.
TEST(Units, ClassicLightsGiveWhatTheyGiveToMatte) {
    const std::string world = "WorldBegin\nLightSource \"pointlight\" 1 \"from\" [0 0 1]\n"
                              "Surface \"matte\"\n" +
                              screen + "WorldEnd\n";
    for (const char *integrator : {"classic", "path"}) {
        const Probed probed =
            probe(world, "1e-3 0 0 0 0 1\n-1 0 0 0 0 1\n", {"--integrator", integrator});
        ASSERT_EQ(probed.answers.size(), 2u) << probed.run.text();
        EXPECT_NEAR(probed.answers[0].total, pi, 2e-2)
            << integrator;                                    // Some light comes from matte.
        const bool casts = integrator == std::string("path"); // Classic lights cast no shadows.
        EXPECT_EQ(probed.answers[1].total > .5, !casts) << probed.run.text();
    }
}

} // namespace candela::test
