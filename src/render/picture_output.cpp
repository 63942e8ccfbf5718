// SPDX-License-Identifier: Apache-2.0
#include "render/picture_output.h"

#include "foundation/base/letters.h"
#include "foundation/base/whole_file.h"
#include "image/exr_file.h"
#include "image/imaging.h"
#include "image/png_file.h"

#include <filesystem>

namespace candela {

namespace {

void expose(Picture &picture, const std::array<float, 2> &exposure) {
    for (PictureChannel &channel : picture.channels)
        if (isColorChannel(channel.name))
            for (float &value : channel.values)
                value = exposed(value, {exposure[0], exposure[1]});
}

/// Colors of what covers the pixels: before the exposure, which is not linear.
void separateAlpha(Picture &picture) {
    const PictureChannel *const alpha = picture.find("A");
    for (PictureChannel &channel : picture.channels)
        for (std::size_t i = 0; alpha && isColorChannel(channel.name) && i < channel.values.size();
             ++i)
            channel.values[i] = straightColor(channel.values[i], alpha->values[i]);
}

/// Whole numbers of R, G, B and alpha, and what else is there left out.
std::optional<std::string> pngBytes(const Picture &picture,
                                    const std::optional<std::array<float, 2>> &exposure,
                                    std::string &problem) {
    Picture shown = picture;
    shown.channels.clear();
    for (const char *name : {"R", "G", "B", "A"})
        if (const PictureChannel *channel = picture.find(name))
            shown.channels.push_back(*channel);
    const FrameWindow &w = shown.window;
    for (int c = 0; c < int(shown.channels.size()); ++c) {
        PictureChannel &channel = shown.channels[c];
        for (std::size_t i = 0; i < channel.values.size(); ++i) {
            float &value = channel.values[i];
            if (!exposure && !picture.hasDisplayValues && isColorChannel(channel.name))
                value = srgbCurve(value);
            const int x = w.x0 + int(i % w.columns()), y = w.y0 + int(i / w.columns());
            value = quantized(value, eightBitQuantize, ditherNoise(x, y, c));
        }
    }
    const auto gamma = exposure ? std::optional((*exposure)[1]) : std::nullopt;
    return encodePng(shown, 8, gamma, problem);
}

} // namespace

bool isPngName(const std::string &path) {
    return inSmallLetters(std::filesystem::path(path).extension().string()) == ".png";
}

bool isColorChannel(const std::string &channel) {
    return channel == "R" || channel == "G" || channel == "B";
}

bool writePicture(Picture &picture, const std::string &path,
                  const std::optional<std::array<float, 2>> &exposure, std::string &problem) {
    if (isPngName(path) && !picture.hasDisplayValues)
        separateAlpha(picture);
    if (exposure)
        expose(picture, *exposure);
    const auto bytes =
        isPngName(path) ? pngBytes(picture, exposure, problem) : encodeExr(picture, problem);
    return bytes && writeWholeFile(path, *bytes, problem);
}

} // namespace candela
