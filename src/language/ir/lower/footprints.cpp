// SPDX-License-Identifier: Apache-2.0
#include "language/ir/lower/footprints.h"

#include "language/ir/core/builder_arithmetic.h"
#include "language/ir/core/builder_sources.h"

namespace candela::ir {

static bool hasFootprint(const Lowering &lowering) {
    const sl::ShaderKind kind = lowering.shader.kind;
    return lowering.options.footprints && !lowering.spaces.isShaderOnly() &&
           (kind == sl::ShaderKind::Surface || kind == sl::ShaderKind::Displacement);
}

Extent extentOf(Lowering &lowering, ValueId quantity) {
    Builder &b = lowering.b;
    const ValueId none = number(b, 0);
    if (!hasFootprint(lowering) || constantFloat(b, quantity))
        return {none, none, none};
    lowering.usesFootprints = true;
    const ValueId byU = slope(b, quantity, Direction::U), byV = slope(b, quantity, Direction::V);
    const auto along = [&](ShaderInput u, ShaderInput v) {
        return add(b, mul(b, byU, input(b, u)), mul(b, byV, input(b, v)));
    };
    return {along(ShaderInput::dudx, ShaderInput::dvdx),
            along(ShaderInput::dudy, ShaderInput::dvdy),
            along(ShaderInput::uShift, ShaderInput::vShift)};
}

} // namespace candela::ir
