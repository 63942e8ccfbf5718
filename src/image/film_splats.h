// SPDX-License-Identifier: Apache-2.0
// Light that comes to pixels in any order and from any thread, summed so that neither shows: as
// integers, whose sums are exact.
#pragma once

#include "foundation/units/color.h"
#include "image/picture.h"
#include "world/scene/sample_sink.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

namespace candela {

/// What one step of each channel's 64-bit sums is worth. With 2^-16 the sum over a pixel's splats
/// is exact to 2^-17 a splat and reaches to 2^47, a mean of 140,000 over 10^9 light paths.
using SplatUnits = std::array<double, colorSamples>;
inline constexpr double commonSplatUnit = 0x1p-16;

class FilmSplats {
public:
    FilmSplats(const FrameWindow &, const SplatUnits &);

    /// Splats outside the window are ignored, their light paths count.
    void add(const SplatBatch &);
    /// What light paths bring to a pixel of the window, in rows, on average.
    float mean(std::size_t pixel, int channel) const;

    /// As ResumableSink has them.
    void save(std::string &bytes) const;
    bool restore(std::string_view &bytes);

    /// Sums that ran out of range: they stay at its end, and are as many. Which end, and from when
    /// on, depends on the order only where splats of both signs come near it.
    std::size_t saturatedSums() const;
    /// Components of splats that were NaN or infinite; they count as 0.
    std::uint64_t nonFinite() const { return nonFinite_; }

private:
    void add(std::size_t sum, double value, double unit);

    FrameWindow window_;
    SplatUnits units_;
    std::vector<std::atomic<std::int64_t>> sums_; ///< colorSamples a pixel.
    std::atomic<std::int64_t> lightPaths_{0};
    std::atomic<std::uint64_t> nonFinite_{0};
    mutable std::mutex mutex_;
    std::map<std::size_t, std::int64_t> saturated_; ///< Sums, and where they stay.
};

} // namespace candela
