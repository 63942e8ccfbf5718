// SPDX-License-Identifier: Apache-2.0
// How fast gradient noise changes at most.
#pragma once

namespace candela::runtime {

/// The greatest slope along an axis, the greatest second derivative along one axis twice, and along
/// two axes.
struct NoiseBend {
    float slope, twice, mixed;
};

/// By dimensions, from 1. Sums, over a cell's corners, of the most that any of the gradients there
/// gives, whatever the hash chooses: the greatest on a grid over a cell, and 2 %, which is more
/// than it grows between the grid's points (noise_bends_test.cpp).
inline constexpr NoiseBend noiseBends[] = {
    {1.38f, 7.65f, 0}, {1.51f, 5.91f, 3.86f}, {1.72f, 5.91f, 5.16f}, {1.80f, 5.91f, 6.01f}};

} // namespace candela::runtime
