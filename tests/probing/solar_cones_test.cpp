// SPDX-License-Identifier: Apache-2.0
// solar() with several cones: what they send is what the shader says for each direction, over the
// solid angle of the widest, however directions were chosen (docs/units.md).
#include "tests/probing/probing.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace candela::test {
namespace {

struct Cones {
    std::string name;
    std::string first, second; ///< Where the light goes.
    double angles[2];          ///< Full, degrees.
    double expected;           ///< On a sensor that faces +z, W m^-2, for Cl = 1.
};

void PrintTo(const Cones &cones, std::ostream *stream) { *stream << cones.name; }

/// Of a cone whose axis is tilted by so much against the sensor's, all of it above the horizon, for
/// Cl = 1.
double share(double angle, double tilt = 0) {
    const double degree = std::numbers::pi / 180;
    return (1 + std::cos(angle / 2 * degree)) / 2 * std::cos(tilt * degree);
}

/// What a cone of that angle takes of the solid angle of another.
double part(double angle, double of) {
    const double degree = std::numbers::pi / 180;
    return (1 - std::cos(angle / 2 * degree)) / (1 - std::cos(of / 2 * degree));
}

std::vector<Cones> cones() {
    const std::string down = "[0 0 -1]", slanted = "[.6 0 -.8]", aside = "[-.6 0 -.8]",
                      level = "[1 0 0]";
    const double tilt = 36.8698976458440;
    return {
        {"SkyAndSunWithin", down, slanted, {180, 30}, .5},
        {"SunWithinAndSky", slanted, down, {30, 180}, .5},
        {"TwoSkies", down, down, {180, 180}, .5},
        {"SkyAndSunOnTheHorizon", down, level, {180, 40}, .5},
        {"TwoSuns", slanted, aside, {20, 20}, 2 * share(20, tilt)},
        {"WideAndNarrowSun",
         slanted,
         aside,
         {20, 2},
         share(20, tilt) + part(2, 20) * share(2, tilt)},
        {"SmallSunInSky", down, slanted, {180, .53}, .5},
        {"DirectionBesideSky", down, slanted, {180, 0}, .5 + .8},
        {"TwoDirections", slanted, aside, {0, 0}, 1.6},
        {"SkyOfAllSides", down, slanted, {360, 90}, .25},
    };
}

class SolarCones : public testing::TestWithParam<Cones> {};

TEST_P(SolarCones, SendTheSameWhateverTheirImportance) {
    const Cones &c = GetParam();
    for (const char *importances : {"[1 1]", "[1 100]", "[5 .2]", "[.001 .003]"})
        for (const char *exponents : {"[0 0]", "[1 40]"}) {
            SCOPED_TRACE(std::string(importances) + " " + exponents);
            const Probed probed =
                probe(siWorld("LightSource \"cones\" 1 \"vector first\" " + c.first +
                              " \"vector second\" " + c.second + " \"float[2] angles\" [" +
                              std::to_string(c.angles[0]) + " " + std::to_string(c.angles[1]) +
                              "] \"float[2] importances\" " + importances +
                              " \"float[2] exponents\" " + exponents + "\n"),
                      "0 0 0 0 0 1\n",
                      {"--spp", "65536", "--shader-path",
                       std::string(CANDELA_SOURCE_DIR) + "/tests/probing/shaders:&"});
            ASSERT_EQ(probed.answers.size(), 1u) << probed.run.text();
            EXPECT_EQ(probed.run.err, "");
            EXPECT_NEAR(probed.answers[0].total, c.expected, .03 * c.expected);
            EXPECT_LE(std::abs(probed.answers[0].total - c.expected),
                      2 * probed.answers[0].halfWidth / 179 + 2e-4 * c.expected);
        }
}

INSTANTIATE_TEST_SUITE_P(Probe, SolarCones, testing::ValuesIn(cones()),
                         [](const auto &info) { return info.param.name; });

} // namespace
} // namespace candela::test
