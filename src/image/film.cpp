// SPDX-License-Identifier: Apache-2.0
#include "image/film.h"

#include "foundation/base/hot.h"
#include "foundation/base/raw_bytes.h"
#include "foundation/units/color.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace candela {

namespace {

std::vector<ChannelInfo> withColorAndOpacity(const std::vector<ChannelInfo> &wanted) {
    std::vector<ChannelInfo> channels{{"Ci", colorSamples}, {"Oi", colorSamples}};
    for (const ChannelInfo &channel : wanted)
        if (std::ranges::find(channels, channel.name, &ChannelInfo::name) == channels.end())
            channels.push_back(channel);
    return channels;
}

/// The sum of value(0) to value(count - 1), kept in eight parts that vectors add side by side: the
/// same on every machine, and with less rounding than one long sum.
template <class Value> inline double sumInParts(int count, const Value &value) {
    constexpr int parts = 8;
    double sums[parts] = {};
    int i = 0;
    for (; i + parts <= count; i += parts)
        for (int k = 0; k < parts; ++k)
            sums[k] += value(i + k);
    for (int k = 0; i + k < count; ++k)
        sums[k] += value(i + k);
    return ((sums[0] + sums[1]) + (sums[2] + sums[3])) +
           ((sums[4] + sums[5]) + (sums[6] + sums[7]));
}

CANDELA_HOT double sumOf(int count, const float *values) {
    return sumInParts(count, [&](int i) { return double(values[i]); });
}

CANDELA_HOT double sumOfProducts(int count, const float *a, const float *b) {
    return sumInParts(count, [&](int i) { return double(a[i]) * double(b[i]); });
}

/// Of the products that are finite.
CANDELA_HOT double sumOfSquares(int count, const float *a, const float *b) {
    return sumInParts(count, [&](int i) {
        double value = double(a[i]) * double(b[i]);
        return value * 0 == 0 ? value * value : 0.0;
    });
}

/// Of weight and value, unbiased, from two samples on.
double covariance(const FilmMoments &m) {
    return (m.weighted - m.plain / m.count * m.weights) / (m.count - 1);
}

/// With weights of mean 1 the mean of w v is an unbiased estimate, but where w changes its sign it
/// makes noise even of a constant. E[w v] = E[v] + cov(w, v), and the unbiased estimates of both
/// leave constants alone.
double estimate(const FilmMoments &m) {
    if (m.count == 0)
        return 0;
    const double plain = m.plain / m.count;
    return m.count < 2 ? plain : plain + covariance(m);
}

/// The leading term is the spread of the residuals r = w (v - mean of v); since |w| is constant,
/// the sum of w^2 v is the mean of w^2 times the sum of v. What the covariance adds with few
/// samples is its textbook variance under independence.
double varianceOfEstimate(const FilmMoments &m, double squaredWeights, double squares,
                          bool signedWeights) {
    const double n = m.count, mean = m.plain / n;
    const double residual = m.weighted - mean * m.weights;
    const double spread = squares - mean * mean * squaredWeights - residual * residual / n;
    double variance = spread / (n * (n - 1));
    if (signedWeights && squaredWeights > 0) {
        const double meanSquaredWeight = squaredWeights / n;
        const double valueVariance = (squares / meanSquaredWeight - n * mean * mean) / (n - 1);
        variance += ((meanSquaredWeight - 1) * valueVariance + covariance(m) * covariance(m)) /
                    (n * (n - 1));
    }
    return std::max(0.0, variance);
}

} // namespace

Film::Film(Settings settings)
    : settings_(std::move(settings)), channels_(withColorAndOpacity(settings_.channels)) {
    settings_.keepHalves |= settings_.pairsHalves;
    for (const ChannelInfo &channel : channels_) {
        layout_.firstComponent.push_back(layout_.components);
        layout_.components += channel.components;
        layout_.merge.resize(layout_.components, mergeOf(channel));
    }
    layout_.block = 2 + layout_.components * (settings_.signedWeights ? 2 : 1);
    layout_.squares = layout_.block * (settings_.keepHalves ? 2 : 1);
    layout_.stride = layout_.squares + 1 + colorSamples;
    sums_.assign(settings_.window.pixels() * layout_.stride, 0.0);
    for (int c = 0; c < layout_.components; ++c)
        if (layout_.merge[c] == Merge::Nearest)
            for (std::size_t i = 0; i < settings_.window.pixels(); ++i)
                sums_[i * layout_.stride + 2 + c] = std::numeric_limits<float>::max();
    if (settings_.splats)
        splats_ = std::make_unique<FilmSplats>(settings_.window, settings_.splatUnits);
}

/// Depths and numbers of things mean nothing between those of their samples.
Film::Merge Film::mergeOf(const ChannelInfo &channel) {
    return channel.name == "z" ? Merge::Nearest : channel.name == "id" ? Merge::First : Merge::Mean;
}

double Film::bytesNeeded(Settings settings) {
    const double pixels = double(settings.window.pixels());
    settings.window = {};
    const double splats = settings.splats ? colorSamples * sizeof(std::int64_t) : 0;
    return pixels * (Film(std::move(settings)).layout_.stride * sizeof(double) + splats);
}

int Film::channelIndex(std::string_view name) const {
    auto found = std::ranges::find(channels_, name, &ChannelInfo::name);
    return found == channels_.end() ? -1 : int(found - channels_.begin());
}

void Film::add(const SampleBatch &batch) {
    const FrameWindow &w = settings_.window;
    for (int first = 0, last = 0; first < batch.count; first = last) {
        const int x = batch.x[first], y = batch.y[first];
        while (last < batch.count && batch.x[last] == x && batch.y[last] == y)
            ++last;
        if (x < w.x0 || x >= w.x1 || y < w.y0 || y >= w.y1)
            continue;
        const std::size_t pixel = std::size_t(y - w.y0) * w.columns() + (x - w.x0);
        addRun(&sums_[pixel * layout_.stride], {batch, first, last});
    }
}

void Film::add(const SplatBatch &batch) {
    if (splats_)
        splats_->add(batch);
}

void Film::addRun(double *pixel, const Run &run) {
    addToBlock(pixel, run, false);
    if (settings_.keepHalves)
        addToBlock(pixel + layout_.block, run, true);
    const int count = run.last - run.first;
    const float *weights = run.batch.weight + run.first;
    double *squares = pixel + layout_.squares;
    squares[0] += sumOfProducts(count, weights, weights);
    for (int c = 0; c < colorSamples; ++c)
        squares[1 + c] += sumOfSquares(count, weights, run.batch.values[c] + run.first);
}

void Film::addToBlock(double *block, const Run &run, bool evenOnly) {
    if (!evenOnly) {
        block[0] += run.last - run.first;
        block[1] += sumOf(run.last - run.first, run.batch.weight + run.first);
    } else {
        for (int i = run.first; i < run.last; ++i)
            if (run.batch.sampleIndex[i] % 2 == 0) {
                block[0] += 1;
                block[1] += run.batch.weight[i];
            }
    }
    double *weighted = block + 2, *plain = weighted + layout_.components;
    for (int c = 0; c < layout_.components; ++c) {
        if (layout_.merge[c] != Merge::Mean) {
            weighted[c] = addSingle(layout_.merge[c], weighted[c], run, c);
            continue;
        }
        weighted[c] = addComponent(weighted[c], run, c, evenOnly, true);
        if (settings_.signedWeights)
            plain[c] = addComponent(plain[c], run, c, evenOnly, false);
    }
}

/// What stands for all samples but is none of their means.
double Film::addSingle(Merge merge, double value, const Run &run, int component) {
    const float *values = run.batch.values[component];
    if (merge == Merge::First)
        return run.batch.sampleIndex[run.first] == 0 ? values[run.first] : value;
    for (int i = run.first; i < run.last; ++i)
        value = values[i] < value ? values[i] : value; // NaN is not nearer.
    return value;
}

/// The sum with a run's values. No sum of floats overflows a double, so
/// a sum that is not finite tells that some value was not, and only then is each one looked at.
double Film::addComponent(double sum, const Run &run, int component, bool evenOnly, bool weighted) {
    const float *values = run.batch.values[component], *weights = run.batch.weight;
    const int *index = run.batch.sampleIndex;
    const double before = sum;
    if (!evenOnly && weighted)
        sum += sumOfProducts(run.last - run.first, weights + run.first, values + run.first);
    else
        for (int i = run.first; i < run.last; ++i)
            if (!evenOnly || index[i] % 2 == 0)
                sum += weighted ? double(weights[i]) * values[i] : double(values[i]);
    if (std::isfinite(sum))
        return sum;
    sum = before;
    for (int i = run.first; i < run.last; ++i) {
        if (evenOnly && index[i] % 2 != 0)
            continue;
        if (std::isfinite(values[i]))
            sum += weighted ? double(weights[i]) * values[i] : double(values[i]);
        else if (weighted && !evenOnly)
            nonFinite_.fetch_add(1, std::memory_order_relaxed);
    }
    return sum;
}

FilmMoments Film::moments(const double *pixel, int component, FilmHalf half) const {
    const auto of = [&](const double *block) {
        const double weighted = block[2 + component];
        const double plain =
            settings_.signedWeights ? block[2 + layout_.components + component] : weighted;
        return FilmMoments{block[0], block[1], weighted, plain};
    };
    const FilmMoments all = of(pixel);
    if (half == FilmHalf::Both)
        return all;
    const FilmMoments even = of(pixel + layout_.block);
    if (half == FilmHalf::Even)
        return even;
    return {all.count - even.count, all.weights - even.weights, all.weighted - even.weighted,
            all.plain - even.plain};
}

float Film::meanOfMoments(const FilmMoments &m) const {
    return float(settings_.signedWeights ? estimate(m) : m.count > 0 ? m.weighted / m.count : 0);
}

float Film::value(const double *pixel, int slot, FilmHalf half) const {
    if (layout_.merge[slot] != Merge::Mean)
        return float(pixel[2 + slot]);
    if (settings_.pairsHalves && half == FilmHalf::Both) {
        const FilmMoments even = moments(pixel, slot, FilmHalf::Even);
        const FilmMoments odd = moments(pixel, slot, FilmHalf::Odd);
        if (even.count > 0 && odd.count > 0)
            return 0.5f * meanOfMoments(even) + 0.5f * meanOfMoments(odd);
    }
    return meanOfMoments(moments(pixel, slot, half));
}

std::vector<float> Film::mean(int channel, int component, FilmHalf half) const {
    std::vector<float> plane(settings_.window.pixels());
    for (std::size_t i = 0; i < plane.size(); ++i)
        plane[i] = meanOfPixel(i, channel, component, half);
    return plane;
}

float Film::meanOfPixel(std::size_t pixel, int channel, int component, FilmHalf half) const {
    const int slot = layout_.firstComponent[channel] + component;
    const float samples = value(&sums_[pixel * layout_.stride], slot, half);
    return splats_ && channel == 0 ? samples + splats_->mean(pixel, component) : samples;
}

bool Film::isZero(int channel) const {
    for (std::size_t pixel = 0; pixel < settings_.window.pixels(); ++pixel)
        for (int c = 0; c < channels_[channel].components; ++c)
            if (meanOfPixel(pixel, channel, c, FilmHalf::Both) != 0)
                return false;
    return true;
}

std::uint64_t Film::nonFiniteSamples() const {
    return nonFinite_ + (splats_ ? splats_->nonFinite() : 0);
}

SampleCounts Film::sampleCounts() const {
    if (sums_.empty())
        return {};
    double least = sums_[0], most = sums_[0], sum = 0;
    for (std::size_t at = 0; at < sums_.size(); at += std::size_t(layout_.stride)) {
        least = std::min(least, sums_[at]), most = std::max(most, sums_[at]);
        sum += sums_[at];
    }
    return {int(least), int(most), sum / double(settings_.window.pixels())};
}

void Film::save(std::string &bytes) const {
    appendRaw(bytes, std::span(sums_));
    appendRaw(bytes, nonFinite_.load());
    if (splats_)
        splats_->save(bytes);
}

bool Film::restore(std::string_view &bytes) {
    std::uint64_t nonFinite = 0;
    const bool whole = takeRaw(bytes, std::span(sums_)) && takeRaw(bytes, nonFinite) &&
                       (!splats_ || splats_->restore(bytes));
    nonFinite_ = nonFinite;
    return whole;
}

/// What the variance of the mean of two halves' means is to that of the mean of all samples.
double Film::shareOfHalves(const double *pixel) const {
    const double all = pixel[0], even = pixel[layout_.block], odd = all - even;
    return even > 0 && odd > 0 ? all * (1 / even + 1 / odd) / 4 : 1;
}

std::vector<float> Film::varianceOfMean(int component) const {
    std::vector<float> plane(settings_.window.pixels());
    for (std::size_t i = 0; i < plane.size(); ++i) {
        const double *pixel = &sums_[i * layout_.stride], *squares = pixel + layout_.squares;
        const FilmMoments m = moments(pixel, component, FilmHalf::Both);
        if (m.count < 2) {
            plane[i] = std::numeric_limits<float>::infinity();
            continue;
        }
        const double variance =
            varianceOfEstimate(m, squares[0], squares[1 + component], settings_.signedWeights);
        plane[i] = float(variance * (settings_.pairsHalves ? shareOfHalves(pixel) : 1));
    }
    return plane;
}

} // namespace candela
