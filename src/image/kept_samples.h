// SPDX-License-Identifier: Apache-2.0
// Every sample of Ci, for filters that read the map "samples": nothing else keeps them.
#pragma once

#include "image/film.h"
#include "image/filter/image_maps.h"

namespace candela {

/// More bytes than these are not spent on samples.
inline constexpr double mostSampleBytes = 4e9;

/// Stands before a film: what comes goes on to it.
class KeptSamples : public ResumableSink {
public:
    /// Room for the samples [0, samples) of each pixel of the film's window.
    KeptSamples(Film &film, int samples);
    static double bytesNeeded(const FrameWindow &, int samples);

    std::span<const ChannelInfo> channels() const override { return film_.channels(); }
    void add(const SampleBatch &) override;
    void add(const SplatBatch &batch) override { film_.add(batch); }
    void save(std::string &bytes) const override;
    bool restore(std::string_view &bytes) override;

    /// Sample k in the channels from k * colorSamples on, times the weight of the pixel filter, so
    /// that Ci is their mean where no weight is negative. What is not finite is 0.
    OwnedImage take() { return std::move(samples_); }

private:
    Film &film_;
    OwnedImage samples_;
};

} // namespace candela
