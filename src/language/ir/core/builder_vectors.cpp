// SPDX-License-Identifier: Apache-2.0
#include "language/ir/core/builder_vectors.h"

#include "language/ir/core/builder_arithmetic.h"
#include "language/ir/core/builder_sources.h"

namespace candela::ir {

namespace {

Triple componentwise(Builder &b, Op op, const Triple &x, const Triple &y) {
    return {binary(b, op, x[0], y[0]), binary(b, op, x[1], y[1]), binary(b, op, x[2], y[2])};
}

} // namespace

Triple select(Builder &b, ValueId condition, const Triple &x, const Triple &y) {
    return {select(b, condition, x[0], y[0]), select(b, condition, x[1], y[1]),
            select(b, condition, x[2], y[2])};
}
Triple add(Builder &b, const Triple &x, const Triple &y) { return componentwise(b, Op::Add, x, y); }
Triple sub(Builder &b, const Triple &x, const Triple &y) { return componentwise(b, Op::Sub, x, y); }
Triple mul(Builder &b, const Triple &x, const Triple &y) { return componentwise(b, Op::Mul, x, y); }
Triple div(Builder &b, const Triple &x, const Triple &y) { return componentwise(b, Op::Div, x, y); }
Triple scale(Builder &b, const Triple &x, ValueId s) {
    return componentwise(b, Op::Mul, x, {s, s, s});
}
Triple neg(Builder &b, const Triple &x) { return {neg(b, x[0]), neg(b, x[1]), neg(b, x[2])}; }

ValueId dot(Builder &b, const Triple &x, const Triple &y) {
    return add(b, add(b, mul(b, x[0], y[0]), mul(b, x[1], y[1])), mul(b, x[2], y[2]));
}

Triple cross(Builder &b, const Triple &x, const Triple &y) {
    return {sub(b, mul(b, x[1], y[2]), mul(b, x[2], y[1])),
            sub(b, mul(b, x[2], y[0]), mul(b, x[0], y[2])),
            sub(b, mul(b, x[0], y[1]), mul(b, x[1], y[0]))};
}

ValueId length(Builder &b, const Triple &x) { return sqrt(b, dot(b, x, x)); }

Triple normalize(Builder &b, const Triple &x) {
    if (b.unitVectors.has(x))
        return x;
    ValueId size = length(b, x);
    ValueId divisor = select(b, equal(b, size, number(b, 0)), number(b, 1), size);
    const Triple unit = scale(b, x, div(b, number(b, 1), divisor));
    b.unitVectors.addNormalized(unit);
    return unit;
}

Triple reflect(Builder &b, const Triple &I, const Triple &N) {
    return sub(b, I, scale(b, N, mul(b, number(b, 2), dot(b, I, N))));
}

Triple faceforward(Builder &b, const Triple &N, const Triple &I, const Triple &reference) {
    return select(b, less(b, number(b, 0), dot(b, I, reference)), neg(b, N), N);
}

Triple transformPoint(Builder &b, const Matrix &m, const Triple &p) {
    auto column = [&](int j) { return add(b, dot(b, p, {m[j], m[4 + j], m[8 + j]}), m[12 + j]); };
    ValueId w = column(3);
    return {div(b, column(0), w), div(b, column(1), w), div(b, column(2), w)};
}

Triple transformVector(Builder &b, const Matrix &m, const Triple &v) {
    auto column = [&](int j) { return dot(b, v, {m[j], m[4 + j], m[8 + j]}); };
    return {column(0), column(1), column(2)};
}

Triple transformNormal(Builder &b, const Matrix &inverse, const Triple &n) {
    auto row = [&](int i) {
        return dot(b, n, {inverse[4 * i], inverse[4 * i + 1], inverse[4 * i + 2]});
    };
    return {row(0), row(1), row(2)};
}

} // namespace candela::ir
