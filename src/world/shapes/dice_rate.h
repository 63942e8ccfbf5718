// SPDX-License-Identifier: Apache-2.0
// How finely primitives are diced: by what the camera sees of them, whatever the crop window.
#pragma once

#include "foundation/base/box3.h"
#include "foundation/base/matrix4.h"
#include "world/camera/camera.h"

namespace candela {

/// Triangles are so far from the surface, in pixels where the bound comes nearest to the camera, at
/// ShadingRate 1; it grows with its square root.
inline constexpr float chordPixels = 0.1f;
/// A finer ShadingRate is taken for this one, which shows no difference any more.
inline constexpr float finestShadingRate = 0.00001f;

/// The box around a transformed box.
Box3 transformBox(const Matrix4 &, const Box3 &);
/// The largest factor by which the matrix stretches a vector.
float largestStretch(const Matrix4 &);

/// The depth in camera space at which a box is taken to be seen. What lies around or behind the
/// camera is seen as from a fraction of its own size.
float viewingDepth(const Box3 &);
/// What the camera does not show is diced as if a pixel were so large: by its size.
float unseenPixel(const Box3 &);
/// The edge of a pixel at that depth, or of one that does not show the box; of a camera that moves,
/// the least that it comes to.
float viewingPixel(const Camera &, const Box3 &);

} // namespace candela
