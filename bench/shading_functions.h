// SPDX-License-Identifier: Apache-2.0
// The three shaders of shading_bench.cpp, as IR and as hand-written C++ for AVX-512.
#pragma once

#include "language/ir/core/ir.h"
#include "language/runtime/shader_abi.h"

namespace candela::bench {

inline constexpr int marbleOctaves = 6, marbleKnots = 13;
/// Spline knots, a row a channel.
inline constexpr float marbleColors[3][marbleKnots] = {
    {.25f, .25f, .20f, .20f, .20f, .25f, .25f, .30f, .35f, .30f, .25f, .20f, .20f},
    {.25f, .25f, .20f, .20f, .20f, .25f, .30f, .35f, .40f, .30f, .30f, .20f, .20f},
    {.35f, .35f, .30f, .30f, .30f, .35f, .45f, .50f, .55f, .50f, .40f, .30f, .30f}};

/// Ci = Cs Os.
ir::Function constantShader();
/// Ci = Cs Kd (sum of Cl N.L); parameter 0 is Kd.
ir::Function matteShader();
/// Six octaves of noise choose a color of a Catmull-Rom spline; parameter 0 is the frequency.
ir::Function marbleShader();

void constantByHand(const ShaderArgs *);
void matteByHand(const ShaderArgs *);
void marbleByHand(const ShaderArgs *);

} // namespace candela::bench
