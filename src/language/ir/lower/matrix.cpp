// SPDX-License-Identifier: Apache-2.0
#include "language/ir/lower/matrix.h"

#include "language/ir/core/builder_arithmetic.h"
#include "language/ir/core/builder_sources.h"
#include "language/ir/lower/builtins.h"

namespace candela::ir {

Matrix identityMatrix(Builder &b) {
    Matrix result;
    for (int i = 0; i < 16; ++i)
        result[i] = number(b, i % 5 == 0 ? 1.0f : 0.0f);
    return result;
}

Matrix multiply(Builder &b, const Matrix &x, const Matrix &y) {
    Matrix result;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column) {
            ValueId sum = mul(b, x[row * 4], y[column]);
            for (int k = 1; k < 4; ++k)
                sum = add(b, sum, mul(b, x[row * 4 + k], y[k * 4 + column]));
            result[row * 4 + column] = sum;
        }
    return result;
}

namespace {

/// The 2x2 minors of rows (r, r+1), for column pairs 01 02 03 12 13 23: all that cofactors need.
std::array<ValueId, 6> minors(Builder &b, const Matrix &m, int r) {
    const auto minor = [&](int i, int k) {
        return sub(b, mul(b, m[r * 4 + i], m[r * 4 + 4 + k]),
                   mul(b, m[r * 4 + k], m[r * 4 + 4 + i]));
    };
    return {minor(0, 1), minor(0, 2), minor(0, 3), minor(1, 2), minor(1, 3), minor(2, 3)};
}

/// Laplace expansion by the upper and lower pairs of rows.
ValueId determinantOf(Builder &b, const std::array<ValueId, 6> &s,
                      const std::array<ValueId, 6> &c) {
    ValueId sum = sub(b, mul(b, s[0], c[5]), mul(b, s[1], c[4]));
    sum = add(b, sum, mul(b, s[2], c[3]));
    sum = add(b, sum, mul(b, s[3], c[2]));
    sum = sub(b, sum, mul(b, s[4], c[1]));
    return add(b, sum, mul(b, s[5], c[0]));
}

} // namespace

ValueId determinant(Builder &b, const Matrix &m) {
    return determinantOf(b, minors(b, m, 0), minors(b, m, 2));
}

Matrix inverse(Builder &b, const Matrix &m) {
    const auto s = minors(b, m, 0), c = minors(b, m, 2);
    const ValueId scale = div(b, number(b, 1), determinantOf(b, s, c));
    // (x p - y q + z r), or its negative.
    const auto cofactor = [&](bool positive, int x, ValueId p, int y, ValueId q, int z, ValueId r) {
        const ValueId sum = add(b, sub(b, mul(b, m[x], p), mul(b, m[y], q)), mul(b, m[z], r));
        return mul(b, positive ? sum : neg(b, sum), scale);
    };
    return {
        cofactor(true, 5, c[5], 6, c[4], 7, c[3]),     cofactor(false, 1, c[5], 2, c[4], 3, c[3]),
        cofactor(true, 13, s[5], 14, s[4], 15, s[3]),  cofactor(false, 9, s[5], 10, s[4], 11, s[3]),
        cofactor(false, 4, c[5], 6, c[2], 7, c[1]),    cofactor(true, 0, c[5], 2, c[2], 3, c[1]),
        cofactor(false, 12, s[5], 14, s[2], 15, s[1]), cofactor(true, 8, s[5], 10, s[2], 11, s[1]),
        cofactor(true, 4, c[4], 5, c[2], 7, c[0]),     cofactor(false, 0, c[4], 1, c[2], 3, c[0]),
        cofactor(true, 12, s[4], 13, s[2], 15, s[0]),  cofactor(false, 8, s[4], 9, s[2], 11, s[0]),
        cofactor(false, 4, c[3], 5, c[1], 6, c[0]),    cofactor(true, 0, c[3], 1, c[1], 2, c[0]),
        cofactor(false, 12, s[3], 13, s[1], 14, s[0]), cofactor(true, 8, s[3], 9, s[1], 10, s[0])};
}

namespace {

Components determinantBuiltin(BuiltinCall &call) {
    return {determinant(call.b, matrixOf(call.arguments[0]))};
}

Components translateBuiltin(BuiltinCall &call) {
    Matrix translation = identityMatrix(call.b);
    for (int i = 0; i < 3; ++i)
        translation[12 + i] = call.arguments[1][i];
    return componentsOf(multiply(call.b, matrixOf(call.arguments[0]), translation));
}

Components scaleBuiltin(BuiltinCall &call) {
    Matrix scaling = identityMatrix(call.b);
    for (int i = 0; i < 3; ++i)
        scaling[i * 5] = call.arguments[1][i];
    return componentsOf(multiply(call.b, matrixOf(call.arguments[0]), scaling));
}

} // namespace

BuiltinLowering matrixBuiltin(sl::BuiltinId id) {
    switch (id) {
    case sl::BuiltinId::determinant: return determinantBuiltin;
    case sl::BuiltinId::translate: return translateBuiltin;
    case sl::BuiltinId::scale: return scaleBuiltin;
    default: return nullptr;
    }
}

} // namespace candela::ir
