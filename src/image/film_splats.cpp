// SPDX-License-Identifier: Apache-2.0
#include "image/film_splats.h"

#include "foundation/base/raw_bytes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace candela {

namespace {

constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max();
/// A splat may not carry a sum around the whole range at once.
constexpr double mostAtOnce = 0x1p62;

} // namespace

FilmSplats::FilmSplats(const FrameWindow &window, const SplatUnits &units)
    : window_(window), units_(units), sums_(window.pixels() * colorSamples) {}

void FilmSplats::add(const SplatBatch &batch) {
    lightPaths_ += batch.lightPaths;
    for (int i = 0; i < batch.count; ++i) {
        const float x = std::floor(batch.x[i]), y = std::floor(batch.y[i]);
        const bool inside = x >= float(window_.x0) && x < float(window_.x1) &&
                            y >= float(window_.y0) && y < float(window_.y1);
        if (!inside)
            continue;
        const std::size_t pixel =
            std::size_t(int(y) - window_.y0) * window_.columns() + (int(x) - window_.x0);
        for (int c = 0; c < colorSamples; ++c)
            add(pixel * colorSamples + c, batch.values[c][i], units_[c]);
    }
}

void FilmSplats::add(std::size_t sum, double value, double unit) {
    if (!std::isfinite(value)) {
        ++nonFinite_;
        return;
    }
    const std::int64_t step = std::llrint(std::clamp(value / unit, -mostAtOnce, mostAtOnce));
    const std::int64_t before = sums_[sum].fetch_add(step, std::memory_order_relaxed);
    std::int64_t after;
    if (__builtin_add_overflow(before, step, &after)) {
        std::lock_guard lock(mutex_);
        saturated_.try_emplace(sum, step > 0 ? most : -most);
    }
}

float FilmSplats::mean(std::size_t pixel, int channel) const {
    const std::size_t index = pixel * colorSamples + channel;
    std::int64_t sum = sums_[index];
    if (!saturated_.empty())
        if (auto found = saturated_.find(index); found != saturated_.end())
            sum = found->second;
    const std::int64_t paths = lightPaths_;
    return paths > 0 ? float(double(sum) * units_[channel] / double(paths)) : 0.0f;
}

void FilmSplats::save(std::string &bytes) const {
    for (const std::atomic<std::int64_t> &sum : sums_)
        appendRaw(bytes, sum.load(std::memory_order_relaxed));
    appendRaw(bytes, lightPaths_.load());
    appendRaw(bytes, nonFinite_.load());
    std::lock_guard lock(mutex_);
    appendRaw(bytes, std::uint64_t(saturated_.size()));
    for (const auto &[sum, end] : saturated_)
        appendRaw(bytes, std::uint64_t(sum)), appendRaw(bytes, end);
}

bool FilmSplats::restore(std::string_view &bytes) {
    std::int64_t value = 0;
    for (std::atomic<std::int64_t> &sum : sums_) {
        if (!takeRaw(bytes, value))
            return false;
        sum.store(value, std::memory_order_relaxed);
    }
    std::int64_t lightPaths = 0;
    std::uint64_t nonFinite = 0, saturated = 0, sum = 0;
    if (!takeRaw(bytes, lightPaths) || !takeRaw(bytes, nonFinite) || !takeRaw(bytes, saturated))
        return false;
    lightPaths_ = lightPaths, nonFinite_ = nonFinite;
    for (; saturated > 0; --saturated) {
        if (!takeRaw(bytes, sum) || !takeRaw(bytes, value))
            return false;
        saturated_[std::size_t(sum)] = value;
    }
    return true;
}

std::size_t FilmSplats::saturatedSums() const {
    std::lock_guard lock(mutex_);
    return saturated_.size();
}

} // namespace candela
