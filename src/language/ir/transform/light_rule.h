// SPDX-License-Identifier: Apache-2.0
// All light, exactly once (DESIGN section 4).
#pragma once

#include "language/ir/core/ir.h"

#include <cstdint>

namespace candela::ir {

/// Which light a shader's ambient() stands for (DESIGN section 4, "all light, exactly once").
enum class LightRule : std::uint8_t {
    Classic, ///< ambient() is what the caller gives; irradiance() is 0.
    Path,    ///< A shader without loops gets its E by rays: irradiance() gains a loop pi Cl
             ///< (N.L), or ambient() a loop Cl (N.L) if the shader never calls irradiance().
};

/// The whole text with the rule's loops added to Ambient or Irradiance where it has none itself.
Function applyLightRule(const Function &whole, LightRule);

} // namespace candela::ir
