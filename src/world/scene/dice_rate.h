// SPDX-License-Identifier: Apache-2.0
// How finely primitives are diced: by what the camera sees of them, whatever the crop window.
#pragma once

#include "foundation/base/box3.h"
#include "foundation/base/matrix4.h"
#include "world/camera/camera.h"
#include "world/geometry/surface.h"

namespace candela {

/// The box around a transformed box.
Box3 transformBox(const Matrix4 &, const Box3 &);
/// The largest factor by which the matrix stretches a vector.
float largestStretch(const Matrix4 &);

/// The rate, in object space, for a primitive: edges of `edgePixels` and a chord error of a tenth
/// of a pixel where the bound comes nearest to the camera, at ShadingRate 1; both grow with its
/// square root. What lies around or behind the camera is diced as if seen from a fraction of its
/// own size.
DiceRate diceRate(const Camera &, const Box3 &objectBound, const Matrix4 &currentFromObject,
                  float shadingRate);

inline constexpr float edgePixels = 8;

} // namespace candela
