// SPDX-License-Identifier: Apache-2.0
// For tests of derivatives: points of a curved patch, with all that changes over it and how, in
// closed form.
#pragma once

#include "language/ir/lower/test_support.h"

#include <initializer_list>

namespace candela::ir {

/// A quantity of up to three components at (u, v) with its derivatives.
struct PatchValue {
    ShaderInput input, byU, byV;
    Vec3 value, du, dv;
};

inline Vec3 vec(double x, double y = 0, double z = 0) { return {float(x), float(y), float(z)}; }

inline Vec3 patchP(double u, double v) {
    return vec(u + 0.2 * v * v, 2 * v - u * v, u * u + 0.5 * v);
}
inline Vec3 patchDu(double u, double v) { return vec(1, -v, 2 * u); }
inline Vec3 patchDv(double u, double v) { return vec(0.4 * v, 2 - u, 0.5); }

/// Primitive variables "pf" (float), in component 0, and "pq" (vector).
inline PatchValue patchVariable(const std::string &name, double u, double v) {
    const auto none = ShaderInput::P;
    if (name == "pf")
        return {none, none, none, vec(1 + u * u - v), vec(2 * u), vec(-1)};
    return {none, none, none, vec(u * v, v * v, 1 - u), vec(v, 0, -1), vec(u, 2 * v, 0)};
}

/// Puts lane `lane` of the run at (u, v).
inline void placeOnPatch(ShaderRun &run, int lane, double u, double v) {
    using In = ShaderInput;
    const auto set = [&](In input, Vec3 x, int components) {
        for (int c = 0; c < components; ++c)
            run.batch->inputs[size_t(input) + size_t(c)][size_t(lane)] = x[c];
    };
    const Vec3 P = patchP(u, v), Du = patchDu(u, v), Dv = patchDv(u, v);
    const PatchValue triples[] = {
        {In::P, In::dPdu, In::dPdv, P, Du, Dv},
        {In::I, In::dPdu, In::dPdv, P, Du, Dv},
        {In::N, In::dNdu, In::dNdv, vec(u * v, 1, v * v), vec(v), vec(u, 0, 2 * v)},
        {In::Ng, In::dNgdu, In::dNgdv, vec(v * v, u * u, 1 + u * v), vec(0, 2 * u, v),
         vec(2 * v, 0, u)},
        {In::Cs, In::dCsdu, In::dCsdv, vec(u * v, u + v * v, 0.5), vec(v, 1), vec(u, 2 * v)},
        {In::Os, In::dOsdu, In::dOsdv, vec(1 - u * v, v, u * u), vec(-v, 0, 2 * u), vec(-u, 1)},
    };
    const PatchValue numbers[] = {
        {In::s, In::dsdu, In::dsdv, vec(3 * u + v), vec(3), vec(1)},
        {In::t, In::dtdu, In::dtdv, vec(v * v), vec(0), vec(2 * v)},
    };
    set(In::u, vec(u), 1), set(In::v, vec(v), 1);
    for (const PatchValue &x : triples)
        set(x.input, x.value, 3), set(x.byU, x.du, 3), set(x.byV, x.dv, 3);
    for (const PatchValue &x : numbers)
        set(x.input, x.value, 1), set(x.byU, x.du, 1), set(x.byV, x.dv, 1);
    const auto &planes = run.lowered->whole.variables;
    for (size_t k = 0; k < planes.size(); ++k) {
        const PatchValue x = patchVariable(planes[k].name, u, v);
        const Vec3 held = !planes[k].slope                   ? x.value
                          : *planes[k].slope == Direction::U ? x.du
                                                             : x.dv;
        run.batch->variables[k][size_t(lane)] = held[planes[k].component];
    }
}

} // namespace candela::ir
