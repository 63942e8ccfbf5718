// SPDX-License-Identifier: Apache-2.0
// Light sampling as estimators see it: points ask, samples answer, in batches.
#pragma once

#include "foundation/base/planes.h"
#include "foundation/units/color.h"

#include <array>
#include <cstdint>

namespace candela {

/// Lights come in groups, and each point takes a sample of each group: lamps, and what shines from
/// far and wide (suns, domes, ceilings). So neither leaves the other too few samples.
inline constexpr int lightGroups = 2;
enum LightGroup { lampGroup, wideGroup };

/// The points that ask for light.
struct LightQuery {
    int count = 0;
    std::array<const float *, 3> P{};  ///< Where rays to lights start, just off the surface.
    std::array<const float *, 3> Ps{}; ///< The point on the surface: what light shaders are told.
    std::array<const float *, 3> N{};  ///< Unit, facing; 0 where light from both sides counts.
    /// Above 0 where scattered rays look for light beside these samples; null: nowhere.
    const float *scattered = nullptr;
    const std::int32_t *lightSet = nullptr;
    const float *time = nullptr;
    /// Uniform samples: which light, and where on it.
    const float *choice = nullptr;
    std::array<const float *, 2> position{};
};

/// One light sample for each point; planes are the caller's.
struct LightSamples {
    /// From LightQuery::P towards the light, as far as a shadow ray may go: finite lights end it a
    /// little before their own surface (docs/ray-offset.md).
    std::array<float *, 3> L{};
    float *distance = nullptr; ///< Length of L in metres; infinity for distant lights.
    /// What a loop's Cl is worth before the shadow: for finite pdf the radiance L_i (W m^-2
    /// sr^-1), undivided, since the pdf includes the choice; for delta lights (pdfSolidAngle = 0)
    /// E_perp / pi, or in classic units the number the light shader wrote, divided by the
    /// probability of choosing the light.
    std::array<float *, colorSamples> value{};
    float *pdfSolidAngle = nullptr; ///< Of this direction, choice included; 0 = delta light.
    std::int32_t *light = nullptr;  ///< Index + 1; 0 = no sample (black).
    /// 1 if a shadow ray is due (else the light shines through everything, as classic ones may).
    std::uint8_t *castsShadow = nullptr;
};

} // namespace candela
