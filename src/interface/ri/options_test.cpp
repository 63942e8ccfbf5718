// SPDX-License-Identifier: Apache-2.0
// The numbers of RI 3.2, section 4.1.1: windows, aspect ratios, crops.
#include "interface/ri/options.h"

#include <gtest/gtest.h>

namespace candela {

static FrameFormat withFormat(int x, int y, float aspect) {
    FrameFormat format;
    format.xResolution = x;
    format.yResolution = y;
    format.pixelAspectRatio = aspect;
    return format;
}

TEST(FrameFormat, defaultScreenWindowFollowsTheFormat) {
    EXPECT_EQ(withFormat(640, 480, 1).effectiveScreenWindow(),
              (std::array<float, 4>{-640 / 480.f, 640 / 480.f, -1, 1}));
    EXPECT_EQ(withFormat(100, 200, 1).effectiveScreenWindow(),
              (std::array<float, 4>{-1, 1, -2, 2}));
    EXPECT_EQ(withFormat(100, 100, 2).effectiveScreenWindow(),
              (std::array<float, 4>{-2, 2, -1, 1}));
}

TEST(FrameFormat, givenScreenWindowStands) {
    FrameFormat format = withFormat(640, 480, 1);
    format.screenWindow = {-3, 1, -2, 5};
    EXPECT_EQ(format.effectiveScreenWindow(), (std::array<float, 4>{-3, 1, -2, 5}));
}

TEST(FrameFormat, frameAspectRatioShrinksThePictureIntoTheFormat) {
    FrameFormat format = withFormat(512, 512, 1);
    format.frameAspectRatio = 2;
    EXPECT_EQ(format.effectiveResolution(), (std::array{512, 256}));
    EXPECT_EQ(format.effectiveScreenWindow(), (std::array<float, 4>{-2, 2, -1, 1}));
    format.frameAspectRatio = 0.5f;
    EXPECT_EQ(format.effectiveResolution(), (std::array{256, 512}));
    EXPECT_EQ(format.effectiveScreenWindow(), (std::array<float, 4>{-1, 1, -2, 2}));
    format.frameAspectRatio = 1;
    EXPECT_EQ(format.effectiveResolution(), (std::array{512, 512}));
    format.pixelAspectRatio = 2; // The format is 2:1 now; the square frame loses columns.
    EXPECT_EQ(format.effectiveResolution(), (std::array{256, 512}));
}

TEST(FrameFormat, cropPixelsAreRoundedUp) {
    FrameFormat format = withFormat(640, 480, 1);
    EXPECT_EQ(format.cropPixels(), (std::array{0, 640, 0, 480}));
    format.cropWindow = {0.1f, 0.5f, 0.25f, 0.7f};
    EXPECT_EQ(format.cropPixels(), (std::array{64, 320, 120, 336}));
    format.cropWindow = {0.001f, 1, 0, 0.001f};
    EXPECT_EQ(format.cropPixels(), (std::array{1, 640, 0, 1}));
    for (int hundredths = 0; hundredths <= 100; ++hundredths) { // Whatever float makes of them.
        FrameFormat square = withFormat(100, 1000, 1);
        square.cropWindow = {float(hundredths) / 100, 1, float(hundredths / 100.0), 1};
        EXPECT_EQ(square.cropPixels(), (std::array{hundredths, 100, 10 * hundredths, 1000}));
    }
}

TEST(FrameFormat, cropTilesJoinWithoutGapOrOverlap) {
    for (int width : {1, 7, 101, 640, 1999})
        for (int tiles = 1; tiles < 60; ++tiles) {
            int next = 0;
            for (int tile = 0; tile < tiles; ++tile) {
                FrameFormat format = withFormat(width, 10, 1);
                format.cropWindow = {float(tile) / tiles, float(tile + 1) / tiles, 0, 1};
                auto [x0, x1, y0, y1] = format.cropPixels();
                ASSERT_EQ(x0, next) << width << " " << tiles;
                ASSERT_LE(x0, x1);
                next = x1;
            }
            ASSERT_EQ(next, width);
        }
}

TEST(NamedParameters, valuesHaveFallbacks) {
    NamedParameters options;
    options["render:integrator"] = {"integrator", {}, {}, {"path"}};
    options["trace:maxdepth"] = {"maxdepth", {}, {7}, {}};
    EXPECT_EQ(options.string("render:integrator", "classic"), "path");
    EXPECT_EQ(options.string("render:other", "classic"), "classic");
    EXPECT_EQ(options.number("trace:maxdepth", 64), 7);
    EXPECT_EQ(options.number("render:integrator", 3), 3);
}

} // namespace candela
