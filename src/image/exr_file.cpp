// SPDX-License-Identifier: Apache-2.0
#include "image/exr_file.h"

#include <ImfArray.h>
#include <ImfChannelList.h>
#include <ImfCompression.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfMatrixAttribute.h>
#include <ImfOutputFile.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>

#include <cstring>
#include <exception>
#include <stdexcept>

namespace candela {

namespace {

class MemoryOutput : public Imf::OStream {
public:
    MemoryOutput() : Imf::OStream("picture") {}
    std::string bytes;

    void write(const char c[], int n) override {
        if (bytes.size() < position_ + n)
            bytes.resize(position_ + n);
        std::memcpy(bytes.data() + position_, c, n);
        position_ += n;
    }
    std::uint64_t tellp() override { return position_; }
    void seekp(std::uint64_t position) override { position_ = position; }

private:
    std::uint64_t position_ = 0;
};

class MemoryInput : public Imf::IStream {
public:
    explicit MemoryInput(std::string_view bytes) : Imf::IStream("picture"), bytes_(bytes) {}

    bool read(char c[], int n) override {
        if (n < 0 || position_ > bytes_.size() || std::uint64_t(n) > bytes_.size() - position_)
            throw std::runtime_error("the file ends too early");
        std::memcpy(c, bytes_.data() + position_, n);
        position_ += n;
        return position_ < bytes_.size();
    }
    std::uint64_t tellg() override { return position_; }
    void seekg(std::uint64_t position) override { position_ = position; }

private:
    std::string_view bytes_;
    std::uint64_t position_ = 0;
};

Imath::M44f toImath(const Matrix4 &m) {
    Imath::M44f result;
    std::memcpy(&result[0][0], m.m.data(), sizeof(float) * 16);
    return result;
}

Imf::Header makeHeader(const Picture &picture) {
    const FrameWindow &w = picture.window;
    const Imath::Box2i display({0, 0}, {w.width - 1, w.height - 1});
    const Imath::Box2i data({w.x0, w.y0}, {w.x1 - 1, w.y1 - 1});
    Imf::Header header(display, data, picture.pixelAspectRatio);
    header.compression() = Imf::ZIP_COMPRESSION;
    for (const PictureChannel &channel : picture.channels)
        header.channels().insert(channel.name, Imf::Channel(Imf::FLOAT));
    for (const auto &[name, value] : picture.metadata)
        header.insert(name, Imf::StringAttribute(value));
    if (picture.worldToCamera)
        Imf::addWorldToCamera(header, toImath(*picture.worldToCamera));
    if (picture.worldToNdc)
        Imf::addWorldToNDC(header, toImath(*picture.worldToNdc));
    return header;
}

/// Slices count from the frame's origin, so the window's first pixel is moved there.
Imf::Slice sliceOf(const FrameWindow &w, const float *values) {
    const std::size_t row = sizeof(float) * w.columns();
    return Imf::Slice::Make(Imf::FLOAT, values, Imath::V2i(w.x0, w.y0), w.columns(), w.rows(),
                            sizeof(float), row);
}

/// The library makes room for scan lines as soon as it knows their width: it must refuse absurd
/// ones itself. Its limit is for the whole process, and this is its only door.
void limitSizes() {
    constexpr int largestExtent = 1 << 16;
    static const bool limited = [] {
        Imf::Header::setMaxImageSize(largestExtent, largestExtent);
        Imf::Header::setMaxTileSize(largestExtent, largestExtent);
        return true;
    }();
    (void)limited;
}

/// ZIP packs at most 1032 to 1 and the other methods less, so a header that promises more lies
/// and its memory need not be asked for.
void checkPlausible(const Imath::Box2i &data, std::size_t channels, std::size_t fileSize) {
    constexpr double largestPacking = 4 * 1040;
    const double columns = double(data.max.x) - data.min.x + 1;
    const double rows = double(data.max.y) - data.min.y + 1;
    if (columns < 1 || rows < 1 || channels == 0)
        throw std::runtime_error("it holds no pixels");
    if (columns * rows * double(channels) > largestValueCount)
        throw std::runtime_error("it is too large to be read");
    if (columns * rows * double(channels) > largestPacking * double(fileSize))
        throw std::runtime_error("it is damaged: it claims more pixels than it can hold");
}

void readAttributes(const Imf::Header &header, Picture &picture) {
    for (auto it = header.begin(); it != header.end(); ++it)
        if (const auto *text = dynamic_cast<const Imf::StringAttribute *>(&it.attribute()))
            picture.metadata[it.name()] = text->value();
    const auto matrix = [&](const char *name) -> std::optional<Matrix4> {
        const auto *found = header.findTypedAttribute<Imf::M44fAttribute>(name);
        if (!found)
            return std::nullopt;
        Matrix4 m;
        std::memcpy(m.m.data(), &found->value()[0][0], sizeof(float) * 16);
        return m;
    };
    picture.worldToCamera = matrix("worldToCamera");
    picture.worldToNdc = matrix("worldToNDC");
}

Picture readPixels(Imf::InputFile &file, std::size_t fileSize) {
    const Imf::Header &header = file.header();
    const Imath::Box2i data = header.dataWindow(), display = header.displayWindow();
    std::size_t count = 0;
    for (auto it = header.channels().begin(); it != header.channels().end(); ++it, ++count)
        if (it.channel().xSampling != 1 || it.channel().ySampling != 1)
            throw std::runtime_error("subsampled channels are not supported");
    checkPlausible(data, count, fileSize);
    Picture picture;
    picture.window = {display.max.x + 1, display.max.y + 1, data.min.x,
                      data.max.x + 1,    data.min.y,        data.max.y + 1};
    picture.pixelAspectRatio = header.pixelAspectRatio();
    readAttributes(header, picture);
    for (auto it = header.channels().begin(); it != header.channels().end(); ++it)
        picture.channels.push_back({it.name(), std::vector<float>(picture.window.pixels())});
    Imf::FrameBuffer frame;
    for (PictureChannel &channel : picture.channels)
        frame.insert(channel.name, sliceOf(picture.window, channel.values.data()));
    file.setFrameBuffer(frame);
    file.readPixels(data.min.y, data.max.y);
    return picture;
}

} // namespace

std::optional<std::string> encodeExr(const Picture &picture, std::string &problem) {
    try {
        MemoryOutput output;
        {
            Imf::OutputFile file(output, makeHeader(picture), 0);
            Imf::FrameBuffer frame;
            for (const PictureChannel &channel : picture.channels)
                frame.insert(channel.name, sliceOf(picture.window, channel.values.data()));
            file.setFrameBuffer(frame);
            file.writePixels(picture.window.rows());
        }
        return std::move(output.bytes);
    } catch (const std::exception &error) {
        problem = std::string("cannot encode as OpenEXR: ") + error.what();
        return std::nullopt;
    }
}

std::optional<Picture> decodeExr(std::string_view bytes, std::string &problem) {
    try {
        limitSizes();
        MemoryInput input(bytes);
        Imf::InputFile file(input, 0);
        if (!file.isComplete())
            throw std::runtime_error("the file is not complete");
        return readPixels(file, bytes.size());
    } catch (const std::exception &error) {
        problem = std::string("not a readable OpenEXR picture: ") + error.what();
        return std::nullopt;
    }
}

bool looksLikeExr(std::string_view bytes) { return bytes.starts_with("\x76\x2f\x31\x01"); }

} // namespace candela
