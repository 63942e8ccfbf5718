// SPDX-License-Identifier: Apache-2.0
#include "language/ir/core/evaluate.h"

#include "language/runtime/scalar_math.h"

#include <cmath>
#include <limits>

namespace candela::ir {

float evaluateFloat(Op op, float a, float b) {
    switch (op) {
    case Op::Add: return a + b;
    case Op::Sub: return a - b;
    case Op::Mul: return a * b;
    case Op::Div: return a / b;
    case Op::Neg: return -a;
    case Op::Abs: return std::fabs(a);
    case Op::Min: return a < b ? a : b;
    case Op::Max: return a > b ? a : b;
    case Op::Floor: return std::floor(a);
    case Op::Ceil: return std::ceil(a);
    case Op::Round: return std::floor(a + belowHalf);
    case Op::Sqrt: return a < 0 ? 0 : std::sqrt(a);
    case Op::Sloped: return a;
    case Op::Sin: return runtime::sin(a);
    case Op::Cos: return runtime::cos(a);
    case Op::Tan: return runtime::tan(a);
    case Op::Asin: return runtime::asin(a);
    case Op::Acos: return runtime::acos(a);
    case Op::Atan: return runtime::atan(a);
    case Op::Atan2: return runtime::atan2(a, b);
    case Op::Exp: return runtime::exp(a);
    case Op::Log: return runtime::log(a);
    case Op::Pow: return runtime::pow(a, b);
    default: return std::numeric_limits<float>::quiet_NaN();
    }
}

bool evaluateCompare(Op op, float a, float b) {
    switch (op) {
    case Op::Less: return a < b;
    case Op::LessEqual: return a <= b;
    case Op::Equal: return a == b;
    default: return a != b;
    }
}

int integerFromFloat(float a) {
    if (a != a)
        return 0;
    if (a >= 2147483648.0f)
        return std::numeric_limits<int>::max();
    if (a < -2147483648.0f)
        return std::numeric_limits<int>::min();
    return int(a);
}

} // namespace candela::ir
