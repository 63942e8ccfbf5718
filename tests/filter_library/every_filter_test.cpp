// SPDX-License-Identifier: Apache-2.0
// What holds for each filter of the library, whatever it does.
#include "language/jit/jit.h"
#include "tests/filter_library/support/filter_run.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <ostream>

namespace candela::filters {
namespace {

struct Case {
    std::string name;
    Filter filter;
    friend std::ostream &operator<<(std::ostream &out, const Case &c) { return out << c.name; }
};

const Filter falsecolor("falsecolor"), convolve("convolve"), reinhard("reinhard02"),
    resample("crop_resample"), histogram("histogram_adjust"), ward("ward94"),
    rushmeier("tumblin_rushmeier93");

const Case cases[] = {
    {"ward", ward},
    {"wardLogAverage", ward.with("logaverage", 1)},
    {"tumblinRushmeier", rushmeier},
    {"tumblinRushmeierSymmetric", rushmeier.with("displayoffset", .84).with("clip", 0)},
    {"linearScale", Filter("linear_scale")},
    {"linearScaleLogMean", Filter("linear_scale").with("reference", "logmean")},
    {"reinhard", reinhard},
    {"histogramHuman", histogram},
    {"histogramLinear", histogram.with("contrast", "linear")},
    {"histogramNaive", histogram.with("contrast", "none")},
    {"exposure", Filter("exposure_ev")},
    {"reinhardLocal", reinhard.with("local", 1)},
    {"exposureCamera", Filter("exposure_ev").with("aperture", 4).with("shutter", .02)},
    {"falseColor", falsecolor},
    {"falseColorLog", falsecolor.with("log", 1).with("contours", 2)},
    {"falseColorBeside", falsecolor.with("legend", 2).with("contours", 1).with("palette", "heat")},
    {"bloom", Filter("bloom")},
    {"convolve", convolve},
    {"convolveWide", convolve.with("kernel", "lanczos").with("width", 77)},
    {"convolveWeights", convolve.withAll("weights3", {0, 1, 0, 1, 2, 1, 5, 0, 0})},
    {"crop", resample.withAll("crop", {.1, .8, .3, .9})},
    {"resample", resample.with("width", 31).with("kernel", "lanczos")},
    {"resampleBox", resample.with("width", 201).with("height", 11).with("kernel", "box")},
};

class EveryFilter : public testing::TestWithParam<Case> {};

/// The same bits for all lanes and threads; between instruction sets, mathematics rounds
/// differently.
TEST_P(EveryFilter, DoesNotDependOnTheWayItIsRun) {
    const Picture scene = manifold(117, 93, -1, 4);
    const Picture atBest = filtered(GetParam().filter, scene);
    for (const auto level : {runtime::IsaLevel::V2, runtime::IsaLevel::V3, runtime::IsaLevel::V4}) {
        if (!Jit::hostRuns(level))
            continue;
        const Picture expected = filtered(GetParam().filter, scene, {16, 1, level});
        expectNear(expected, atBest, 1e-5, .01);
        for (const int lanes : {1, 16})
            for (const int threads : {1, 3}) {
                SCOPED_TRACE(testing::Message() << int(level) << " " << lanes << " " << threads);
                const Picture found = filtered(GetParam().filter, scene, {lanes, threads, level});
                expectNear(found, expected, 0, 0);
            }
    }
}

/// Of every size, down to a pixel; from black to what no display has.
TEST_P(EveryFilter, TakesPicturesOfAnySize) {
    for (const auto &[width, height] : {std::pair{1, 1}, {3, 2}, {1, 40}, {70, 1}, {101, 95}})
        for (const double lowest : {-5., 0., 5.}) {
            const Picture found = filtered(GetParam().filter, manifold(width, height, lowest, 2));
            EXPECT_GE(found.width, 1);
            EXPECT_GE(found.height, 1);
            for (const Rgb &c : found.pixels)
                for (const double channel : c)
                    ASSERT_TRUE(std::isfinite(channel)) << width << " " << height << " " << lowest;
        }
}

TEST_P(EveryFilter, TakesBlackAndFlatPictures) {
    for (const double luminance : {0., 1e-3, 1., 1e5}) {
        const Picture found = filtered(GetParam().filter, grey(40, 30, luminance));
        for (const Rgb &c : found.pixels)
            for (const double channel : c)
                ASSERT_TRUE(std::isfinite(channel)) << luminance;
        // Flat stays flat; a legend is not.
        if (GetParam().name.rfind("falseColor", 0) != 0) {
            const Rgb first = found.at(0, 0);
            expectNear(found, Picture(found.width, found.height, first), 1e-5, 1e-6);
        }
    }
}

/// A pixel that is not a number counts as 0, and is told of.
TEST_P(EveryFilter, TakesPixelsThatAreNoNumbers) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinite = std::numeric_limits<double>::infinity();
    Picture scene = manifold(24, 20, 0, 2), mended = scene;
    scene.at(5, 6) = {nan, nan, nan};
    scene.at(11, 3) = {infinite, 1, 1};
    mended.at(5, 6) = {};
    mended.at(11, 3) = {0, 1, 1};
    ImageMaps maps = mapsOf(scene);
    std::string messages;
    run({GetParam().filter}, maps, {}, &messages);
    EXPECT_NE(messages, "");
    expectNear(pictureOf(maps), filtered(GetParam().filter, mended), 0, 0);
}

/// Nothing at all is opaque: as if all were.
TEST_P(EveryFilter, TakesPicturesWithoutOpacity) {
    const Picture scene = manifold(24, 20, 0, 2);
    ImageMaps maps = mapsOf(scene);
    setMap(maps, "Oi", Picture(24, 20));
    run({GetParam().filter}, maps);
    expectNear(pictureOf(maps), filtered(GetParam().filter, scene), 0, 0);
}

/// Scratch maps of one run do not show in the next, of whatever size.
TEST_P(EveryFilter, ComesOutTheSameASecondTime) {
    const Filter smaller = resample.withAll("crop", {0, .5, 0, .5});
    const Picture scene = manifold(60, 44, 0, 2);
    ImageMaps maps = mapsOf(scene);
    run({GetParam().filter}, maps);
    const Picture once = pictureOf(maps);
    setMap(maps, "Ci", scene);
    run({GetParam().filter}, maps);
    expectNear(pictureOf(maps), once, 0, 0);

    const Picture quarter = filtered(smaller, scene);
    setMap(maps, "Ci", quarter);
    setMap(maps, "Oi", Picture(quarter.width, quarter.height, {1, 1, 1}));
    run({GetParam().filter}, maps);
    expectNear(pictureOf(maps), filtered(GetParam().filter, quarter), 0, 0);
}

INSTANTIATE_TEST_SUITE_P(Library, EveryFilter, testing::ValuesIn(cases),
                         [](const auto &tested) { return tested.param.name; });

/// Brighter never becomes darker under what makes display values, and neither dodges nor burns.
class ToneCurve : public testing::TestWithParam<Case> {};

TEST_P(ToneCurve, IsMonotonic) {
    const auto ramp = makePicture(300, 2, [](int x, int) {
        const double value = std::pow(10, -4 + x * .03) / 179;
        return Rgb{value, value, value};
    });
    const Picture found = filtered(GetParam().filter, ramp);
    for (int x = 1; x < ramp.width; ++x)
        EXPECT_GE(found.at(x, 1)[0], found.at(x - 1, 1)[0] * (1 - 1e-6)) << x;
    EXPECT_GT(found.at(299, 0)[0], found.at(0, 0)[0]);
}

INSTANTIATE_TEST_SUITE_P(Library, ToneCurve, testing::ValuesIn(cases, cases + 11),
                         [](const auto &tested) { return tested.param.name; });

/// Of all but the operators that know the eye, which sees less in the dark.
class Adaptation : public testing::TestWithParam<Case> {};

TEST_P(Adaptation, TheUnitOfLightDoesNotMatter) {
    const Picture scene = manifold(40, 30, 0, 3);
    Picture brighter = scene;
    for (Rgb &c : brighter.pixels)
        c = 64. * c;
    const Picture found = filtered(GetParam().filter, scene);
    const bool knowsTheEye = GetParam().name.find("ward") == 0 ||
                             GetParam().name.find("tumblin") == 0 ||
                             GetParam().name == "histogramHuman";
    if (!knowsTheEye)
        expectNear(filtered(GetParam().filter, brighter), found, 2e-4, .01);
    else
        EXPECT_GT(meanOf(filtered(GetParam().filter, brighter), luminanceOf),
                  meanOf(found, luminanceOf));
}

INSTANTIATE_TEST_SUITE_P(Library, Adaptation, testing::ValuesIn(cases, cases + 12),
                         [](const auto &tested) { return tested.param.name; });

/// What counts turns of a loop is no more than the filter is good for: all of them end.
TEST(Numbers, ThatNoPictureHasRoomForEnd) {
    const Filter regression("feature_regression"), means("nlmeans");
    const struct {
        const char *name;
        Filter filter;
    } table[] = {{"nlmeans search", means.with("search", 1e38)},
                 {"nlmeans patch", means.with("patch", 1e38).with("search", 1)},
                 {"regression search", regression.with("search", 1e38).with("radius", 1)},
                 {"regression patch", regression.with("patch", 1e38).with("search", 1)},
                 {"regression radius", regression.with("radius", 1e38).with("search", 1)},
                 {"convolve width", convolve.with("width", 1e38)},
                 {"reinhard scales", reinhard.with("local", 1).with("scales", 1e38)},
                 {"falsecolor decades", falsecolor.with("log", 1).with("decades", 1e38)}};
    for (const auto &[name, filter] : table) {
        const int size = std::string(name).starts_with("falsecolor") ? 100 : 8; // It has a legend.
        ImageMaps maps = mapsOf(manifold(size, size, 0, 2));
        for (const char *map : {"variance", "albedo", "N"})
            setMap(maps, map, Picture(size, size, {.1, .1, .1}));
        run({filter}, maps);
        for (const Rgb &c : pictureOf(maps).pixels)
            for (const double channel : c)
                ASSERT_TRUE(std::isfinite(channel)) << name;
    }
}

/// A word that a parameter cannot be is told of, and something is made all the same.
TEST(Words, ThatNoFilterKnowsAreToldOf) {
    const struct {
        const char *filter, *parameter;
    } table[] = {{"linear_scale", "reference"},
                 {"energy_preserving", "by"},
                 {"histogram_adjust", "contrast"},
                 {"falsecolor", "quantity"},
                 {"falsecolor", "palette"},
                 {"crop_resample", "kernel"},
                 {"convolve", "kernel"}};
    for (const auto &[filter, parameter] : table) {
        Picture scene(40, 30, {.2, .3, .1});
        scene.at(3, 4) = {1, 2, 3};
        Filter wrong = Filter(filter).with(parameter, "nosuch");
        if (std::string(filter) == "crop_resample")
            wrong = wrong.with("width", 20);
        testing::internal::CaptureStdout();
        ImageMaps maps = mapsOf(scene);
        setMap(maps, "variance", Picture(40, 30, {1e-6, 1e-6, 1e-6}));
        for (const char *map : {"albedo", "N", "id"})
            setMap(maps, map, Picture(40, 30, {.5, .5, .5}));
        run({wrong}, maps);
        const Picture made = pictureOf(maps);
        const std::string said = testing::internal::GetCapturedStdout();
        EXPECT_NE(said.find("nosuch"), said.npos) << filter << " " << parameter;
        EXPECT_GT(made.at(2, 2)[1], 0) << filter << " " << parameter;
    }
}

} // namespace
} // namespace candela::filters
