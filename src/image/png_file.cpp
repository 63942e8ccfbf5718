// SPDX-License-Identifier: Apache-2.0
#include "image/png_file.h"

#include "image/imaging.h"

#include <png.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace candela {

namespace {

/// What libpng's callbacks share. libpng leaves by longjmp, so whatever owns memory lives in the
/// callers of the functions that call setjmp, and these declare nothing with a destructor.
struct Writing {
    std::string bytes;
    std::string message;
};

struct Reading {
    std::string_view bytes;
    std::size_t position = 0;
    std::string message;
    png_uint_32 width = 0, height = 0;
    int colorType = 0, bits = 0;
    bool isLight = false; ///< The file says gamma 1.
    std::vector<png_byte> pixels;
    std::vector<png_bytep> rows;
    std::map<std::string, std::string> texts;
};

void keepMessage(png_structp png, png_const_charp text) {
    *static_cast<std::string *>(png_get_error_ptr(png)) = text;
    png_longjmp(png, 1);
}

void ignoreWarning(png_structp, png_const_charp) {}

void appendBytes(png_structp png, png_bytep data, std::size_t size) {
    static_cast<Writing *>(png_get_io_ptr(png))->bytes.append(reinterpret_cast<char *>(data), size);
}

void noFlush(png_structp) {}

void takeBytes(png_structp png, png_bytep data, std::size_t size) {
    auto &reading = *static_cast<Reading *>(png_get_io_ptr(png));
    if (size > reading.bytes.size() - reading.position)
        png_error(png, "the file ends too early");
    std::memcpy(data, reading.bytes.data() + reading.position, size);
    reading.position += size;
}

struct Layout {
    int columns, rows, bits, colorType;
    std::optional<float> gamma; ///< Of the values; none: the curve of sRGB.
};

bool writeStructure(png_structp png, png_infop info, const Layout &layout,
                    std::vector<png_text> &texts, std::vector<png_bytep> &rows) {
    if (setjmp(png_jmpbuf(png)))
        return false;
    png_set_IHDR(png, info, layout.columns, layout.rows, layout.bits, layout.colorType,
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    if (layout.gamma)
        png_set_gAMA_fixed(png, info, png_fixed_point(std::lround(1e5 / *layout.gamma)));
    else
        png_set_sRGB_gAMA_and_cHRM(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
    png_set_text(png, info, texts.data(), int(texts.size()));
    png_write_info(png, info);
    png_write_image(png, rows.data());
    png_write_end(png, nullptr);
    return true;
}

/// Rows of big-endian samples, channels interleaved.
std::vector<png_byte> packPixels(const Picture &picture, int bits) {
    const std::size_t pixels = picture.window.pixels(), channels = picture.channels.size();
    const float largest = bits == 16 ? 65535.0f : 255.0f;
    std::vector<png_byte> packed;
    packed.reserve(pixels * channels * bits / 8);
    for (std::size_t i = 0; i < pixels; ++i)
        for (const PictureChannel &channel : picture.channels) {
            const float value = channel.values[i];
            const int whole = value > 0 ? int(std::min(value, largest) + 0.5f) : 0;
            if (bits == 16)
                packed.push_back(png_byte(whole >> 8));
            packed.push_back(png_byte(whole & 255));
        }
    return packed;
}

std::vector<png_text> textsOf(const Picture &picture) {
    std::vector<png_text> texts;
    for (const auto &[key, value] : picture.metadata) {
        if (key.empty() || key.size() > 79)
            continue; // PNG allows no such keyword.
        png_text text{};
        text.compression = PNG_TEXT_COMPRESSION_NONE;
        text.key = const_cast<char *>(key.c_str());
        text.text = const_cast<char *>(value.c_str());
        text.text_length = value.size();
        texts.push_back(text);
    }
    return texts;
}

bool readHeader(png_structp png, png_infop info, Reading &reading) {
    if (setjmp(png_jmpbuf(png)))
        return false;
    png_read_info(png, info);
    png_set_expand(png); // Palettes, few bits and transparency entries become plain samples.
    png_set_interlace_handling(png);
    png_read_update_info(png, info);
    reading.width = png_get_image_width(png, info);
    reading.height = png_get_image_height(png, info);
    reading.colorType = png_get_color_type(png, info);
    reading.bits = png_get_bit_depth(png, info);
    double gamma = 0;
    int intent = 0;
    reading.isLight = !png_get_sRGB(png, info, &intent) && png_get_gAMA(png, info, &gamma) &&
                      std::abs(gamma - 1) < .01;
    if (double(reading.width) * reading.height * png_get_channels(png, info) > largestValueCount)
        png_error(png, "it is too large to be read");
    // Deflate packs at most 1032 to 1: a header that promises more lies.
    if (double(png_get_rowbytes(png, info)) * reading.height > 8 * 1040.0 * reading.bytes.size())
        png_error(png, "it claims more pixels than it can hold");
    return true;
}

bool readBody(png_structp png, png_infop info, Reading &reading) {
    if (setjmp(png_jmpbuf(png)))
        return false;
    png_read_image(png, reading.rows.data());
    png_read_end(png, info);
    return true;
}

void keepTexts(png_structp png, png_infop info, Reading &reading) {
    png_textp texts = nullptr;
    const int count = png_get_text(png, info, &texts, nullptr);
    for (int i = 0; i < count; ++i)
        if (texts[i].compression <= PNG_TEXT_COMPRESSION_zTXt)
            reading.texts[texts[i].key].assign(texts[i].text, texts[i].text_length);
}

bool readAll(png_structp png, png_infop info, Reading &reading) {
    if (!readHeader(png, info, reading))
        return false;
    const std::size_t rowBytes = png_get_rowbytes(png, info);
    reading.pixels.resize(rowBytes * reading.height);
    for (png_uint_32 y = 0; y < reading.height; ++y)
        reading.rows.push_back(reading.pixels.data() + y * rowBytes);
    if (!readBody(png, info, reading))
        return false;
    keepTexts(png, info, reading);
    return true;
}

/// Light is that of whole pixels, not of what covers them.
void spreadOverPixels(Picture &picture) {
    const std::vector<float> &alpha = picture.channels.back().values;
    for (std::size_t c = 0; c + 1 < picture.channels.size(); ++c)
        for (std::size_t i = 0; i < alpha.size(); ++i)
            picture.channels[c].values[i] = wholeColor(picture.channels[c].values[i], alpha[i]);
}

Picture unpack(const Reading &reading) {
    const bool color = reading.colorType & PNG_COLOR_MASK_COLOR;
    const bool alpha = reading.colorType & PNG_COLOR_MASK_ALPHA;
    std::vector<std::string> names =
        color ? std::vector<std::string>{"R", "G", "B"} : std::vector<std::string>{"Y"};
    if (alpha)
        names.push_back("A");
    const int width = int(reading.width), height = int(reading.height);
    Picture picture;
    picture.window = {width, height, 0, width, 0, height};
    picture.metadata = reading.texts;
    picture.hasDisplayValues = !reading.isLight;
    const png_byte *at = reading.pixels.data();
    for (const std::string &name : names)
        picture.channels.push_back({name, std::vector<float>(picture.window.pixels())});
    for (std::size_t i = 0; i < picture.window.pixels(); ++i)
        for (PictureChannel &channel : picture.channels) {
            const int high = *at++;
            channel.values[i] =
                reading.bits == 16 ? float((high << 8) + *at++) / 65535.0f : float(high) / 255.0f;
        }
    if (reading.isLight && alpha)
        spreadOverPixels(picture);
    return picture;
}

} // namespace

std::optional<std::string> encodePng(const Picture &picture, int bits, std::optional<float> gamma,
                                     std::string &problem) {
    constexpr int colorTypes[] = {PNG_COLOR_TYPE_GRAY, PNG_COLOR_TYPE_GRAY_ALPHA,
                                  PNG_COLOR_TYPE_RGB, PNG_COLOR_TYPE_RGB_ALPHA};
    const std::size_t channels = picture.channels.size();
    if (channels < 1 || channels > 4 || picture.window.pixels() == 0) {
        problem = "a PNG picture has 1 to 4 channels, not " + std::to_string(channels);
        return std::nullopt;
    }
    Writing writing;
    std::vector<png_byte> pixels = packPixels(picture, bits);
    std::vector<png_bytep> rows;
    for (int y = 0; y < picture.window.rows(); ++y)
        rows.push_back(pixels.data() + pixels.size() / picture.window.rows() * y);
    std::vector<png_text> texts = textsOf(picture);
    const Layout layout{picture.window.columns(), picture.window.rows(), bits,
                        colorTypes[channels - 1], gamma};

    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &writing.message, keepMessage,
                                              ignoreWarning);
    png_infop info = png ? png_create_info_struct(png) : nullptr;
    if (info)
        png_set_write_fn(png, &writing, appendBytes, noFlush);
    const bool done = info && writeStructure(png, info, layout, texts, rows);
    png_destroy_write_struct(&png, &info);
    if (done)
        return std::move(writing.bytes);
    problem = "cannot encode as PNG: " + writing.message;
    return std::nullopt;
}

std::optional<Picture> decodePng(std::string_view bytes, std::string &problem) {
    Reading reading;
    reading.bytes = bytes;
    png_structp png =
        png_create_read_struct(PNG_LIBPNG_VER_STRING, &reading.message, keepMessage, ignoreWarning);
    png_infop info = png ? png_create_info_struct(png) : nullptr;
    if (info)
        png_set_read_fn(png, &reading, takeBytes);
    const bool done = info && readAll(png, info, reading);
    png_destroy_read_struct(&png, &info, nullptr);
    if (done)
        return unpack(reading);
    problem = "not a readable PNG picture: " + reading.message;
    return std::nullopt;
}

bool looksLikePng(std::string_view bytes) { return bytes.starts_with("\x89PNG\r\n\x1a\n"); }

} // namespace candela
