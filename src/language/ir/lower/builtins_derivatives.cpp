// SPDX-License-Identifier: Apache-2.0
// Du(), Dv(), Deriv(), area() and calculatenormal().
#include "language/ir/core/builder_arithmetic.h"
#include "language/ir/core/builder_sources.h"
#include "language/ir/core/builder_vectors.h"
#include "language/ir/lower/builtins.h"
#include "language/ir/lower/derivatives.h"

namespace candela::ir {
namespace {

Components Du(BuiltinCall &call) { return derivative(call.b, call.arguments[0], derivativeByU); }
Components Dv(BuiltinCall &call) { return derivative(call.b, call.arguments[0], derivativeByV); }

/// Du(x)/Du(by) + Dv(x)/Dv(by); a direction in which `by` does not change adds nothing.
Components Deriv(BuiltinCall &call) {
    Builder &b = call.b;
    Components result;
    for (int direction : {derivativeByU, derivativeByV}) {
        const Components x = derivative(b, call.arguments[0], direction);
        const ValueId by = derivative(b, call.arguments[1], direction)[0];
        const ValueId still = equal(b, by, number(b, 0));
        for (size_t c = 0; c < x.size(); ++c) {
            const ValueId share = select(b, still, number(b, 0), div(b, x[c], by));
            if (direction == derivativeByU)
                result.push_back(share);
            else
                result[c] = add(b, result[c], share);
        }
    }
    return result;
}

Triple sweep(BuiltinCall &call) {
    return cross(call.b, tripleOf(derivative(call.b, call.arguments[0], derivativeByU)),
                 tripleOf(derivative(call.b, call.arguments[0], derivativeByV)));
}

/// |Du(p) du ^ Dv(p) dv|. The strategy ("shading" or "dicing") makes no difference here: du and dv
/// are those of the point that is shaded.
Components area(BuiltinCall &call) {
    Builder &b = call.b;
    const ValueId extent = mul(b, input(b, ShaderInput::du), input(b, ShaderInput::dv));
    return {mul(b, length(b, sweep(call)), unary(b, Op::Abs, extent))};
}

/// Du(p) ^ Dv(p), on the side of the surface that its normals are on.
Components calculatenormal(BuiltinCall &call) {
    return componentsOf(scale(call.b, sweep(call), input(call.b, ShaderInput::orientation)));
}

} // namespace

BuiltinLowering derivativeBuiltin(sl::BuiltinId id) {
    switch (id) {
    case sl::BuiltinId::Du: return Du;
    case sl::BuiltinId::Dv: return Dv;
    case sl::BuiltinId::Deriv: return Deriv;
    case sl::BuiltinId::area: return area;
    case sl::BuiltinId::calculatenormal: return calculatenormal;
    default: return nullptr;
    }
}

} // namespace candela::ir
