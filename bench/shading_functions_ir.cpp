// SPDX-License-Identifier: Apache-2.0
#include "shading_functions.h"

#include "language/ir/core/builder_arithmetic.h"
#include "language/ir/core/builder_control.h"
#include "language/ir/core/builder_effects.h"
#include "language/ir/core/builder_light.h"
#include "language/ir/core/builder_sources.h"
#include "language/ir/core/builder_vectors.h"
#include "language/runtime/runtime_functions.h"

namespace candela::bench {

using ir::Builder;
using ir::Op;
using ir::Triple;
using ir::ValueId;
using ir::Values;

static void outputColor(Builder &b, const Triple &color) {
    for (int k = 0; k < 3; ++k)
        output(b, "Ci", k, color[k]);
    b.finish();
}

ir::Function constantShader() {
    ir::Function function;
    Builder b(function);
    outputColor(b, mul(b, input3(b, ShaderInput::Cs), input3(b, ShaderInput::Os)));
    return function;
}

ir::Function matteShader() {
    ir::Function function;
    function.parameters = {{"Kd", 0}};
    Builder b(function);
    const Triple I = input3(b, ShaderInput::I);
    const Triple N = normalize(b, input3(b, ShaderInput::N));
    const Triple facing = faceforward(b, N, I, N);
    const ValueId zero = number(b, 0);
    const auto lit =
        lightLoop(b, addRequest(b, {}), input3(b, ShaderInput::P), {}, {zero, zero, zero},
                  [&](const Triple &L, const Values &Cl, const Values &sum) {
                      const ValueId cosine = max(b, dot(b, facing, normalize(b, L)), zero);
                      Values next;
                      for (int k = 0; k < 3; ++k)
                          next.push_back(add(b, sum[k], mul(b, Cl[k], cosine)));
                      return next;
                  });
    const Triple color{lit[0], lit[1], lit[2]};
    outputColor(b, mul(b, input3(b, ShaderInput::Cs), scale(b, color, parameter(b, 0))));
    return function;
}

/// Catmull-Rom through knots i .. i+3 at t.
static ValueId spline(Builder &b, const ValueId *knot, ValueId t) {
    const auto weighted = [&](float w0, float w1, float w2, float w3) {
        const auto term = [&](float w, ValueId k) { return mul(b, number(b, w), k); };
        return add(b, add(b, add(b, term(w0, knot[0]), term(w1, knot[1])), term(w2, knot[2])),
                   term(w3, knot[3]));
    };
    ValueId sum = weighted(-0.5f, 1.5f, -1.5f, 0.5f);
    sum = add(b, mul(b, sum, t), weighted(1, -2.5f, 2, -0.5f));
    sum = add(b, mul(b, sum, t), weighted(-0.5f, 0, 0.5f, 0));
    return add(b, mul(b, sum, t), knot[1]);
}

ir::Function marbleShader() {
    ir::Function function;
    function.parameters = {{"frequency", 0}};
    Builder b(function);
    const ValueId one = number(b, 1), half = number(b, 0.5f);
    const Triple P = scale(b, input3(b, ShaderInput::P), parameter(b, 0));
    const ValueId octaves = number(b, marbleOctaves);
    const auto sum =
        loop(b, {boolean(b, true), number(b, 0), one, number(b, 0)}, [&](const Values &carried) {
            const Triple at = scale(b, P, carried[2]);
            const ValueId noise =
                callRuntime(b, int(runtime::RuntimeFunction::noise3), {at[0], at[1], at[2]})[0];
            const ValueId part = div(b, unary(b, Op::Abs, sub(b, half, noise)), carried[2]);
            const ValueId count = add(b, carried[1], one);
            return Values{less(b, count, octaves), count, mul(b, carried[2], number(b, 2)),
                          add(b, carried[3], part)};
        });
    const ValueId raw = sub(b, mul(b, number(b, 4), sum[3]), half);
    const ValueId x = mul(b, min(b, max(b, raw, number(b, 0)), one), number(b, marbleKnots - 3));
    const ValueId segment = min(b, unary(b, Op::Floor, x), number(b, marbleKnots - 4));
    const ValueId t = sub(b, x, segment);
    Triple color;
    for (int channel = 0; channel < 3; ++channel) {
        const int array = addArray(b, ir::Type::Float, marbleKnots);
        for (int k = 0; k < marbleKnots; ++k)
            arrayStore(b, array, integer(b, k), number(b, marbleColors[channel][k]));
        ValueId knots[4];
        for (int k = 0; k < 4; ++k) {
            const ValueId index =
                unary(b, Op::IntegerFromFloat, add(b, segment, number(b, float(k))));
            knots[k] = arrayLoad(b, array, index);
        }
        color[channel] = spline(b, knots, t);
    }
    outputColor(b, color);
    return function;
}

} // namespace candela::bench
