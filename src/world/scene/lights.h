// SPDX-License-Identifier: Apache-2.0
// All that shines, behind one interface: light shaders (points, distant lights, area lights) and
// surfaces that emit. Lights are chosen by power; the interface leaves room for a light tree.
#pragma once

#include "foundation/base/planes.h"
#include "interface/ri/attributes.h"
#include "language/runtime/shader_abi.h"

#include <array>
#include <cstdint>

namespace candela {

/// The points that ask for light.
struct LightQuery {
    int count = 0;
    std::array<const float *, 3> P{};
    std::array<const float *, 3> N{}; ///< Unit, facing; 0 where light from both sides counts.
    const std::int32_t *lightSet = nullptr;
    const float *time = nullptr;
    /// Uniform samples: which light, and where on it.
    const float *choice = nullptr;
    std::array<const float *, 2> position{};
};

/// One light sample for each point; planes are the caller's.
struct LightSamples {
    /// From P towards the light, as far as a shadow ray may go: finite lights end it a little
    /// before their own surface (docs/ray-offset.md).
    std::array<float *, 3> L{};
    float *distance = nullptr; ///< Length of L in metres; infinity for distant lights.
    /// What a loop's Cl is worth before the shadow: for finite pdf the radiance L_i (W m^-2
    /// sr^-1), undivided, since the pdf includes the choice; for delta lights (pdfSolidAngle = 0)
    /// E_perp / pi, or in classic units the number the light shader wrote, divided by the
    /// probability of choosing the light.
    float *value[8] = {};
    float *pdfSolidAngle = nullptr; ///< Of this direction, choice included; 0 = delta light.
    std::int32_t *light = nullptr;  ///< Index + 1; 0 = no sample (black).
    /// 1 if a shadow ray is due (else the light shines through everything, as classic ones may).
    std::uint8_t *castsShadow = nullptr;
};

} // namespace candela
