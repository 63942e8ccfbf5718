// SPDX-License-Identifier: Apache-2.0
// Camera paths split at their first vertex: what that costs, camera ray, shading and light sample,
// is paid once for several directions. Light that comes straight from lamps makes little noise.
#pragma once

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

/// The number of a path within its pixel: branch k of sample s, which has `cameraDirections` of
/// them; and one for paths that leave their first vertex without a choice of direction. No two
/// paths of a pixel share one, and both kinds are consecutive.
inline std::uint32_t branchNumber(std::uint32_t sample, int k) {
    return sample * std::uint32_t(cameraDirections) + std::uint32_t(k);
}
inline std::uint32_t unbranchedNumber(std::uint32_t sample) { return sample + (1u << 30); }

} // namespace candela
