// SPDX-License-Identifier: Apache-2.0
// Where generated code finds SLEEF: the variants whose results agree at every width.
#pragma once

#include "language/runtime/isa_level.h"

namespace candela::runtime {

enum class MathFunction { sin, cos, tan, asin, acos, atan, atan2, exp, log, pow, Count };

/// A raw SLEEF function: no clamping, no rule for negative bases (scalar_math.h has those). It
/// takes and gives vectors of `width` floats in registers (a float if 1).
struct MathCode {
    const char *name;
    void *address;
    int width;
};

/// Scalar code of a level.
MathCode scalarMath(MathFunction, IsaLevel);
/// Code at the level's native width: 4, 8 or 16.
MathCode vectorMath(MathFunction, IsaLevel);

} // namespace candela::runtime
