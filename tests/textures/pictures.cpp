// SPDX-License-Identifier: Apache-2.0
#include "tests/textures/pictures.h"

#include "image/exr_file.h"
#include "image/png_file.h"

#include <gtest/gtest.h>
#include <sstream>

namespace candela::test {

void writeExr(const ScratchFolder &folder, const std::string &name, int width, int height,
              const std::vector<std::string> &channels, const Pixels &pixels) {
    Picture picture;
    picture.window = {width, height, 0, width, 0, height};
    for (int c = 0; c < int(channels.size()); ++c) {
        PictureChannel channel{channels[std::size_t(c)], {}};
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                channel.values.push_back(pixels(x, y, c));
        picture.channels.push_back(std::move(channel));
    }
    std::string problem;
    const auto bytes = encodeExr(picture, problem);
    ASSERT_TRUE(bytes) << problem;
    folder.write(name, *bytes);
}

void writeEightBit(const ScratchFolder &folder, const std::string &name, int width, int height,
                   int channels, const Pixels &pixels) {
    std::string bytes(18, '\0');
    bytes[2] = channels == 1 ? 3 : 2;
    bytes[12] = char(width), bytes[13] = char(width >> 8);
    bytes[14] = char(height), bytes[15] = char(height >> 8);
    bytes[16] = char(8 * channels), bytes[17] = 0x20; // From the top.
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int c = channels - 1; c >= 0; --c) // Blue comes first.
                bytes += char(int(pixels(x, y, c)));
    folder.write(name, bytes);
}

void writeSixteenBit(const ScratchFolder &folder, const std::string &name, int width, int height,
                     std::optional<float> gamma, const Pixels &pixels) {
    Picture picture;
    picture.window = {width, height, 0, width, 0, height};
    for (int c = 0; c < 3; ++c) {
        PictureChannel channel{std::string(1, "RGB"[c]), {}};
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                channel.values.push_back(pixels(x, y, c));
        picture.channels.push_back(std::move(channel));
    }
    std::string problem;
    auto bytes = encodePng(picture, 16, gamma.value_or(1), problem);
    ASSERT_TRUE(bytes) << problem;
    if (const auto chunk = bytes->find("gAMA"); !gamma && chunk != std::string::npos)
        bytes->erase(chunk - 4, 16); // Length, type, four bytes, checksum.
    folder.write(name, *bytes);
}

Told tell(const ScratchFolder &folder, const Telling &telling) {
    std::string source = "surface telling() {\n" + telling.before + "\n";
    // A pixel's neighbours are shaded with it, and tell the same.
    for (std::size_t k = 0; k < telling.expressions.size(); ++k)
        source +=
            "printf(\"told" + std::to_string(k) + " %f\\n\", " + telling.expressions[k] + ");\n";
    folder.write("telling.sl", source + "Ci = 0; Oi = 1; }\n");
    const std::string scene = folder.write(
        "scene.rib", telling.requests +
                         "\nFormat 1 1 1 PixelSamples 1 1 PixelFilter \"box\" 1 1\n"
                         "Display \"telling.exr\" \"openexr\" \"rgb\"\n"
                         "Projection \"orthographic\" ScreenWindow -.001 .001 -.001 .001\n"
                         "WorldBegin Surface \"telling\" Translate 0 0 2\n"
                         "Patch \"bilinear\" \"P\" [-1 1 0  1 1 0  -1 -1 0  1 -1 0]\nWorldEnd\n");
    Told told;
    told.run = runCandela({"--quiet", "--lanes", telling.lanes, "--integrator", telling.integrator,
                           "--output-dir", folder.path(), scene});
    std::istringstream lines(told.run.out);
    for (std::string word; lines >> word;)
        if (float value = 0; word == "told" + std::to_string(told.values.size()) && lines >> value)
            told.values.push_back(value);
    return told;
}

} // namespace candela::test
