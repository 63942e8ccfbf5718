// SPDX-License-Identifier: Apache-2.0
// Convolution with named kernels and with weights.
#include "tests/filter_library/support/filter_run.h"
#include "tests/filter_library/support/kernels.h"

#include <gtest/gtest.h>

#include <cmath>

namespace candela::filters {
namespace {

/// By two dimensions at once.
Picture convolved(const Picture &scene, const std::string &kernel, double xwidth, double ywidth) {
    const int reach = int(std::max(xwidth, ywidth) / 2 + .5);
    return makePicture(scene.width, scene.height, [&](int x, int y) {
        Rgb sum{};
        double weights = 0;
        for (int j = -reach; j <= reach; ++j)
            for (int i = -reach; i <= reach; ++i) {
                const double weight = kernelAt(kernel, i, xwidth) * kernelAt(kernel, j, ywidth);
                sum = sum + weight * scene.clamped(x + i, y + j);
                weights += weight;
            }
        return 1 / weights * sum;
    });
}

TEST(Convolve, NamedKernelsAreTheirFormulas) {
    const Picture scene = manifold(40, 26, 0, 2);
    for (const char *kernel : kernelNames)
        for (const auto &[xwidth, ywidth] : {std::pair{5., 5.}, {8.5, 3.}, {1., 12.}}) {
            SCOPED_TRACE(kernel);
            const Filter filter = Filter("convolve")
                                      .with("kernel", kernel)
                                      .with("xwidth", xwidth)
                                      .with("ywidth", ywidth);
            // Negative lobes take light away: rounding is that of the brightest pixels.
            expectNear(filtered(filter, scene), convolved(scene, kernel, xwidth, ywidth), 1e-5, .1);
        }
}

/// Wider than the picture, and than what rows have room for beside it.
TEST(Convolve, KernelsMayBeWiderThanThePicture) {
    const Picture scene = manifold(30, 8, 0, 2);
    const Filter filter = Filter("convolve").with("kernel", "triangle").with("width", 90);
    expectNear(filtered(filter, scene), convolved(scene, "triangle", 90, 90), 1e-5, 0);
}

std::vector<double> numbers(int count) {
    std::vector<double> all;
    for (int i = 1; i <= count; ++i)
        all.push_back(i);
    return all;
}

TEST(Convolve, APixelAloneBecomesTheWeights) {
    Picture dot(15, 13);
    dot.at(7, 6) = {1, 10, 100};
    for (const int size : {3, 5, 7}) {
        const std::string name = "weights" + std::to_string(size);
        const Filter filter = Filter("convolve").withAll(name, numbers(size * size));
        const Picture found = filtered(filter, dot);
        for (int row = 0; row < size; ++row)
            for (int column = 0; column < size; ++column) {
                const int x = 7 + column - size / 2, y = 6 + row - size / 2;
                EXPECT_EQ(found.at(x, y)[0], row * size + column + 1);
                EXPECT_EQ(found.at(x, y)[2], 100 * (row * size + column + 1));
            }
        EXPECT_EQ(sumOf(found)[0], size * size * (size * size + 1) / 2);
        EXPECT_NEAR(sumOf(filtered(filter.with("normalize", 1), dot))[1], 10, 1e-5);
    }
}

TEST(Convolve, WeightsMeetTheBorderAsItHolds) {
    const Picture scene = manifold(12, 9, 0, 1);
    const Filter filter = Filter("convolve").withAll("weights3", {0, -1, 0, -1, 5, -1, 0, -1, 0});
    const auto expected = makePicture(12, 9, [&](int x, int y) {
        const Rgb around = scene.clamped(x - 1, y) + scene.clamped(x + 1, y) +
                           scene.clamped(x, y - 1) + scene.clamped(x, y + 1);
        return 5. * scene.at(x, y) + -1. * around;
    });
    expectNear(filtered(filter, scene), expected, 1e-5, .1);
}

TEST(Convolve, ConstantPicturesStayAsTheyAre) {
    const Picture scene(17, 11, {.1, 1, 30});
    for (const char *kernel : kernelNames)
        for (const double width : {1., 4., 7.3, 40.}) {
            const Filter filter = Filter("convolve").with("kernel", kernel).with("width", width);
            expectNear(filtered(filter, scene), scene, 2e-6, 0);
        }
}

TEST(Convolve, AKernelThatIsNotThereLeavesThePicture) {
    const Picture scene = manifold(8, 8, 0, 1);
    const Filter filter = Filter("convolve").with("kernel", "sombrero");
    testing::internal::CaptureStdout();
    expectNear(filtered(filter, scene), scene, 0, 0);
    EXPECT_NE(testing::internal::GetCapturedStdout().find("no kernel is called sombrero"),
              std::string::npos);
}

} // namespace
} // namespace candela::filters
