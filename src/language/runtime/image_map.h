// SPDX-License-Identifier: Apache-2.0
// A map as code sees it: the named images that filter shaders read with image() and write with
// setimage() (paper, 6.2; DESIGN section 7).
#pragma once

#include <cstdint>

namespace candela {

/// Columns that rows have room for on either side of the picture. Where a map is read by a pixel
/// loop they hold what the border holds, so that code may read past it.
inline constexpr int imageHalo = 32;

/// Pixels that code of a pixel loop takes at a time, at most: planes that it reads and writes have
/// memory for whole such blocks.
inline constexpr int mostPixelsTogether = 32;

/// What a filter is told of its picture, by Op::Captured: the size of "Cs" as it begins.
enum class PictureFact : std::int32_t { Width, Height, Count };

/// The channels of a map. Row 0 is the top, column 0 the left; pixel centres are whole numbers.
struct ImageMap {
    std::int32_t width = 0, height = 0, channels = 0;
    /// Floats from a row to the next: whole blocks of laneBlock pixels and both halos.
    std::int32_t rowStride = 0;
    /// Of each channel: where pixel (0, 0) stands. There are three at least, for whom a color is
    /// wanted: that of a single channel thrice, and zeros behind two.
    float *const *planes = nullptr;

    float *row(int channel, int y) const { return planes[channel] + std::int64_t(y) * rowStride; }
};

} // namespace candela
