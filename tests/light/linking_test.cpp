// SPDX-License-Identifier: Apache-2.0
// Lamps that a surface must not hear, by linking or by category: its picture is that of a world in
// which they do not shine.
#include "foundation/base/student.h"
#include "tests/light/linked_lamps.h"
#include "tests/light/pictures.h"

#include <cmath>
#include <gtest/gtest.h>

namespace candela::test {
namespace {

struct Setting {
    Linking linking;
    bool path; ///< Else `classic`.
    double size;
};

enum class Other { Shines, IsDark };

/// The lamps stand before the surface, which is at z = 3, to both sides of the eye's view.
MeanAndError picture(const Setting &setting, Other other) {
    const Linking &linking = setting.linking;
    const double radiance = 1 / (setting.size * setting.size), at = .15 + setting.size / 2;
    std::string world = taggedLamp(1, at, 0, setting.size, radiance, linking.heardTag) +
                        taggedLamp(2, -at, 0, setting.size,
                                   other == Other::Shines ? 3 * radiance : 0, linking.otherTag);
    if (linking.switchedOff)
        world += "Illuminate 2 0\n";
    world += "Surface \"" + std::string(linking.surface) + "\"\nColor [1 1 1]\n" + squareAt(3, 4);
    const SmallPicture seen = takePicture(setting.path ? inPath : inClassic, world, 1024);
    return meanAndError({seen.red.begin(), seen.red.end()});
}

class LightLinking : public testing::TestWithParam<Setting> {};

TEST_P(LightLinking, GivesThePictureOfAWorldWithoutTheOtherLamp) {
    const MeanAndError both = picture(GetParam(), Other::Shines);
    const MeanAndError alone = picture(GetParam(), Other::IsDark);
    EXPECT_GT(alone.mean, 1e-4);
    const double error = std::hypot(both.standardError, alone.standardError);
    EXPECT_LE(error, .04 * alone.mean);
    EXPECT_LE(std::fabs(both.mean - alone.mean), studentQuantile(1e-5, 63) * error + 1e-6);
}

std::vector<Setting> settings() {
    std::vector<Setting> all;
    for (const Linking &linking : linkings)
        for (bool path : {true, false})
            for (double size : {.05, 1., 6.})
                all.push_back({linking, path, size});
    return all;
}

std::string nameOf(const testing::TestParamInfo<Setting> &info) {
    const Setting &setting = info.param;
    return std::string(setting.linking.name) + (setting.path ? "Path" : "Classic") +
           std::to_string(int(setting.size * 100));
}

INSTANTIATE_TEST_SUITE_P(All, LightLinking, testing::ValuesIn(settings()), nameOf);

} // namespace
} // namespace candela::test
