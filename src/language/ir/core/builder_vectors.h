// SPDX-License-Identifier: Apache-2.0
// Arithmetic on points, vectors, normals and colors.
#pragma once

#include "language/ir/core/builder.h"

namespace candela::ir {

Triple select(Builder &, ValueId condition, const Triple &, const Triple &);
Triple add(Builder &, const Triple &, const Triple &);
Triple sub(Builder &, const Triple &, const Triple &);
Triple mul(Builder &, const Triple &, const Triple &);
Triple div(Builder &, const Triple &, const Triple &);
Triple scale(Builder &, const Triple &, ValueId);
Triple neg(Builder &, const Triple &);
ValueId dot(Builder &, const Triple &, const Triple &); ///< (x x' + y y') + z z'
Triple cross(Builder &, const Triple &, const Triple &);
ValueId length(Builder &, const Triple &);
/// Of unit length; a zero vector stays zero. What is known to be unit is not divided again.
Triple normalize(Builder &, const Triple &);
/// I - 2 (I.N) N, with N as it is.
Triple reflect(Builder &, const Triple &I, const Triple &N);
/// N, or -N where I.reference > 0.
Triple faceforward(Builder &, const Triple &N, const Triple &I, const Triple &reference);
Triple transformPoint(Builder &, const Matrix &, const Triple &); ///< Divides by w.
Triple transformVector(Builder &, const Matrix &, const Triple &);
/// By the transpose of the inverse: pass the inverse of the matrix that takes points.
Triple transformNormal(Builder &, const Matrix &inverse, const Triple &);

} // namespace candela::ir
