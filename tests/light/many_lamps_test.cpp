// SPDX-License-Identifier: Apache-2.0
// One lamp that a surface hears among 99 that it does not: neither the light nor the noise of a
// world without those.
#include "foundation/base/student.h"
#include "tests/light/linked_lamps.h"
#include "tests/light/pictures.h"

#include <cmath>
#include <gtest/gtest.h>

namespace candela::test {
namespace {

struct Setting {
    Linking linking;
    bool path, instance;
};

/// The heard lamp stands at one side, a field of others at the other.
std::string world(const Setting &setting, bool others) {
    const Linking &linking = setting.linking;
    std::string text = taggedLamp(1, .3, 0, .2, 1, linking.heardTag);
    for (int i = 0; i < 99 && others; ++i) {
        const int number = i + 2;
        text += taggedLamp(number, -.3 - .25 * (i % 9), .25 * (i / 9 - 5), .2, 5, linking.otherTag);
        if (linking.switchedOff)
            text += "Illuminate " + std::to_string(number) + " 0\n";
    }
    const std::string look =
        "Surface \"" + std::string(linking.surface) + "\"\nColor [1 1 1]\nTranslate 0 0 3\n";
    const std::string square = squareAt(0, 4);
    if (!setting.instance)
        return text + look + square;
    return text + "ObjectBegin 1\n" + square + "ObjectEnd\n" + look + "ObjectInstance 1\n";
}

struct MeanAndVariance {
    double mean = 0, variance = 0;
};

/// Of pixels; pairs of neighbours, whose means are the same, tell the variance.
MeanAndVariance ofPixels(const Setting &setting, bool others) {
    constexpr int across = 64;
    const SmallPicture seen = takePicture(setting.path ? inPath : inClassic, world(setting, others),
                                          16, others ? 1 : 2, across);
    MeanAndVariance result;
    const double count = double(seen.red.size());
    EXPECT_EQ(count, across * across);
    for (std::size_t i = 0; i + 1 < seen.red.size(); i += 2) {
        const double a = seen.red[i], b = seen.red[i + 1];
        result.mean += (a + b) / count;
        result.variance += (a - b) * (a - b) / count;
    }
    return result;
}

class OneLampAmongMany : public testing::TestWithParam<Setting> {};

TEST_P(OneLampAmongMany, GivesTheLightAndTheNoiseOfItselfAlone) {
    const MeanAndVariance all = ofPixels(GetParam(), true), alone = ofPixels(GetParam(), false);
    EXPECT_GT(alone.mean, 1e-4);
    const double error = std::sqrt((all.variance + alone.variance) / (64 * 64));
    EXPECT_LE(error, .01 * alone.mean);
    EXPECT_LE(std::fabs(all.mean - alone.mean), studentQuantile(1e-5, 4095) * error);
    // The ratio of two variances of 2048 degrees of freedom: 1.3 has a chance under 1e-8. Noise of
    // rare bright samples would need room, but there is none with one lamp.
    EXPECT_LE(all.variance, 1.3 * alone.variance);
}

std::vector<Setting> settings() {
    std::vector<Setting> all;
    for (const Linking &each : linkings)
        for (bool path : {true, false})
            for (bool instance : {false, true})
                all.push_back({each, path, instance});
    return all;
}

std::string nameOf(const testing::TestParamInfo<Setting> &info) {
    const Setting &setting = info.param;
    return std::string(setting.linking.name) + (setting.path ? "Path" : "Classic") +
           (setting.instance ? "Instance" : "");
}

INSTANTIATE_TEST_SUITE_P(All, OneLampAmongMany, testing::ValuesIn(settings()), nameOf);

/// Lights that take light away are as strong as those that give it.
TEST(NegativeLamps, CountByTheirStrength) {
    const std::string two =
        "LightSource \"pointlight\" 1 \"from\" [0 0 0] \"intensity\" [3.14159265]\n"
        "LightSource \"pointlight\" 2 \"from\" [0 0 0] \"intensity\" [-1]\n"
        "Surface \"matte\"\n" +
        squareAt(1, 5);
    const SmallPicture classic = takePicture(inClassic, two, 1),
                       path = takePicture(inPath, two, 256);
    const MeanAndError expected = meanAndError({classic.red.begin(), classic.red.end()});
    const MeanAndError seen = meanAndError({path.red.begin(), path.red.end()});
    EXPECT_LT(seen.standardError, .01 * expected.mean);
    EXPECT_NEAR(seen.mean, expected.mean, 5 * seen.standardError + 1e-3);
}

} // namespace
} // namespace candela::test
