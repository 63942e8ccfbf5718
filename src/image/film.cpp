// SPDX-License-Identifier: Apache-2.0
#include "image/film.h"

#include "foundation/units/color.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace candela {

namespace {

/// More would be a mistake of the caller; keeps a sample's values off the heap.
constexpr int largestComponentCount = 512;

std::vector<ChannelInfo> withColorAndOpacity(const std::vector<ChannelInfo> &wanted) {
    std::vector<ChannelInfo> channels{{"Ci", colorSamples}, {"Oi", colorSamples}};
    int components = 2 * colorSamples;
    for (const ChannelInfo &channel : wanted) {
        const bool known =
            std::ranges::find(channels, channel.name, &ChannelInfo::name) != channels.end();
        if (!known && components + channel.components <= largestComponentCount) {
            channels.push_back(channel);
            components += channel.components;
        }
    }
    return channels;
}

} // namespace

Film::Film(Settings settings)
    : settings_(std::move(settings)), channels_(withColorAndOpacity(settings_.channels)) {
    for (const ChannelInfo &channel : channels_) {
        if (channel.name == "z")
            depthComponent_ = components_;
        firstComponent_.push_back(components_);
        components_ += channel.components;
    }
    blockSize_ = 2 + components_ * (settings_.signedWeights ? 2 : 1);
    squares_ = blockSize_ * (settings_.keepHalves ? 2 : 1);
    stride_ = squares_ + 1 + colorSamples;
    sums_.assign(settings_.window.pixels() * stride_, 0.0);
    if (depthComponent_ >= 0)
        for (std::size_t i = 0; i < settings_.window.pixels(); ++i)
            sums_[i * stride_ + 2 + depthComponent_] = std::numeric_limits<float>::max();
}

int Film::channelIndex(std::string_view name) const {
    auto found = std::ranges::find(channels_, name, &ChannelInfo::name);
    return found == channels_.end() ? -1 : int(found - channels_.begin());
}

void Film::add(const SampleBatch &batch) {
    const FrameWindow &w = settings_.window;
    for (int i = 0; i < batch.count; ++i) {
        const int x = batch.x[i], y = batch.y[i];
        if (x < w.x0 || x >= w.x1 || y < w.y0 || y >= w.y1)
            continue;
        const std::size_t pixel = std::size_t(y - w.y0) * w.columns() + (x - w.x0);
        addSample(&sums_[pixel * stride_], batch, i);
    }
}

void Film::addSample(double *pixel, const SampleBatch &batch, int sample) {
    double values[largestComponentCount];
    for (int c = 0; c < components_; ++c) {
        values[c] = batch.values[c][sample];
        if (!std::isfinite(values[c])) {
            values[c] = c == depthComponent_ ? std::numeric_limits<float>::max() : 0;
            if (c != depthComponent_)
                nonFinite_.fetch_add(1, std::memory_order_relaxed);
        }
    }
    const double weight = batch.weight[sample];
    addToBlock(pixel, weight, values);
    if (settings_.keepHalves && batch.sampleIndex[sample] % 2 == 0)
        addToBlock(pixel + blockSize_, weight, values);
    double *squares = pixel + squares_;
    squares[0] += weight * weight;
    for (int c = 0; c < colorSamples; ++c)
        squares[1 + c] += weight * weight * values[c] * values[c];
}

void Film::addToBlock(double *block, double weight, const double *values) const {
    block[0] += 1;
    block[1] += weight;
    double *weighted = block + 2;
    for (int c = 0; c < components_; ++c)
        if (c == depthComponent_)
            weighted[c] = std::min(weighted[c], values[c]);
        else
            weighted[c] += weight * values[c];
    if (settings_.signedWeights)
        for (int c = 0; c < components_; ++c)
            weighted[components_ + c] += values[c];
}

Film::Moments Film::moments(const double *pixel, int component, FilmHalf half) const {
    const auto of = [&](const double *block) {
        const double weighted = block[2 + component];
        const double plain =
            settings_.signedWeights ? block[2 + components_ + component] : weighted;
        return Moments{block[0], block[1], weighted, plain};
    };
    const Moments all = of(pixel);
    if (half == FilmHalf::Both)
        return all;
    const Moments even = of(pixel + blockSize_);
    if (half == FilmHalf::Even)
        return even;
    return {all.count - even.count, all.weights - even.weights, all.weighted - even.weighted,
            all.plain - even.plain};
}

/// With weights of mean 1 the mean of w v is an unbiased estimate, but where w changes its sign it
/// makes noise even of a constant. The mean of w, known to be 1, serves as a control variate: its
/// coefficient is the mean of v, which makes constants exact, and the last term takes away the
/// bias that estimating this coefficient from the same samples brings.
double Film::estimate(const Moments &m) {
    if (m.count == 0)
        return 0;
    const double plain = m.plain / m.count;
    if (m.count < 2)
        return plain;
    const double weighted = m.weighted / m.count, weight = m.weights / m.count;
    return weighted + plain * (1 - weight) + (weighted - plain * weight) / (m.count - 1);
}

std::vector<float> Film::mean(int channel, int component, FilmHalf half) const {
    const int slot = firstComponent_[channel] + component;
    std::vector<float> plane(settings_.window.pixels());
    for (std::size_t i = 0; i < plane.size(); ++i) {
        const double *pixel = &sums_[i * stride_];
        if (slot == depthComponent_) {
            plane[i] = float(pixel[2 + slot]);
            continue;
        }
        const Moments m = moments(pixel, slot, half);
        plane[i] = float(settings_.signedWeights ? estimate(m)
                         : m.count > 0           ? m.weighted / m.count
                                                 : 0);
    }
    return plane;
}

std::vector<float> Film::varianceOfMean(int component) const {
    std::vector<float> plane(settings_.window.pixels());
    for (std::size_t i = 0; i < plane.size(); ++i) {
        const double *pixel = &sums_[i * stride_], *squares = pixel + squares_;
        const Moments m = moments(pixel, component, FilmHalf::Both);
        if (m.count < 2) {
            plane[i] = std::numeric_limits<float>::infinity();
            continue;
        }
        // The residuals are r = w (v - mean of v); |w| is constant, so that the sum of w^2 v is
        // the mean of w^2 times the sum of v.
        const double mean = m.plain / m.count;
        const double squared = squares[1 + component] - mean * mean * squares[0];
        const double sum = m.weighted - mean * m.weights;
        const double variance = (squared - sum * sum / m.count) / (m.count * (m.count - 1));
        plane[i] = float(std::max(0.0, variance));
    }
    return plane;
}

} // namespace candela
