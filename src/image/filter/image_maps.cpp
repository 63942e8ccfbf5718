// SPDX-License-Identifier: Apache-2.0
#include "image/filter/image_maps.h"

#include "foundation/base/planes.h"

#include <algorithm>
#include <cstddef>

namespace candela {

namespace {

/// Rows begin on the lines of a cache, and there is a block behind the last one.
constexpr int lineFloats = 16;

int strideOf(int width) {
    const int blocks = (width + laneBlock - 1) / laneBlock;
    return blocks * laneBlock + 2 * imageHalo;
}

std::size_t planeFloats(int width, int height) {
    return std::size_t(strideOf(width)) * std::size_t(height);
}

} // namespace

OwnedImage::OwnedImage(int width, int height, int channels) {
    const std::size_t plane = planeFloats(width, height);
    constexpr int ofColor = 3;
    const int kept = channels == 2 ? ofColor : channels;
    const std::size_t all = plane * std::size_t(kept) + lineFloats;
    memory_ = std::make_unique<float[]>(all);
    void *start = memory_.get();
    std::size_t space = all * sizeof(float);
    auto *aligned = static_cast<float *>(
        std::align(lineFloats * sizeof(float), plane * kept * sizeof(float), start, space));
    for (int c = 0; c < std::max(kept, ofColor); ++c)
        planes_.push_back(aligned + std::size_t(c < kept ? c : 0) * plane + imageHalo);
    view_ = {width, height, channels, strideOf(width), planes_.data()};
}

OwnedImage OwnedImage::copy() const {
    OwnedImage result(width(), height(), channels());
    for (int c = 0; c < channels(); ++c)
        for (int y = 0; y < height(); ++y)
            std::copy_n(row(c, y), width(), result.row(c, y));
    return result;
}

double OwnedImage::bytesNeeded(int width, int height, int channels) {
    return double(planeFloats(width, height)) * channels * sizeof(float);
}

OwnedImage *ImageMaps::find(const std::string &name) {
    const auto at = maps_.find(name);
    return at == maps_.end() ? nullptr : &at->second;
}

const OwnedImage *ImageMaps::find(const std::string &name) const {
    const auto at = maps_.find(name);
    return at == maps_.end() ? nullptr : &at->second;
}

OwnedImage &ImageMaps::set(const std::string &name, OwnedImage image) {
    return maps_.insert_or_assign(name, std::move(image)).first->second;
}

void ImageMaps::remove(const std::string &name) { maps_.erase(name); }

std::vector<std::string> ImageMaps::names() const {
    std::vector<std::string> all;
    for (const auto &[name, image] : maps_)
        all.push_back(name);
    return all;
}

void ImageMaps::setPlane(const std::string &name, int channel, std::span<const float> values) {
    OwnedImage &image = maps_.at(name);
    for (int y = 0; y < image.height(); ++y)
        std::copy_n(values.data() + std::size_t(y) * std::size_t(image.width()), image.width(),
                    image.row(channel, y));
}

std::vector<float> ImageMaps::plane(const std::string &name, int channel) const {
    const OwnedImage &image = maps_.at(name);
    std::vector<float> values;
    values.reserve(std::size_t(image.width()) * std::size_t(image.height()));
    for (int y = 0; y < image.height(); ++y)
        values.insert(values.end(), image.row(channel, y), image.row(channel, y) + image.width());
    return values;
}

} // namespace candela
