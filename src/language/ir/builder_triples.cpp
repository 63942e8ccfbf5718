// SPDX-License-Identifier: Apache-2.0
// The builder's arithmetic on points, vectors, normals and colors.
#include "language/ir/builder.h"

namespace candela::ir {

Triple Builder::triple(float x, float y, float z) { return {number(x), number(y), number(z)}; }

Triple Builder::select(ValueId condition, const Triple &a, const Triple &b) {
    return {select(condition, a[0], b[0]), select(condition, a[1], b[1]),
            select(condition, a[2], b[2])};
}
Triple Builder::add(const Triple &a, const Triple &b) {
    return {add(a[0], b[0]), add(a[1], b[1]), add(a[2], b[2])};
}
Triple Builder::sub(const Triple &a, const Triple &b) {
    return {sub(a[0], b[0]), sub(a[1], b[1]), sub(a[2], b[2])};
}
Triple Builder::mul(const Triple &a, const Triple &b) {
    return {mul(a[0], b[0]), mul(a[1], b[1]), mul(a[2], b[2])};
}
Triple Builder::div(const Triple &a, const Triple &b) {
    return {div(a[0], b[0]), div(a[1], b[1]), div(a[2], b[2])};
}
Triple Builder::scale(const Triple &a, ValueId s) {
    return {mul(a[0], s), mul(a[1], s), mul(a[2], s)};
}
Triple Builder::neg(const Triple &a) { return {neg(a[0]), neg(a[1]), neg(a[2])}; }

ValueId Builder::dot(const Triple &a, const Triple &b) {
    return add(add(mul(a[0], b[0]), mul(a[1], b[1])), mul(a[2], b[2]));
}

Triple Builder::cross(const Triple &a, const Triple &b) {
    return {sub(mul(a[1], b[2]), mul(a[2], b[1])), sub(mul(a[2], b[0]), mul(a[0], b[2])),
            sub(mul(a[0], b[1]), mul(a[1], b[0]))};
}

ValueId Builder::length(const Triple &a) { return sqrt(dot(a, a)); }

Triple Builder::normalize(const Triple &a) {
    ValueId size = length(a);
    ValueId divisor = select(equal(size, number(0)), number(1), size);
    return scale(a, div(number(1), divisor));
}

Triple Builder::reflect(const Triple &I, const Triple &N) {
    return sub(I, scale(N, mul(number(2), dot(I, N))));
}

Triple Builder::faceforward(const Triple &N, const Triple &I, const Triple &reference) {
    return select(less(number(0), dot(I, reference)), neg(N), N);
}

Triple Builder::transformPoint(const Matrix &m, const Triple &p) {
    auto column = [&](int j) {
        return add(add(add(mul(p[0], m[j]), mul(p[1], m[4 + j])), mul(p[2], m[8 + j])), m[12 + j]);
    };
    ValueId w = column(3);
    return {div(column(0), w), div(column(1), w), div(column(2), w)};
}

Triple Builder::transformVector(const Matrix &m, const Triple &v) {
    auto column = [&](int j) {
        return add(add(mul(v[0], m[j]), mul(v[1], m[4 + j])), mul(v[2], m[8 + j]));
    };
    return {column(0), column(1), column(2)};
}

Triple Builder::transformNormal(const Matrix &inverse, const Triple &n) {
    auto row = [&](int i) {
        return add(add(mul(n[0], inverse[4 * i]), mul(n[1], inverse[4 * i + 1])),
                   mul(n[2], inverse[4 * i + 2]));
    };
    return {row(0), row(1), row(2)};
}

} // namespace candela::ir
