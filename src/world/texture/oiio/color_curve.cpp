// SPDX-License-Identifier: Apache-2.0
#include "world/texture/oiio/color_curve.h"

#include <OpenImageIO/strutil.h>

#include <cmath>
#include <fstream>
#include <locale>
#include <optional>
#include <sstream>
#include <string_view>

namespace candela {

float ColorCurve::light(float value) const {
    if (!srgb)
        return value > 0 ? std::pow(value, gamma) : 0;
    return value <= 0.04045f ? value / 12.92f : std::pow((value + 0.055f) / 1.055f, 2.4f);
}

namespace {

/// OpenImageIO calls PNG files sRGB that say nothing; chunks before the pixels say what is true.
bool pngSaysColors(const std::string &path) {
    std::ifstream file(path, std::ios::binary);
    file.ignore(8); // The signature. Chunks: length, type, data, checksum.
    for (unsigned char head[8]; file.read(reinterpret_cast<char *>(head), 8);) {
        const std::string_view type(reinterpret_cast<const char *>(head) + 4, 4);
        if (type == "sRGB" || type == "gAMA" || type == "iCCP")
            return true;
        if (type == "IDAT")
            return false;
        const unsigned length = unsigned(head[0]) << 24 | unsigned(head[1]) << 16 |
                                unsigned(head[2]) << 8 | unsigned(head[3]);
        file.ignore(std::streamsize(length) + 4);
    }
    return false;
}

/// What Candela writes of its pictures (image/displays.cpp): "...; exposure: GAIN GAMMA; ...". Its
/// whole numbers are light^(1/GAMMA). Nothing of other files.
std::optional<float> gammaOfOwn(const OIIO::ImageSpec &spec) {
    constexpr std::string_view word = "exposure: ";
    const std::string said = spec.get_string_attribute("ImageDescription");
    const std::size_t at = said.find(word);
    if (spec.get_string_attribute("Software") != "Candela" || at == std::string::npos)
        return std::nullopt;
    std::istringstream numbers(said.substr(at + word.size()));
    numbers.imbue(std::locale::classic());
    float gain = 0, gamma = 0;
    if (!(numbers >> gain >> gamma) || !(gamma > 0))
        return std::nullopt;
    return gamma;
}

} // namespace

ColorCurve curveOf(const OIIO::ImageInput &file, const std::string &path, PictureCurve told) {
    const OIIO::ImageSpec &spec = file.spec();
    if (told == PictureCurve::Srgb)
        return {true, 1};
    if (told == PictureCurve::Linear || spec.format.is_floating_point() || spec.nchannels < 3)
        return {};
    if (const std::optional<float> gamma = gammaOfOwn(spec))
        return {false, *gamma};
    const bool eightBits = spec.format == OIIO::TypeDesc::UINT8;
    if (!eightBits && std::string_view(file.format_name()) == "png" && !pngSaysColors(path))
        return {};
    const std::string space = spec.get_string_attribute("oiio:ColorSpace");
    if (OIIO::Strutil::istarts_with(space, "Gamma")) // "GammaCorrected2.2", too.
        return {false, spec.get_float_attribute("oiio:Gamma", 2.2f)};
    if (OIIO::Strutil::iequals(space, "Linear") || OIIO::Strutil::iequals(space, "scene_linear"))
        return {};
    const bool isSrgb = OIIO::Strutil::icontains(space, "srgb");
    return {isSrgb || eightBits, 1};
}

void makeLinear(const ColorCurve &curve, const OIIO::ImageSpec &spec, int pixels, float *values) {
    const int channels = spec.nchannels, alpha = spec.alpha_channel;
    const bool multiplies = alpha >= 0 && spec.get_int_attribute("oiio:UnassociatedAlpha") != 0;
    for (int i = 0; i < pixels; ++i, values += channels)
        for (int c = 0; c < channels; ++c)
            if (c != alpha)
                values[c] = curve.light(values[c]) * (multiplies ? values[alpha] : 1);
}

} // namespace candela
