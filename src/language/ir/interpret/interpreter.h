// SPDX-License-Identifier: Apache-2.0
// The oracle: runs an IR function lane by lane on the very arguments that compiled code takes.
// Slow and plain; code generation tests compare every lane with it.
//
// What ops.def leaves open is decided here, and compiled code follows:
// - LightLoop takes the samples in order. A lane skips a sample whose Cl is zero in all samples of
//   color, one whose light the loop's category does not accept, and, in a Classic loop, one
//   outside the cone: dot(normalize(L), axis) >= cos(angle) must hold, with the
//   arithmetic of normalize() and dot() of builder_vectors.h, fused if the function is.
// - An Extended loop whose first angle is <= 0 is a delta request: it takes no samples but its own
//   traced answer, once, with L = its first axis (unless the answer is black).
// - Random hashes the bits of the seed and of its operand, and its immediate: see randomNumber().
#pragma once

#include "language/ir/core/ir.h"
#include "language/runtime/shader_abi.h"

#include <cstdint>

namespace candela::ir {

void interpret(const Function &, const ShaderArgs &);

/// The number in [0,1) that Random gives for a seed plane's value and its operand.
inline float randomNumber(std::uint32_t seedBits, std::int32_t immediate, float turn) {
    std::uint32_t h = seedBits + std::uint32_t(immediate) * 0x9e3779b9u +
                      std::bit_cast<std::uint32_t>(turn) * 0x85ebca77u;
    h = (h ^ (h >> 16)) * 0x7feb352du;
    h = (h ^ (h >> 15)) * 0x846ca68bu;
    h ^= h >> 16;
    return float(h >> 8) * 0x1p-24f;
}

} // namespace candela::ir
