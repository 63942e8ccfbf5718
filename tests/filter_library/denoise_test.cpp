// SPDX-License-Identifier: Apache-2.0
// The filters that denoise: against references in double precision, and what must hold of each.
#include "language/jit/jit.h"
#include "tests/filter_library/support/denoise_reference.h"
#include "tests/filter_library/support/filter_run.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <ostream>

namespace candela::filters {
namespace {

const Filter means("nlmeans"), fit("feature_regression"), preserving("energy_preserving");

Picture denoised(const Filter &filter, const NoisyScene &scene, const Ways &ways = {}) {
    ImageMaps maps = scene.maps();
    run({filter}, maps, ways);
    return pictureOf(maps);
}

// --- Against references --------------------------------------------------------------------------

TEST(NonLocalMeans, IsTheMeanThatTheReferenceMakes) {
    const NoisyScene scene = noisyScene(29, 23);
    expectNear(denoised(means, scene), nonLocalMeans(scene), 2e-5, .01);
    const Filter plain = means.with("bend", 0).with("shade", 0).with("search", 3).with("patch", 1);
    const Filter wide = plain.with("tolerance", 1);
    expectNear(denoised(plain, scene), nonLocalMeans(scene, {3, 1, .45, 0, 0}), 2e-5, .01);
    expectNear(denoised(wide, scene), nonLocalMeans(scene, {3, 1, 1, 0, 0}), 2e-5, .01);
}

TEST(FeatureRegression, IsTheFitThatTheReferenceMakes) {
    const NoisyScene scene = noisyScene(29, 23);
    expectNear(denoised(fit, scene), regression(scene), 1e-4, .01);
    const Filter other = fit.with("search", 3)
                             .with("patch", 1)
                             .with("tolerance", .6)
                             .with("radius", 4)
                             .with("fittolerance", .7)
                             .with("contrast", .3)
                             .with("bend", 2);
    expectNear(denoised(other, scene), regression(scene, {3, 1, .6, 4, .7, .3, 2}), 1e-4, .01);
}

TEST(EnergyPreserving, SpreadsAsTheReferenceDoes) {
    const NoisyScene scene = noisyScene(29, 23);
    const PreservingSettings variance, fraction{false};
    expectNear(denoised(preserving, scene), energyPreserving(scene, variance), 3e-5, .01);
    expectNear(denoised(preserving.with("by", "fraction"), scene),
               energyPreserving(scene, fraction), 3e-5, .01);
    const Filter coarse = preserving.with("steps", 3).with("levels", 20);
    expectNear(denoised(coarse, scene), energyPreserving(scene, {true, 3, 20}), 3e-5, .01);
    const Filter wide = preserving.with("by", "fraction").with("fraction", .1).with("radius", 4);
    expectNear(denoised(wide, scene), energyPreserving(scene, {false, 8, 128, .1, 4}), 3e-5, .01);
}

// --- Energy preserving: VALIDATION H4 ------------------------------------------------------------

const Filter asThePaper = preserving.with("textured", 0).with("withinobjects", 0).with("steps", 13);

/// A constant field with one outlier that is not converged.
struct Outlier {
    Outlier(int width, int height, int x, int y, double level, double outlier)
        : scene{grey(width, height, level),
                grey(width, height, level),
                Picture(width, height),
                Picture(width, height),
                Picture(width, height, {1, 1, 1}),
                Picture(width, height)} {
        scene.color.at(x, y) = grey(1, 1, outlier).at(0, 0);
        scene.variance.at(x, y) = {1e6, 1e6, 1e6};
    }
    NoisyScene scene;
};

TEST(EnergyPreserving, OneOutlierGoesOverAsManyPixelsAsHideIt) {
    const double level = 20, visible = level / 128;
    for (const double outlier : {20.1, 21.6, 30., 60., 2.}) {
        const Outlier field(64, 48, 31, 22, level, outlier);
        const Picture found = denoised(asThePaper, field.scene);
        const double excess = outlier - level;
        const int wanted = int(std::ceil(std::abs(excess) / visible));
        int raised = 0;
        double farthest = 0;
        for (int y = 0; y < 48; ++y)
            for (int x = 0; x < 64; ++x) {
                const double more = luminanceOf(found.at(x, y)) - level;
                if (std::abs(more) < 1e-4 * visible)
                    continue;
                ++raised;
                farthest = std::max(farthest, std::hypot(x - 31, y - 22));
                // The pixel itself keeps what the others' roundings make, to half a bit of each.
                const double kept = x == 31 && y == 22 ? wanted * level * 0x1p-24 : 0;
                EXPECT_NEAR(more, excess / wanted, 1e-4 * visible + kept) << x << " " << y;
                EXPECT_LE(std::abs(more), visible * (1 + 1e-4) + kept);
            }
        EXPECT_EQ(raised, wanted) << outlier;
        // A disc, and no more than a pixel wider than one of that many.
        EXPECT_LE(farthest, std::sqrt(wanted / 3.14159265) + 1) << outlier;
    }
}

/// At a border or in a corner the pixels that are there take it all.
TEST(EnergyPreserving, TheSumStaysAtBordersToo) {
    for (const auto &[x, y] : {std::array{0, 0}, {31, 0}, {63, 47}, {1, 20}, {63, 5}})
        for (const std::string by : {"variance", "fraction"}) {
            const Outlier field(64, 48, x, y, 20, 90);
            const Picture found = denoised(asThePaper.with("by", by), field.scene);
            const double before = luminanceOf(sumOf(field.scene.color));
            EXPECT_NEAR(luminanceOf(sumOf(found)) / before, 1, 1e-6) << x << " " << y << " " << by;
            EXPECT_LT(luminanceOf(found.at(x, y)), 25) << x << " " << y << " " << by;
        }
}

TEST(EnergyPreserving, TheSumStaysInEachChannelAndObject) {
    const NoisyScene scene = noisyScene(61, 43);
    for (const std::string by : {"variance", "fraction"})
        for (const double textured : {0, 1})
            for (const double within : {0, 1}) {
                const Filter filter = preserving.with("by", by)
                                          .with("textured", textured)
                                          .with("withinobjects", within);
                const Picture found = denoised(filter, scene);
                const Rgb before = sumOf(scene.color), after = sumOf(found);
                for (int c = 0; c < 3; ++c)
                    EXPECT_NEAR(after[c] / before[c], 1, 1e-6) << by << textured << within;
                EXPECT_GT(squaredError(found, scene.color), 0);
            }
}

TEST(EnergyPreserving, NothingCrossesOutlines) {
    Outlier field(40, 40, 19, 12, 20, 400);
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 40; ++x)
            field.scene.id.at(x, y) = {x < 22 ? 5. : 6., 0, 0};
    const Picture found = denoised(preserving, field.scene);
    for (int y = 0; y < 40; ++y)
        for (int x = 21; x < 40; ++x)
            EXPECT_EQ(found.at(x, y)[1], field.scene.color.at(x, y)[1]) << x << " " << y;
    EXPECT_LT(luminanceOf(found.at(19, 12)), 25);
}

// --- What holds of all ---------------------------------------------------------------------------

struct Case {
    std::string name;
    Filter filter;
    double symmetric; ///< To what part of a value mirrored pictures agree.
    double texture;   ///< To what part of the light textures stay.
    friend std::ostream &operator<<(std::ostream &out, const Case &c) { return out << c.name; }
};

const Case cases[] = {{"means", means, 2e-5, .05},
                      {"regression", fit, 1e-4, .005},
                      {"preservingByVariance", preserving, .05, .005},
                      {"preservingByFraction", preserving.with("by", "fraction"), 2e-5, .005}};

class Denoising : public testing::TestWithParam<Case> {};

TEST_P(Denoising, ErrorBecomesLess) {
    const NoisyScene scene = noisyScene(96, 80);
    const Picture found = denoised(GetParam().filter, scene);
    const double before = squaredError(scene.color, scene.clean);
    EXPECT_LT(squaredError(found, scene.clean), .5 * before);
}

TEST_P(Denoising, ConstantsStay) {
    for (const double level : {0., 1e-3, 1., 1e5}) {
        NoisyScene scene = noisyScene(40, 30);
        scene.color = grey(40, 30, level);
        scene.albedo = Picture(40, 30, {.5, .5, .5});
        scene.variance = Picture(40, 30, {level * level * 1e-7, 0, level});
        expectNear(denoised(GetParam().filter, scene), scene.color, 1e-5, 1e-9);
    }
}

/// Even light that is known well leaves a texture as it is; nlmeans averages over albedos that
/// differ by less than `shade`.
TEST_P(Denoising, TexturesStay) {
    NoisyScene scene = noisyScene(48, 40);
    for (std::size_t k = 0; k < scene.color.pixels.size(); ++k)
        for (int c = 0; c < 3; ++c) {
            const double value = .7 * scene.albedo.pixels[k][c];
            scene.color.pixels[k][c] = value;
            scene.variance.pixels[k][c] = 1e-4 * value * value;
        }
    expectNear(denoised(GetParam().filter, scene), scene.color, GetParam().texture, .7);
}

/// The last ring of a disc is not full, so that energy_preserving is even only within grey steps.
TEST_P(Denoising, IsTheSameInAMirror) {
    const NoisyScene scene = noisyScene(31, 26);
    const Picture found = denoised(GetParam().filter, mirrored(scene));
    const Picture expected = mirrored(denoised(GetParam().filter, scene));
    if (GetParam().symmetric < .01)
        expectNear(found, expected, GetParam().symmetric, .01);
    else
        EXPECT_LT(squaredError(found, expected),
                  GetParam().symmetric * squaredError(expected, mirrored(scene.color)));
}

/// Ones and zeros of every result, for all lanes, threads and instruction sets.
TEST_P(Denoising, DoesNotDependOnTheWayItIsRun) {
    const NoisyScene scene = noisyScene(83, 37);
    for (const auto level : {runtime::IsaLevel::V3, runtime::IsaLevel::V4}) {
        if (!Jit::hostRuns(level))
            continue;
        const Picture expected = denoised(GetParam().filter, scene, {16, 1, level});
        for (const int lanes : {1, 16})
            for (const int threads : {1, 3}) {
                SCOPED_TRACE(testing::Message() << int(level) << " " << lanes << " " << threads);
                expectNear(denoised(GetParam().filter, scene, {lanes, threads, level}), expected, 0,
                           0);
            }
    }
}

TEST_P(Denoising, TakesPicturesOfAnySize) {
    for (const auto &[width, height] : {std::pair{1, 1}, {3, 2}, {1, 40}, {70, 1}, {2, 2}}) {
        const NoisyScene scene = noisyScene(width, height);
        const Picture found = denoised(GetParam().filter, scene);
        ASSERT_EQ(found.width, width);
        ASSERT_EQ(found.height, height);
        for (const Rgb &c : found.pixels)
            for (const double channel : c)
                ASSERT_TRUE(channel >= 0 && channel < 100) << width << " " << height;
    }
}

/// A pixel that is not a number counts as 0, and is told of.
TEST_P(Denoising, TakesPixelsThatAreNoNumbers) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    NoisyScene scene = noisyScene(24, 20), mended = scene;
    scene.color.at(5, 6) = {nan, nan, nan};
    mended.color.at(5, 6) = {};
    ImageMaps maps = scene.maps();
    std::string messages;
    run({GetParam().filter}, maps, {}, &messages);
    EXPECT_NE(messages, "");
    expectNear(pictureOf(maps), denoised(GetParam().filter, mended), 0, 0);
}

/// Without maps that guide it, it says so and does what it can.
TEST_P(Denoising, TakesPicturesOfWhichNothingElseIsKnown) {
    const NoisyScene scene = noisyScene(24, 20);
    ImageMaps maps = mapsOf(scene.color);
    std::string messages;
    run({GetParam().filter}, maps, {}, &messages);
    EXPECT_NE(messages.find("there is no map"), std::string::npos) << messages;
    const Picture found = pictureOf(maps);
    ASSERT_EQ(found.width, 24);
    for (const Rgb &c : found.pixels)
        for (const double channel : c)
            ASSERT_TRUE(channel >= 0 && channel < 100);
}

/// Maps of an earlier picture, of another size, do not show.
TEST_P(Denoising, ComesOutTheSameAfterAnotherPicture) {
    const NoisyScene large = noisyScene(50, 40), small = noisyScene(21, 34);
    ImageMaps maps = large.maps();
    run({GetParam().filter}, maps);
    small.putInto(maps);
    run({GetParam().filter}, maps);
    expectNear(pictureOf(maps), denoised(GetParam().filter, small), 0, 0);
}

INSTANTIATE_TEST_SUITE_P(Library, Denoising, testing::ValuesIn(cases),
                         [](const auto &tested) { return tested.param.name; });

} // namespace
} // namespace candela::filters
