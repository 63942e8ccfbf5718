// SPDX-License-Identifier: Apache-2.0
// What one frame renders is light again in the next, whatever file it went through.
#include "tests/textures/pictures.h"

#include <gtest/gtest.h>

namespace candela::test {
namespace {

struct Passage {
    const char *file, *type;
    float within; ///< Of the file's numbers.
};
const Passage passages[] = {{"pass.exr", "openexr", 1e-3f}, {"pass.tif", "tiff", .006f},
                            {"pass", "file", 1e-3f},        {"pass.tif", "file", .006f},
                            {"pass.env", "file", .006f},    {"pass.png", "png", .006f},
                            {"pass.hdr", "hdr", .01f}};

/// Requests that make a picture of (1, .5, .25) by way of the file.
std::string passThrough(const Passage &passage, const std::string &options) {
    return "FrameBegin 1\nFormat 8 8 1\nProjection \"orthographic\"\n" + options + "Display \"" +
           passage.file + "\" \"" + passage.type +
           "\" \"rgb\"\nWorldBegin\nSurface \"constant\"\nColor [1 .5 .25]\n"
           "Polygon \"P\" [-9 -9 1  -9 9 1  9 9 1  9 -9 1]\nWorldEnd\nFrameEnd\n"
           "MakeTexture \"" +
           passage.file + "\" \"made.tx\" \"clamp\" \"clamp\" \"box\" 1 1\n";
}

TEST(RenderedPictures, AreLightAgain) {
    struct {
        const char *options;
        bool ofFloats; ///< Floats are what Quantize and a gamma make of them: no light.
    } const cases[] = {{"", true},
                       {"Exposure 1 1\n", true},
                       {"Quantize \"rgba\" 255 0 255 0\n", false},
                       {"Quantize \"rgba\" 65535 0 65535 0\n", false},
                       {"Exposure 1 2.2\nQuantize \"rgba\" 255 0 255 0\n", false}};
    for (const Passage &passage : passages)
        for (const auto &each : cases) {
            const std::string name = passage.file;
            const bool isWhole =
                name.ends_with(".tif") || name.ends_with(".png") || name.ends_with(".env");
            if (!each.ofFloats && !isWhole)
                continue;
            ScratchFolder folder;
            std::vector<std::string> lookups;
            for (const std::string &file : {name, std::string("made.tx")})
                for (const char *channel : {"0", "1", "2"})
                    lookups.push_back("float texture(\"" + file + "\"[" + channel + "])");
            const Told told = tell(folder, {lookups, "", passThrough(passage, each.options)});
            EXPECT_EQ(told.run.status, 0) << told.run.text();
            ASSERT_EQ(told.values.size(), lookups.size()) << told.run.text();
            const float light[] = {1, .5f, .25f};
            for (std::size_t k = 0; k < lookups.size(); ++k)
                EXPECT_NEAR(told.values[k], light[k % 3], passage.within)
                    << lookups[k] << passage.type << each.options;
        }
}

} // namespace
} // namespace candela::test
