// SPDX-License-Identifier: Apache-2.0
#include "language/ir/core/op_info.h"

#include "language/runtime/scalar_math.h"

#include <array>
#include <cmath>
#include <limits>
#include <string>

namespace candela::ir {

namespace {

/// Signatures without their blanks, kept for the views in OpInfo.
std::string withoutBlanks(const char *text) {
    std::string result;
    for (; *text; ++text)
        if (*text != ' ')
            result += *text;
    return result;
}

struct OpTable {
    std::array<std::string, opCount> operands, results;
    std::array<OpInfo, opCount> info;

    OpTable() {
        int i = 0;
        auto row = [&](const char *name, const char *in, const char *out,
                       std::string_view meaning) {
            operands[i] = withoutBlanks(in);
            results[i] = withoutBlanks(out);
            info[i] = {name, operands[i], results[i], meaning.substr(0, 7) == "varying"};
            ++i;
        };
#define IR_OP(name, operands, results, meaning) row(#name, operands, results, meaning);
#include "language/ir/core/ops.def"
#undef IR_OP
    }
};

} // namespace

const OpInfo &info(Op op) {
    static const OpTable table;
    return table.info[int(op)];
}

Type typeOf(char letter) { return Type(std::string_view("fbis").find(letter)); }

bool isConstant(Op op) { return op <= Op::ConstString; }

bool isPure(Op op) {
    switch (op) {
    case Op::ArrayLoad:
    case Op::ArrayStore:
    case Op::If:
    case Op::Loop:
    case Op::LightLoop:
    case Op::Answer:
    case Op::Output:
    case Op::FrameStore:
    case Op::Print: return false;
    default: return true;
    }
}

bool hasEffect(Op op) {
    return op == Op::ArrayStore || op == Op::Output || op == Op::FrameStore || op == Op::Print;
}

bool isFloatArithmetic(Op op) { return op >= Op::Add && op <= Op::Pow; }

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
    case Op::Round: return std::floor(a + 0.5f);
    case Op::Sqrt: return a < 0 ? 0 : std::sqrt(a);
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
    default: return 0;
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
