// SPDX-License-Identifier: Apache-2.0
#include "world/shading/shader_answers.h"

#include <gtest/gtest.h>

namespace candela {
namespace {

using Numbers = std::vector<float>;

TEST(ShaderAnswers, OptionsOfRequestsByName) {
    Options options;
    options.format.xResolution = 320, options.format.yResolution = 200;
    options.format.pixelAspectRatio = 1.25f;
    options.format.cropWindow = {0.1f, 0.5f, 0.2f, 0.75f};
    options.camera.shutterOpen = 0.25f, options.camera.shutterClose = 0.5f;
    options.camera.fStop = 2.8f, options.camera.focalLength = 0.05f;
    options.camera.focalDistance = 3;
    for (const std::string prefix : {"", "Ri:"}) {
        const auto value = [&](const char *name, const char *type) {
            return optionValue(options, prefix + name, type);
        };
        EXPECT_EQ(value("Format", "float[3]"), (Numbers{320, 200, 1.25f}));
        EXPECT_EQ(value("FrameAspectRatio", "float"), Numbers{2});
        EXPECT_EQ(value("CropWindow", "float[4]"), (Numbers{0.1f, 0.5f, 0.2f, 0.75f}));
        EXPECT_EQ(value("Shutter", "float[2]"), (Numbers{0.25f, 0.5f}));
        EXPECT_EQ(value("DepthOfField", "float[3]"), (Numbers{2.8f, 0.05f, 3}));
    }
    // Made smaller to fit the frame.
    options.format.frameAspectRatio = 1;
    EXPECT_EQ(optionValue(options, "DeviceResolution", "float[3]"), (Numbers{160, 200, 1.25f}));
    EXPECT_EQ(optionValue(options, "FrameAspectRatio", "float"), Numbers{1});
}

TEST(ShaderAnswers, NamedOptionsAndWhatDoesNotFit) {
    Options options;
    options.named["user:gain"] = {"gain", {StorageClass::Uniform, ValueType::Float, 1}, {2.5f}, {}};
    options.named["user:steps"] = {
        "steps", {StorageClass::Uniform, ValueType::Integer, 2}, {3, 4}, {}};
    options.named["user:tint"] = {
        "tint", {StorageClass::Uniform, ValueType::Color, 1}, {0.1f, 0.2f, 0.3f}, {}};
    options.named["user:name"] = {"name", {StorageClass::Uniform, ValueType::String, 1}, {}, {"a"}};
    EXPECT_EQ(optionValue(options, "user:gain", "float"), Numbers{2.5f});
    EXPECT_EQ(optionValue(options, "user:steps", "float[2]"), (Numbers{3, 4}));
    EXPECT_EQ(optionValue(options, "user:tint", "color"), (Numbers{0.1f, 0.2f, 0.3f}));
    for (auto [name, type] : {std::pair("user:gain", "float[2]"),
                              {"user:gain", "color"},
                              {"user:tint", "float[3]"},
                              {"user:tint", "point"},
                              {"user:name", "float"},
                              {"user:nothing", "float"},
                              {"Format", "float"},
                              {"Format", "color"},
                              {"", "float"}})
        EXPECT_TRUE(optionValue(options, name, type).empty()) << name << " as " << type;
}

} // namespace
} // namespace candela
