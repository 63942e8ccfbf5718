// SPDX-License-Identifier: Apache-2.0
// Arithmetic on floats, truth, choice, and calls of runtime functions.
#pragma once

#include "language/ir/core/builder.h"

namespace candela::ir {

/// Any operation of one operand: unary(b, Op::Sin, x).
inline ValueId unary(Builder &b, Op op, ValueId x) { return b.emit(op, {x})[0]; }
inline ValueId binary(Builder &b, Op op, ValueId x, ValueId y) { return b.emit(op, {x, y})[0]; }

inline ValueId add(Builder &b, ValueId x, ValueId y) { return binary(b, Op::Add, x, y); }
inline ValueId sub(Builder &b, ValueId x, ValueId y) { return binary(b, Op::Sub, x, y); }
inline ValueId mul(Builder &b, ValueId x, ValueId y) { return binary(b, Op::Mul, x, y); }
inline ValueId div(Builder &b, ValueId x, ValueId y) { return binary(b, Op::Div, x, y); }
inline ValueId neg(Builder &b, ValueId x) { return unary(b, Op::Neg, x); }
inline ValueId min(Builder &b, ValueId x, ValueId y) { return binary(b, Op::Min, x, y); }
inline ValueId max(Builder &b, ValueId x, ValueId y) { return binary(b, Op::Max, x, y); }
inline ValueId sqrt(Builder &b, ValueId x) { return unary(b, Op::Sqrt, x); }
inline ValueId pow(Builder &b, ValueId x, ValueId y) { return binary(b, Op::Pow, x, y); }

inline ValueId less(Builder &b, ValueId x, ValueId y) { return binary(b, Op::Less, x, y); }
inline ValueId lessEqual(Builder &b, ValueId x, ValueId y) {
    return binary(b, Op::LessEqual, x, y);
}
inline ValueId equal(Builder &b, ValueId x, ValueId y) { return binary(b, Op::Equal, x, y); }
inline ValueId notEqual(Builder &b, ValueId x, ValueId y) { return binary(b, Op::NotEqual, x, y); }
inline ValueId both(Builder &b, ValueId x, ValueId y) { return binary(b, Op::And, x, y); }
inline ValueId either(Builder &b, ValueId x, ValueId y) { return binary(b, Op::Or, x, y); }
inline ValueId negate(Builder &b, ValueId x) { return unary(b, Op::Not, x); }
inline ValueId select(Builder &b, ValueId condition, ValueId x, ValueId y) {
    return b.emit(Op::Select, {condition, x, y})[0];
}

inline Values callRuntime(Builder &b, int runtimeFunction, const Values &inputs) {
    return b.emit(Op::Call, inputs, runtimeFunction);
}

} // namespace candela::ir
