// SPDX-License-Identifier: Apache-2.0
// Owen-scrambled Sobol points, addressed by (pixel, sample, dimension pair): no state, so the
// value depends on these and the seed alone.
#pragma once

#include <cstdint>

namespace candela {

/// What stands for a pixel in the address: mixes its absolute position with the seed.
std::uint32_t pixelKey(int x, int y, std::uint32_t seed);
/// Where a pixel has two sequences that know nothing of each other: the address of the second.
std::uint32_t keyOfOddHalf(std::uint32_t pixelKey);

/// x[i], y[i]: the point with number sampleIndex[i] of a (0,2)-sequence of points in [0,1)^2 that
/// is scrambled and shuffled independently for each pixel and each `pair`. Any 2^k consecutive
/// aligned samples of a pixel are stratified in both projections and in all elementary boxes.
void sobolPairs(int count, const std::uint32_t *pixelKey, const std::uint32_t *sampleIndex,
                std::uint32_t pair, float *x, float *y);

/// The third and fourth coordinates of the points whose first two are sobolPairs(): the four are
/// stratified together, which pays for the two directions that matter most to a path. Of more than
/// 2^16 samples, each 2^16 are so.
void sobolFollowingPairs(int count, const std::uint32_t *pixelKey, const std::uint32_t *sampleIndex,
                         std::uint32_t pair, float *x, float *y);

/// 32 well mixed bits a lane for uses that need no stratification.
void randomBits(int count, const std::uint32_t *pixelKey, const std::uint32_t *sampleIndex,
                std::uint32_t salt, std::uint32_t *bits);

} // namespace candela
