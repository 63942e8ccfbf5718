// SPDX-License-Identifier: Apache-2.0
#include "shading_functions.h"

#include "language/ir/builder.h"
#include "language/runtime/runtime_functions.h"

namespace candela::bench {

using ir::Builder;
using ir::Op;
using ir::Triple;
using ir::ValueId;

static void outputColor(Builder &b, const Triple &color) {
    for (int k = 0; k < 3; ++k)
        b.output("Ci", k, color[k]);
    b.finish();
}

ir::Function constantShader() {
    ir::Function function;
    Builder b(function);
    outputColor(b, b.mul(b.input3(ShaderInput::Cs), b.input3(ShaderInput::Os)));
    return function;
}

ir::Function matteShader() {
    ir::Function function;
    function.parameters = {{"Kd", 0}};
    Builder b(function);
    const Triple I = b.input3(ShaderInput::I);
    const Triple N = b.normalize(b.input3(ShaderInput::N));
    const Triple facing = b.faceforward(N, I, N);
    const ValueId zero = b.number(0);
    const auto lit =
        b.lightLoop(b.addRequest({}), b.input3(ShaderInput::P), {}, {zero, zero, zero},
                    [&](const Triple &L, const Builder::Values &Cl, const Builder::Values &sum) {
                        const ValueId cosine = b.max(b.dot(facing, b.normalize(L)), zero);
                        Builder::Values next;
                        for (int k = 0; k < 3; ++k)
                            next.push_back(b.add(sum[k], b.mul(Cl[k], cosine)));
                        return next;
                    });
    const Triple color{lit[0], lit[1], lit[2]};
    outputColor(b, b.mul(b.input3(ShaderInput::Cs), b.scale(color, b.parameter(0))));
    return function;
}

/// Catmull-Rom through knots i .. i+3 at t.
static ValueId spline(Builder &b, const ValueId *knot, ValueId t) {
    const auto weighted = [&](float w0, float w1, float w2, float w3) {
        const auto term = [&](float w, ValueId k) { return b.mul(b.number(w), k); };
        return b.add(b.add(b.add(term(w0, knot[0]), term(w1, knot[1])), term(w2, knot[2])),
                     term(w3, knot[3]));
    };
    ValueId sum = weighted(-0.5f, 1.5f, -1.5f, 0.5f);
    sum = b.add(b.mul(sum, t), weighted(1, -2.5f, 2, -0.5f));
    sum = b.add(b.mul(sum, t), weighted(-0.5f, 0, 0.5f, 0));
    return b.add(b.mul(sum, t), knot[1]);
}

ir::Function marbleShader() {
    ir::Function function;
    function.parameters = {{"frequency", 0}};
    Builder b(function);
    const ValueId one = b.number(1), half = b.number(0.5f);
    const Triple P = b.scale(b.input3(ShaderInput::P), b.parameter(0));
    const ValueId octaves = b.number(marbleOctaves);
    const auto sum = b.loop(
        {b.boolean(true), b.number(0), one, b.number(0)}, [&](const Builder::Values &carried) {
            const Triple at = b.scale(P, carried[2]);
            const ValueId noise =
                b.call(int(runtime::RuntimeFunction::noise3), {at[0], at[1], at[2]})[0];
            const ValueId part = b.div(b.unary(Op::Abs, b.sub(half, noise)), carried[2]);
            const ValueId count = b.add(carried[1], one);
            return Builder::Values{b.less(count, octaves), count, b.mul(carried[2], b.number(2)),
                                   b.add(carried[3], part)};
        });
    const ValueId raw = b.sub(b.mul(b.number(4), sum[3]), half);
    const ValueId x = b.mul(b.min(b.max(raw, b.number(0)), one), b.number(marbleKnots - 3));
    const ValueId segment = b.min(b.unary(Op::Floor, x), b.number(marbleKnots - 4));
    const ValueId t = b.sub(x, segment);
    Triple color;
    for (int channel = 0; channel < 3; ++channel) {
        const int array = b.addArray(ir::Type::Float, marbleKnots);
        for (int k = 0; k < marbleKnots; ++k)
            b.arrayStore(array, b.integer(k), b.number(marbleColors[channel][k]));
        ValueId knots[4];
        for (int k = 0; k < 4; ++k) {
            const ValueId index = b.unary(Op::IntegerFromFloat, b.add(segment, b.number(float(k))));
            knots[k] = b.arrayLoad(array, index);
        }
        color[channel] = spline(b, knots, t);
    }
    outputColor(b, color);
    return function;
}

} // namespace candela::bench
