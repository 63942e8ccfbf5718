// SPDX-License-Identifier: Apache-2.0
// What shaders answer as Oi and what a ray takes it for.
#pragma once

namespace candela {

/// Opacity lies in [0,1], whatever a shader writes. NaN stays, to be reported where light is.
inline float clampedOpacity(float Oi) { return Oi < 0 ? 0 : Oi > 1 ? 1 : Oi; }

} // namespace candela
