// SPDX-License-Identifier: Apache-2.0
// Transcendental functions exactly as compiled shaders compute them at width 1 on this machine,
// which is bit by bit what they compute at width 16. For the interpreter and for constant folding.
#pragma once

namespace candela::runtime {

float sin(float radians);
float cos(float radians);
float tan(float radians);
/// The argument is clamped to [-1, 1]; NaN counts as -1.
float asin(float x);
float acos(float x);
/// In (-pi/2, pi/2).
float atan(float x);
/// The angle of (x, y), in (-pi, pi].
float atan2(float y, float x);
float exp(float x);
/// Natural logarithm: -infinity at 0, NaN below.
float log(float x);
/// base^exponent; 0 if the base is negative and the exponent no integer (ALGORITHMS.md 0).
float pow(float base, float exponent);

} // namespace candela::runtime
