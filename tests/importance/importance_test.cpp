// SPDX-License-Identifier: Apache-2.0
// Stated importance has to pay: on the desk's metal plate, whose shader asks for a narrow strong
// cone and a weak hemisphere, samples by these cones against samples of the hemisphere.
#include "image/picture_file.h"
#include "tests/support/program.h"
#include "tests/support/scratch_folder.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace candela::test {

namespace {

/// What the pixels of the plate say, over all seeds.
struct PlateResult {
    double variance = 0; ///< Of the pixels' means, summed over channels.
    double mean = 0;     ///< Of a pixel's channels, added.
    double meanError = 0;
    int pixels = 0;
};

void add(const Picture &picture, PlateResult &result) {
    const PictureChannel *id = picture.find("id");
    ASSERT_TRUE(id);
    // The plate is the last primitive of the scene; filtered values between two ids are edges.
    float plate = *std::max_element(id->values.begin(), id->values.end());
    for (const char *channel : {"R", "G", "B"}) {
        const PictureChannel *value = picture.find(channel);
        const PictureChannel *variance = picture.find(std::string("variance.") + channel);
        ASSERT_TRUE(value && variance);
        for (std::size_t i = 0; i < id->values.size(); ++i)
            if (id->values[i] == plate) {
                result.variance += variance->values[i];
                result.mean += value->values[i];
                result.pixels += 1;
            }
    }
}

PlateResult renderPlate(const char *sampling) {
    const std::string scene = CANDELA_SOURCE_DIR "/examples/desk_lamp/desk_lamp.rib";
    // The scene's exposure is for the eye: here radiance counts, with every sample in one pixel.
    ScratchFolder folder;
    std::string rib = contentOf(scene);
    rib.insert(rib.find("WorldBegin"), "Exposure 1 1\nPixelFilter \"box\" 1 1\n"
                                       "Display \"plate.exr\" \"openexr\" \"rgb,id,variance\"\n");
    folder.write("plate.rib", rib);
    PlateResult result;
    constexpr int seeds = 4;
    for (int seed = 1; seed <= seeds; ++seed) {
        Outcome run =
            runCandela({folder.path("plate.rib"), "--sampling", sampling, "--format", "160x120",
                        "--spp", "32", "--seed", std::to_string(seed), "--output-dir",
                        folder.path(), "--shader-path", CANDELA_SOURCE_DIR "/examples/desk_lamp"});
        EXPECT_EQ(run.status, 0) << run.text();
        std::string problem;
        std::optional<Picture> picture = readPicture(folder.path("plate.exr"), problem);
        EXPECT_TRUE(picture) << problem;
        if (picture)
            add(*picture, result);
    }
    result.meanError = std::sqrt(result.variance) / result.pixels;
    result.mean /= result.pixels;
    result.variance /= result.pixels;
    return result;
}

} // namespace

TEST(Importance, ConesHaveLessThanAThirdOfTheHemispheresVariance) {
    PlateResult cones = renderPlate("cones"), hemisphere = renderPlate("hemisphere");
    std::printf("    plate: variance %.4g by cones, %.4g by the hemisphere, ratio %.2f; mean %.5g "
                "and %.5g\n",
                cones.variance, hemisphere.variance, hemisphere.variance / cones.variance,
                cones.mean, hemisphere.mean);
    ASSERT_GT(cones.pixels, 4 * 3 * 100);
    ASSERT_EQ(cones.pixels, hemisphere.pixels);
    EXPECT_GT(cones.variance, 0);
    EXPECT_GT(hemisphere.variance, 3 * cones.variance);
    // The same picture: importance moves noise, not light.
    EXPECT_LE(std::abs(cones.mean - hemisphere.mean),
              5 * std::hypot(cones.meanError, hemisphere.meanError));
}

} // namespace candela::test
