// SPDX-License-Identifier: Apache-2.0
// The current transformation (RI 3.2, section 4.3), composed in double. Private to the room.
#pragma once

#include "interface/ri/transform_motion.h"

namespace candela {

/// Current (camera) from object space.
struct CurrentTransform {
    Matrix4d matrix;                ///< When the shutter opens.
    TransformMotion::Shared motion; ///< Null: it stands still.
    bool flat = false;              ///< It is singular: what stands under it is left out.
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

/// The matrix becomes the transformation, which stands still, unless it has a defect.
TransformDefect assign(CurrentTransform &, const Matrix4d &);
/// What goes through `inner` before; likewise.
TransformDefect concatenate(CurrentTransform &, const Matrix4d &inner);
/// What goes through the block before; likewise, at all of the block's times.
TransformDefect concatenate(CurrentTransform &, std::shared_ptr<const MotionBlock>, double open);

} // namespace candela
