// SPDX-License-Identifier: Apache-2.0
// The shader inputs that change with u and v, and the inputs that say how.
#pragma once

#include "language/ir/core/ir.h"
#include "language/runtime/shader_abi.h"

#include <optional>

namespace candela::ir {

/// What is known of the derivatives of an input plane.
struct InputSlope {
    enum Kind {
        Still,     ///< It does not change.
        Parameter, ///< It is u or v itself.
        Plane,     ///< Other planes hold its first derivatives; higher ones are not known.
        Unknown,
    } kind = Unknown;
    int byU = 0, byV = 0; ///< Parameter: the derivatives. Plane: the planes.

    int by(Direction d) const { return d == Direction::U ? byU : byV; }
};
InputSlope inputSlope(int plane);

} // namespace candela::ir
