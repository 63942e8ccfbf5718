// SPDX-License-Identifier: Apache-2.0
// Where estimators leave their samples. Declared here so that light/ and image/ need not see
// each other.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace candela {

/// A named value an estimator can give for every sample, in one or more float components.
struct ChannelInfo {
    std::string name; ///< "Ci", "Oi", "z", "N", "P", "albedo", "id", or an output of shaders.
    int components = 1;
    bool isPlace = false; ///< A position or a direction: X, Y, Z rather than R, G, B.
    bool isList = false;  ///< An array or a matrix: 0, 1, 2 rather than letters.
};

/// Samples of whole pixels, structure of arrays. All samples of a pixel that are in one batch
/// stand together, in the order of their sample index; batches of a pixel come in that order too,
/// one after the other. Pixels are independent: filters are sampled, not splatted, so a sample
/// belongs to the one pixel it was drawn for, with the weight (and sign) of the pixel filter.
struct SampleBatch {
    int count = 0;
    const int *x = nullptr, *y = nullptr; ///< Pixel, absolute raster coordinates.
    const int *sampleIndex = nullptr;     ///< Even and odd ones fill the two half buffers.
    const float *weight = nullptr;        ///< Filter weight, of mean 1 over a pixel.
    /// Plane per component, channels in the order of SampleSink::channels().
    const float *const *values = nullptr;
};

/// Light that paths from lights bring to wherever the camera sees it.
struct SplatBatch {
    int count = 0;
    const float *x = nullptr, *y = nullptr; ///< Absolute raster positions; pixel 0 is [0,1).
    /// A plane of Ci for each colour sample: what one light path brings, times the pixel filter.
    const float *const *values = nullptr;
    /// The light paths that were started for this batch, those that the camera missed among them.
    std::int64_t lightPaths = 0;
};

class SampleSink {
public:
    virtual ~SampleSink() = default;
    /// The channels that are wanted, "Ci" and "Oi" always first and second.
    virtual std::span<const ChannelInfo> channels() const = 0;
    /// Thread-safe as long as no two threads bring samples of the same pixel at once. Pixels
    /// outside the window that is wanted may come too, and are ignored.
    virtual void add(const SampleBatch &) = 0;
    /// Thread-safe. What is seen in the end does not depend on the order of the calls, nor on how
    /// splats are shared out among them.
    virtual void add(const SplatBatch &) = 0;
};

} // namespace candela
