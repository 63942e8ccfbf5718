// SPDX-License-Identifier: Apache-2.0
// Over a box: functions of one or two numbers, and vectors of unit length.
#pragma once

#include "language/ir/transform/bound_values.h"

namespace candela::ir {

/// Floor, Ceil, Round.
FormParts boundOfStep(Builder &, Op, const BoundedValue &x, ValueId middle);
/// Sqrt, Exp, Log, Tan, Asin, Acos, Atan.
FormParts boundOfMonotone(Builder &, Op, const BoundedValue &x, ValueId middle);
/// Sin, Cos.
FormParts boundOfWave(Builder &, Op, const BoundedValue &x, ValueId middle);
/// Atan2 of y and x.
FormParts boundOfAngle(Builder &, const BoundedValue &y, const BoundedValue &x, ValueId middle);
FormParts boundOfPower(Builder &, const BoundedValue &x, const BoundedValue &y, ValueId middle);
/// The cubic of smoothstep(), 0 below t = 0 and 1 from t = 1 on.
FormParts boundOfSmoothStep(Builder &, const BoundedValue &t, ValueId middle);
/// A component of a vector of unit length, made from x by its length, which in the middle is
/// `length`.
FormParts boundOfUnit(Builder &, const std::array<BoundedValue, 3> &x, std::size_t component,
                      ValueId length, ValueId middle);
} // namespace candela::ir
