// SPDX-License-Identifier: Apache-2.0
// image() and setimage() at any place: what code calls where a plain load or store of a row will
// not do.
#pragma once

#include "language/runtime/image_map.h"

#include <cstdint>

namespace candela {

struct ShaderArgs;

namespace runtime {

/// How image() weighs the pixels about a place. All but Nearest and Bilinear have a width.
enum class ImageFilter : std::int32_t { Nearest, Bilinear, Box, Triangle, Gaussian, CatmullRom };

/// A lookup's operands: where, from which channel on, and the filter's full widths in pixels.
enum class LookupOperand { X, Y, Channel, XWidth, YWidth, Count };
inline constexpr int lookupOperands = int(LookupOperand::Count);

/// `results` channels of a map (1: one channel; else a color: a map of one channel gives it thrice,
/// and what a map does not have is 0) at a place, for each lane in the mask. Operand k of lane j
/// stands at operands[k * laneCount + j], results likewise. Beyond the border the border holds; a
/// coordinate that is NaN counts as 0. A map without pixels gives 0.
void lookUpImage(const ImageMap &, ImageFilter, int results, int laneCount, std::uint32_t mask,
                 const float *operands, float *values);

/// Sets the pixel that a place lies in: floor(x + .5), floor(y + .5); none outside the picture.
/// Operands: x, y, and `values` numbers: as many channels, or one for all channels.
void setImage(const ImageMap &, int values, int laneCount, std::uint32_t mask,
              const float *operands);

/// For generated code: the map of that number.
void lookUpFromCode(const ShaderArgs *, std::int32_t map, std::int32_t filter, std::int32_t results,
                    std::int32_t laneCount, std::uint32_t mask, const float *operands,
                    float *values);
void setFromCode(const ShaderArgs *, std::int32_t map, std::int32_t values, std::int32_t laneCount,
                 std::uint32_t mask, const float *operands);
/// Runs a pixel loop, and clears `results` where nobody does.
void runPixelLoop(const ShaderArgs *, std::int32_t loop, std::int32_t resultCount,
                  const float *given, const float *const *arrays, float *results);
/// Whether the filter goes on.
bool filterGoesOn(const ShaderArgs *);

} // namespace runtime
} // namespace candela
