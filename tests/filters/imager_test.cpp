// SPDX-License-Identifier: Apache-2.0
// Imager: what happens to each pixel between exposure and quantisation.
#include "tests/filters/filtered.h"

#include <cmath>

namespace candela::test {

static const std::string colorFile = "Display \"a.exr\" \"openexr\" \"rgba\"\n";

TEST_F(Filtered, backgroundStandsBehindThePicture) {
    render(smallFrame("Imager \"background\" \"color bgcolor\" [.25 .5 1]\nExposure 8 1\n" +
                      colorFile) +
           ballWorld("Surface \"glow\""));
    EXPECT_EQ(at("a.exr", "R", 0, 0), .25f); // Not exposed.
    EXPECT_EQ(at("a.exr", "G", 0, 0), .5f);
    EXPECT_EQ(at("a.exr", "B", 0, 0), 1);
    EXPECT_EQ(at("a.exr", "R", 8, 6), 16); // The ball shines with 2.
    EXPECT_EQ(everywhere("a.exr", "A"), 1);
}

TEST_F(Filtered, imagersMayStandInTheWorld) {
    render(smallFrame(colorFile) +
           ballWorld("Imager \"background\" \"color\" [.25 .5 1]\nSurface \"glow\""));
    EXPECT_EQ(at("a.exr", "R", 0, 0), .25f);
    EXPECT_EQ(at("a.exr", "B", 0, 0), 1);
}

TEST_F(Filtered, colorsAreClampedToAlpha) {
    render(smallFrame("Imager \"clamptoalpha\"\n" + colorFile) + ballWorld("Surface \"glow\""));
    EXPECT_EQ(at("a.exr", "R", 0, 0), 0);
    EXPECT_EQ(at("a.exr", "R", 8, 6), 1); // The ball shines with 2.
}

TEST_F(Filtered, imagersKnowPlaceOpacityAndTime) {
    struct Case {
        const char *options;
        float red, green, blue; ///< At column 2, row 3 of the file.
    };
    const Case table[] = {
        {"", 2.5f, 3.5f, 1},
        {"CropWindow .25 1 .5 1\n", 6.5f, 9.5f, 1}, // Raster space is the frame's.
        {"Imager \"place\" \"scale\" [2]\n", 5, 7, 2},
        {"Imager \"place\" \"string what\" \"Oi\"\n", 1, 1, 1},
        {"Imager \"place\" \"string what\" \"time\"\nShutter 3 3\n", 3, 3, 3},
        {"Imager \"place\" \"what\" \"Ci\" \"scale\" [4]\n", 1, 1, 1},
        {"Imager \"place\" \"string what\" \"NDC\"\n", 2.5f / 16, 3.5f / 12, 1},
        {"Imager \"place\" \"string what\" \"NDC\"\nCropWindow .25 1 .5 1\n", 6.5f / 16, 9.5f / 12,
         1},
        {"Imager \"null\"\n", .25f, .25f, .25f},
    };
    for (const Case &test : table) {
        render(smallFrame("Imager \"place\"\n" + std::string(test.options) + colorFile) +
               plainWorld());
        EXPECT_EQ(at("a.exr", "R", 2, 3), test.red) << test.options;
        EXPECT_EQ(at("a.exr", "G", 2, 3), test.green) << test.options;
        EXPECT_EQ(at("a.exr", "B", 2, 3), test.blue) << test.options;
    }
}

/// Filters, exposure, imager, quantisation, in this order.
TEST_F(Filtered, imagersRunBetweenExposureAndQuantisation) {
    render(smallFrame("PushFilter \"plusone\"\nExposure 2 1\n"
                      "Imager \"place\" \"string what\" \"Ci\" \"scale\" [.04]\n"
                      "Quantize \"rgba\" 100 0 255 0\n" +
                      colorFile + "Display \"+b.png\" \"png\" \"rgb\"\n") +
           plainWorld());
    EXPECT_EQ(everywhere("a.exr", "R"), 10); // 100 * .04 * 2 * (1 + .25)
    EXPECT_EQ(at("b.png", "R", 4, 4), 10 / 255.f);
}

/// What is no number is black, in floats as in whole numbers, and said once.
TEST_F(Filtered, whatImagersMakeIsFinite) {
    const Outcome outcome = run(
        smallFrame("Imager \"unbounded\"\n" + colorFile + "Display \"+b.png\" \"png\" \"rgb\"\n") +
        plainWorld());
    EXPECT_EQ(outcome.status, 0) << outcome.text();
    EXPECT_TRUE(outcome.says("imager \"unbounded\" made are not finite")) << outcome.err;
    EXPECT_EQ(everywhere("a.exr", "R"), 0);
    EXPECT_EQ(everywhere("a.exr", "G"), 0);
    EXPECT_EQ(everywhere("a.exr", "B"), .5f);
    EXPECT_EQ(everywhere("a.exr", "A"), 0);
    EXPECT_EQ(everywhere("b.png", "R"), 0);
}

TEST_F(Filtered, imagersChangeNoRawChannel) {
    const std::string display = "Display \"a.exr\" \"openexr\" \"rgbaz,radiance,Oi,N,variance\"\n";
    const std::vector<std::string> samples{"--spp", "2"};
    render(smallFrame(display) + ballWorld("Surface \"glow\""), samples);
    const Picture plain = read("a.exr");
    render(smallFrame("Imager \"background\" \"bgcolor\" [1 1 1]\n" + display) +
               ballWorld("Surface \"glow\""),
           samples);
    const Picture imaged = read("a.exr");
    for (const PictureChannel &channel : plain.channels)
        if (channel.name.size() > 1 || channel.name == "Z") {
            EXPECT_EQ(imaged.find(channel.name)->values, channel.values) << channel.name;
        }
}

TEST_F(Filtered, anImagerThatIsMissingOrFaultyIsLeftOut) {
    for (const char *name : {"nowhere", "glow"}) {
        const Outcome outcome =
            run(smallFrame("Imager \"" + std::string(name) + "\"\n" + colorFile) + plainWorld());
        EXPECT_EQ(outcome.status, 1) << outcome.text();
        EXPECT_TRUE(outcome.says(name)) << outcome.text();
        EXPECT_EQ(everywhere("a.exr", "R"), .25f);
    }
}

/// A filter has made the picture smaller and left its alpha: pixels of another size cover nothing.
TEST_F(Filtered, imagersRunOnPicturesOfEverySize) {
    run(smallFrame("PushFilter \"smaller\"\nImager \"place\"\n"
                   "Display \"a.exr\" \"openexr\" \"rgb\"\n") +
        plainWorld());
    EXPECT_EQ(read("a.exr").window.columns(), 8);
    EXPECT_EQ(at("a.exr", "R", 7, 5), 7.5f);
    EXPECT_EQ(at("a.exr", "B", 7, 5), 1);
}

/// More pixels than a batch has, the last one not full.
TEST_F(Filtered, imagedPicturesDependOnNoThreadsAndLanes) {
    const std::string rib =
        smallFrame("Format 37 41 1\nImager \"place\"\nExposure 1 2\n" + colorFile) +
        ballWorld("Surface \"glow\"");
    render(rib, {"--threads", "1"});
    const std::string one = folder_.read("a.exr");
    for (const std::vector<std::string> &more :
         std::vector<std::vector<std::string>>{{"--threads", "3"}, {"--lanes", "1"}}) {
        render(rib, more);
        EXPECT_EQ(folder_.read("a.exr"), one);
    }
    for (int y = 0; y < 41; ++y)
        ASSERT_EQ(at("a.exr", "G", 36, y), float(y) + .5f);
}

} // namespace candela::test
