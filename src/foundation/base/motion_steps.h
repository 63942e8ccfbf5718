// SPDX-License-Identifier: Apache-2.0
// Where moving things are when: matrices at even steps from when the shutter opens to when it
// closes, every entry going straight from one to the next, as the ray tracer has it.
#pragma once

#include "foundation/base/matrix4.h"
#include "foundation/base/matrix4d.h"
#include "foundation/base/shutter.h"

#include <functional>
#include <span>
#include <vector>

namespace candela {

/// As few steps as keep within 1/2000 of the way that the motion goes (128 steps are the most): two
/// matrices for what goes straight, one for what stands still.
/// `knots`: when it may change its pace.
std::vector<Matrix4> motionSteps(const std::function<Matrix4d(double time)> &currentFromSpace,
                                 std::vector<double> knots, const Shutter &);

/// The matrix at that share of the interval.
Matrix4 matrixAt(std::span<const Matrix4> steps, float share);
/// That, and its inverse: 32 floats.
void matricesAt(std::span<const Matrix4> steps, float share, float *matrices);

} // namespace candela
