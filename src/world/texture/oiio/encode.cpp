// SPDX-License-Identifier: Apache-2.0
#include "world/texture/oiio/encode.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace candela {

namespace {

using Format = PictureToEncode::Format;
using Numbers = PictureToEncode::Numbers;

OIIO::TypeDesc typeOf(Numbers numbers) {
    switch (numbers) {
    case Numbers::Bytes: return OIIO::TypeDesc::UINT8;
    case Numbers::Words: return OIIO::TypeDesc::UINT16;
    case Numbers::Floats: break;
    }
    return OIIO::TypeDesc::FLOAT;
}

/// Whole numbers as they are: OpenImageIO's own conversion would take them for shares of one.
template <class Number>
std::vector<Number> wholeNumbers(const std::vector<float> &values, float largest) {
    std::vector<Number> numbers;
    numbers.reserve(values.size());
    for (float value : values) // NaN becomes 0.
        numbers.push_back(value > 0 ? Number(std::min(value, largest) + 0.5f) : Number(0));
    return numbers;
}

bool writeValues(OIIO::ImageOutput &file, const PictureToEncode &picture) {
    switch (picture.numbers) {
    case Numbers::Bytes: {
        const auto bytes = wholeNumbers<std::uint8_t>(picture.values, 255);
        return file.write_image(OIIO::TypeDesc::UINT8, bytes.data());
    }
    case Numbers::Words: {
        const auto words = wholeNumbers<std::uint16_t>(picture.values, 65535);
        return file.write_image(OIIO::TypeDesc::UINT16, words.data());
    }
    case Numbers::Floats: break;
    }
    return file.write_image(OIIO::TypeDesc::FLOAT, picture.values.data());
}

OIIO::ImageSpec specOf(const PictureToEncode &picture) {
    OIIO::ImageSpec spec(picture.width, picture.height, int(picture.channels.size()),
                         typeOf(picture.numbers));
    spec.channelnames = picture.channels;
    const auto alpha = std::ranges::find(picture.channels, "A");
    if (alpha != picture.channels.end())
        spec.alpha_channel = int(alpha - picture.channels.begin());
    spec.attribute("ImageDescription", picture.description);
    spec.attribute("Software", "Candela");
    spec.attribute("compression", "zip");
    if (picture.numbers == Numbers::Floats)
        spec.attribute("oiio:ColorSpace", "Linear");
    return spec;
}

} // namespace

bool encodePicture(const PictureToEncode &picture, std::string &bytes, std::string &problem) {
    const char *const name = picture.format == Format::Tiff ? "tiff" : "hdr";
    std::vector<unsigned char> buffer;
    OIIO::Filesystem::IOVecOutput memory(buffer);
    auto file = OIIO::ImageOutput::create(name);
    const bool good = file && file->set_ioproxy(&memory) &&
                      file->open(std::string("picture.") + name, specOf(picture)) &&
                      writeValues(*file, picture) && file->close();
    if (!good) {
        problem = file ? file->geterror() : OIIO::geterror();
        return false;
    }
    bytes.assign(buffer.begin(), buffer.end());
    return true;
}

} // namespace candela
