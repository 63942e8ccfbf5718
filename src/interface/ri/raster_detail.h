// SPDX-License-Identifier: Apache-2.0
// How large things are in the picture (RI 3.2, 4.2.11).
#pragma once

#include "interface/ri/options.h"

#include <array>

namespace candela {

/// The area in pixels of the rectangle around a box (xMin, xMax, yMin...) as the camera sees it,
/// off the frame, too; infinite if a corner lies beside or behind the eye.
float rasterDetail(const std::array<float, 6> &bound, const Matrix4d &currentFromObject,
                   const Options &);

} // namespace candela
