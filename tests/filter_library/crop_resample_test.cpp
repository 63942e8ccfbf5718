// SPDX-License-Identifier: Apache-2.0
// Parts of pictures, and pictures in other sizes.
#include "tests/filter_library/support/filter_run.h"
#include "tests/filter_library/support/kernels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace candela::filters {
namespace {

/// By two dimensions at once, from the pixels [x0, x1) x [y0, y1).
Picture resampled(const Picture &scene, const std::string &kernel, int x0, int x1, int y0, int y1,
                  int width, int height) {
    const auto span = [&](double ratio) {
        return usualWidth(kernel) * (kernel == "box" ? ratio : std::max(ratio, 1.));
    };
    const double xratio = double(x1 - x0) / width, yratio = double(y1 - y0) / height;
    const int xreach = int(span(xratio)) + 2, yreach = int(span(yratio)) + 2;
    return makePicture(width, height, [&](int x, int y) {
        const double u = x0 + (x + .5) * xratio - .5, v = y0 + (y + .5) * yratio - .5;
        Rgb sum{};
        double weights = 0;
        for (int j = int(v) - yreach; j <= int(v) + yreach; ++j)
            for (int i = int(u) - xreach; i <= int(u) + xreach; ++i) {
                const double weight =
                    kernelAt(kernel, i - u, span(xratio)) * kernelAt(kernel, j - v, span(yratio));
                sum = sum + weight * scene.clamped(i, j);
                weights += weight;
            }
        sum = 1 / weights * sum;
        for (double &channel : sum)
            channel = std::max(channel, 0.);
        return sum;
    });
}

TEST(CropResample, CutsWholePixels) {
    const Picture scene = manifold(20, 10, 0, 2);
    const Picture found =
        filtered(Filter("crop_resample").withAll("crop", {.25, .7, .2, 1}), scene);
    const auto expected = makePicture(9, 8, [&](int x, int y) { return scene.at(5 + x, 2 + y); });
    expectNear(found, expected, 0, 0);
    expectNear(filtered(Filter("crop_resample"), scene), scene, 0, 0);
}

/// What is behind the picture is seen through the same pixels as before.
TEST(CropResample, OpacityGoesWithThePicture) {
    const Picture scene = manifold(20, 10, 0, 2);
    const Picture opacity = makePicture(20, 10, [](int x, int y) {
        return asFloats({x / 20., y / 10., 1});
    });
    for (const Filter &filter :
         {Filter("crop_resample").withAll("crop", {.25, .7, .2, 1}),
          Filter("crop_resample").with("width", 50).with("kernel", "triangle")}) {
        ImageMaps maps = mapsOf(scene);
        setMap(maps, "Oi", opacity);
        run({filter}, maps);
        expectNear(pictureOf(maps, "Oi"), filtered(filter, opacity), 0, 0);
    }
}

TEST(CropResample, IsTheFormulaForEveryKernel) {
    const Picture scene = manifold(24, 18, 0, 2);
    for (const char *kernel : kernelNames)
        for (const auto &[width, height] : {std::pair{7, 5}, {24, 40}, {60, 11}, {23, 18}}) {
            SCOPED_TRACE(std::string(kernel) + " " + std::to_string(width));
            const Filter filter = Filter("crop_resample")
                                      .with("kernel", kernel)
                                      .with("width", width)
                                      .with("height", height);
            expectNear(filtered(filter, scene),
                       resampled(scene, kernel, 0, 24, 0, 18, width, height), 2e-5, .1);
            const Picture part = filtered(filter.withAll("crop", {.25, .75, .5, 1}), scene);
            expectNear(part, resampled(scene, kernel, 6, 18, 9, 18, width, height), 2e-5, .1);
        }
}

TEST(CropResample, OneSizeGivesTheOther) {
    const Picture scene = manifold(40, 30, 0, 1);
    const Picture narrow = filtered(Filter("crop_resample").with("width", 20), scene);
    EXPECT_EQ(narrow.width, 20);
    EXPECT_EQ(narrow.height, 15);
    const Picture high = filtered(Filter("crop_resample").with("height", 60), scene);
    EXPECT_EQ(high.width, 80);
    EXPECT_EQ(high.height, 60);
}

/// A box gives each new pixel its area's mean: light is kept in any size.
TEST(CropResample, ABoxKeepsTheMean) {
    const Picture scene = manifold(31, 17, -1, 3);
    const double before = meanOf(scene, luminanceOf);
    for (const auto &[width, height] : {std::pair{1, 1}, {10, 5}, {31, 40}, {62, 34}, {77, 3}}) {
        const Filter filter = Filter("crop_resample")
                                  .with("kernel", "box")
                                  .with("width", width)
                                  .with("height", height);
        EXPECT_NEAR(meanOf(filtered(filter, scene), luminanceOf) / before, 1, 3e-6) << width;
    }
}

/// What is linear stays so away from the border, under kernels that interpolate.
TEST(CropResample, RampsStayRamps) {
    const auto ramp = makePicture(32, 4, [](int x, int) { return Rgb{x + 1., 2. * x, 5}; });
    for (const char *kernel : {"triangle", "catmull-rom"}) {
        const Filter filter =
            Filter("crop_resample").with("kernel", kernel).with("width", 96).with("height", 4);
        const Picture found = filtered(filter, ramp);
        for (int x = 12; x < 84; ++x)
            EXPECT_NEAR(found.at(x, 2)[0], (x + .5) / 3 - .5 + 1, 2e-5) << kernel << x;
    }
}

TEST(CropResample, NegativeLobesGoBelowBlackOnlyWhereAsked) {
    Picture lamp(16, 3);
    lamp.at(8, 1) = {100, 100, 100};
    const Filter filter =
        Filter("crop_resample").with("kernel", "lanczos").with("width", 48).with("height", 9);
    double least = 0;
    for (const Rgb &c : filtered(filter.with("negative", 1), lamp).pixels)
        least = std::min(least, c[0]);
    EXPECT_LT(least, -1);
    for (const Rgb &c : filtered(filter, lamp).pixels)
        EXPECT_GE(c[0], 0);
}

} // namespace
} // namespace candela::filters
