// SPDX-License-Identifier: Apache-2.0
// Du(), Dv(), Deriv(), area() and calculatenormal().
#include "language/ir/lower_internal.h"

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
        const ValueId still = b.equal(by, b.number(0));
        for (size_t c = 0; c < x.size(); ++c) {
            const ValueId share = b.select(still, b.number(0), b.div(x[c], by));
            if (direction == derivativeByU)
                result.push_back(share);
            else
                result[c] = b.add(result[c], share);
        }
    }
    return result;
}

Triple sweep(BuiltinCall &call) {
    return call.b.cross(tripleOf(derivative(call.b, call.arguments[0], derivativeByU)),
                        tripleOf(derivative(call.b, call.arguments[0], derivativeByV)));
}

/// |Du(p) du ^ Dv(p) dv|. The strategy ("shading" or "dicing") makes no difference here: du and dv
/// are those of the point that is shaded.
Components area(BuiltinCall &call) {
    Builder &b = call.b;
    const ValueId extent = b.mul(b.input(ShaderInput::du), b.input(ShaderInput::dv));
    return {b.mul(b.length(sweep(call)), b.unary(Op::Abs, extent))};
}

/// Du(p) ^ Dv(p), on the side of the surface that its normals are on.
Components calculatenormal(BuiltinCall &call) {
    return componentsOf(call.b.scale(sweep(call), call.b.input(ShaderInput::orientation)));
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
