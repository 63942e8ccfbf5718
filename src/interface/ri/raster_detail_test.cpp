// SPDX-License-Identifier: Apache-2.0
#include "interface/ri/raster_detail.h"

#include <cmath>
#include <gtest/gtest.h>

namespace candela {
namespace {

constexpr std::array<float, 6> unitSquare{0, 1, 0, 1, 0, 0};

Options square(bool perspective) {
    Options options;
    options.format.xResolution = options.format.yResolution = 100;
    options.camera.perspective = perspective;
    return options;
}

Matrix4d at(double x, double y, double z) { return translationInDouble(x, y, z); }

TEST(RasterDetail, isAnAreaInPixels) {
    // Two metres of a parallel view are 100 pixels.
    EXPECT_NEAR(rasterDetail(unitSquare, at(0, 0, 5), square(false)), 2500, 1);
    EXPECT_NEAR(rasterDetail(unitSquare, at(70, 0, -5), square(false)), 2500, 1);
    EXPECT_NEAR(rasterDetail(unitSquare, scalingInDouble(-2, 3, 1), square(false)), 15000, 5);
    // 90 degrees: at distance 5 ten metres are.
    EXPECT_NEAR(rasterDetail(unitSquare, at(0, 0, 5), square(true)), 100, .1);
    Options narrow = square(true);
    narrow.camera.fieldOfView = 2 * std::atan(.5f) * 180 / float(M_PI);
    EXPECT_NEAR(rasterDetail(unitSquare, at(0, 0, 5), narrow), 400, .5);
    Options wide = square(false);
    wide.format.xResolution = 200; // Twice as wide a window: as many pixels a metre.
    EXPECT_NEAR(rasterDetail(unitSquare, at(0, 0, 5), wide), 2500, 1);
    EXPECT_NEAR(rasterDetail({0, 1, 0, 1, 0, 1}, at(-.5, -.5, 2), square(true)), 625, 1);
}

TEST(RasterDetail, isInfiniteAroundTheEye) {
    for (const double z : {0.0, -1.0, -.5})
        EXPECT_TRUE(std::isinf(rasterDetail({0, 1, 0, 1, 0, 1}, at(0, 0, z), square(true))));
    EXPECT_EQ(rasterDetail({0, 0, 0, 0, 0, 0}, at(0, 0, 1), square(true)), 0);
}

} // namespace
} // namespace candela
