// SPDX-License-Identifier: Apache-2.0
// What estimators are told, and what they tell besides the picture.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>

namespace candela {

/// Samples of each pixel that a pass over the frame takes. Passes begin at multiples of it.
inline constexpr int passSamples = 16;

enum class IntegratorKind { Classic, Path };

struct IntegratorSettings {
    IntegratorKind kind = IntegratorKind::Path;
    int firstSample = 0; ///< Of each pixel; a multiple of passSamples.
    int lastSample = 4;  ///< One beyond; the samples of a pixel so far are then as many.
    std::uint32_t seed = 0;
    int maxDepth = 64;           ///< Reflections and refractions along a path.
    bool hemisphereOnly = false; ///< --sampling hemisphere: ignore the shaders' cones.
    std::array<int, 4> crop{};   ///< x0, x1, y0, y1: the pixels to render.
    /// Called after each tile, from any thread, with the share done in [0,1].
    std::function<void(double)> progress;
};

/// What happened besides the picture, for --stats and messages. Counters of all threads.
struct TransportStatistics {
    std::atomic<std::uint64_t> paths{0}, cameraRays{0}, bounceRays{0}, shadowRays{0};
    std::atomic<std::uint64_t> nonFiniteSamples{0};
};

} // namespace candela
