// SPDX-License-Identifier: Apache-2.0
// The current transformation (RI 3.2, section 4.3), composed in double. Private to the room.
#pragma once

#include "foundation/base/matrix4d.h"

namespace candela {

/// Current (camera) from object space.
struct CurrentTransform {
    Matrix4d matrix;
    bool flat = false; ///< It is singular: what stands under it is left out.
};

/// What TransformBegin saves.
struct TransformState {
    CurrentTransform current;
    CurrentTransform base; ///< What Identity goes back to: world space inside a world block.
};

/// Why a matrix cannot be the current transformation.
enum class TransformDefect {
    None,
    Projective, ///< It makes things taper.
    NotFinite,  ///< Or a projection onto a plane; also where the world's floats could not hold it.
};

/// The matrix becomes the transformation unless it has a defect.
TransformDefect assign(CurrentTransform &, const Matrix4d &);

} // namespace candela
