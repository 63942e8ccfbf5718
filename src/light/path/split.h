// SPDX-License-Identifier: Apache-2.0
// Camera paths split at their first vertex: what that costs, camera ray, shading and light sample,
// is paid once for several directions. Light that comes straight from lamps makes little noise.
#pragma once

#include "foundation/base/hash.h"
#include "light/path/wave.h"

namespace candela {

/// Directions of finite lobes that a camera path follows from its first vertex; a power of 2, so
/// that samples stay stratified. Measured on the scenes of bench/.
inline constexpr int cameraDirections = 2;

/// How many directions of finite lobes the vertices in hand are left by.
inline int directionsAt(const PathWave &wave) {
    return wave.vertex == 0 && wave.purpose == Purpose::Camera &&
                   wave.frame.settings.kind == IntegratorKind::Path
               ? cameraDirections
               : 1;
}

/// The number of a path within its pixel: direction k of sample s, which has `cameraDirections` of
/// them.
inline std::uint32_t directionNumber(std::uint32_t sample, int k) {
    return sample * std::uint32_t(cameraDirections) + std::uint32_t(k);
}
/// That of a path that leaves a vertex by an event of one direction, `kind` as ScatteringEvents
/// counts them: consecutive samples stay so, in another part of the sequence.
inline std::uint32_t eventNumber(std::uint32_t sample, int vertex, int kind) {
    const std::uint64_t branch = std::uint64_t(vertex) << 32 | std::uint32_t(kind + 1);
    return sample ^ (std::uint32_t(mixBits(branch) >> 32) & 0xffff0000u);
}

} // namespace candela
