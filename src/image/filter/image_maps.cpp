// SPDX-License-Identifier: Apache-2.0
#include "image/filter/image_maps.h"

#include "foundation/base/parallel.h"
#include "foundation/base/planes.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <new>
#include <sys/mman.h>
#include <utility>

namespace candela {

namespace {

/// Rows begin on the lines of a cache.
int strideOf(int width) {
    const int blocks = (width + laneBlock - 1) / laneBlock;
    return blocks * laneBlock + 2 * imageHalo;
}

/// Large images in large pages: a page of 4 kB at a time, the system would take as long to hand
/// memory out as a filter to fill it.
float *newFloats(std::size_t count) {
    constexpr std::size_t line = 64, largePage = std::size_t(2) << 20;
    const std::size_t bytes = std::max<std::size_t>(1, count) * sizeof(float);
    const std::size_t unit = bytes < 2 * largePage ? line : largePage;
    const std::size_t whole = (bytes + unit - 1) / unit * unit;
    void *memory = std::aligned_alloc(unit, whole);
    if (!memory)
        throw std::bad_alloc();
    if (unit == largePage)
        madvise(memory, whole, MADV_HUGEPAGE);
    return static_cast<float *>(memory);
}

std::size_t planeFloats(int width, int height) {
    // Not all planes at the same place of a page: they would fight for the same lines of the
    // caches.
    constexpr std::size_t apart = 5 * 64 / sizeof(float);
    return std::size_t(strideOf(width)) * std::size_t(height) + apart;
}

} // namespace

OwnedImage::OwnedImage(int width, int height, int channels, Contents contents) {
    const std::size_t plane = planeFloats(width, height);
    constexpr int ofColor = 3;
    const int kept = channels == 2 ? ofColor : channels;
    const std::size_t all = plane * std::size_t(kept);
    memory_.reset(newFloats(all));
    if (contents == Contents::Black || kept != channels)
        std::fill_n(memory_.get(), all, 0.0f);
    for (int c = 0; c < std::max(kept, ofColor); ++c)
        planes_.push_back(memory_.get() + std::size_t(c < kept ? c : 0) * plane + imageHalo);
    view_ = {width, height, channels, strideOf(width), planes_.data()};
}

void OwnedImage::Free::operator()(float *memory) const { std::free(memory); }

bool OwnedImage::hasShapeOf(const OwnedImage &other) const {
    return width() == other.width() && height() == other.height() && channels() == other.channels();
}

void OwnedImage::takeValues(const OwnedImage &from) {
    parallelFor(std::size_t(height()), [&](std::size_t y) {
        for (int c = 0; c < channels(); ++c)
            std::copy_n(from.row(c, int(y)), width(), row(c, int(y)));
    });
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

OwnedImage ImageMaps::takeSpare(const OwnedImage &shape) {
    std::optional<OwnedImage> spare = std::exchange(spare_, std::nullopt);
    if (spare && spare->hasShapeOf(shape))
        return std::move(*spare);
    return OwnedImage(shape.width(), shape.height(), shape.channels(), OwnedImage::Contents::Any);
}

void ImageMaps::keepSpare(OwnedImage image) { spare_ = std::move(image); }

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

std::vector<float> meanOfPlanes(int count, const std::function<std::vector<float>(int)> &plane) {
    std::vector<float> mean = plane(0);
    for (int c = 1; c < count; ++c) {
        const std::vector<float> other = plane(c);
        for (std::size_t i = 0; i < mean.size(); ++i)
            mean[i] += other[i];
    }
    for (float &value : mean)
        value /= float(count);
    return mean;
}

} // namespace candela
