// SPDX-License-Identifier: Apache-2.0
#include "language/ir/core/builder_fold.h"

#include "language/ir/core/builder_sources.h"
#include "language/ir/core/evaluate.h"
#include "language/ir/core/op_info.h"
#include "language/ir/core/regions.h"

#include <cmath>

namespace candela::ir {

namespace {

using Folded = std::optional<ValueId>;

Folded foldArithmetic(Builder &b, Op op, const std::vector<ValueId> &operands) {
    const float *left = constantFloat(b, operands[0]);
    const float *right = operands.size() > 1 ? constantFloat(b, operands[1]) : left;
    if (left && right)
        return number(b, evaluateFloat(op, *left, *right));
    // x + 0 is no identity: it turns -0 into 0.
    if (op == Op::Mul && left && *left == 1)
        return operands[1];
    if ((op == Op::Mul || op == Op::Div) && right && *right == 1)
        return operands[0];
    if (op == Op::Sub && right && *right == 0 && !std::signbit(*right))
        return operands[0];
    return {};
}

Folded foldComparison(Builder &b, Op op, ValueId left, ValueId right) {
    const float *x = constantFloat(b, left), *y = constantFloat(b, right);
    return x && y ? Folded(boolean(b, evaluateCompare(op, *x, *y))) : Folded{};
}

Folded foldLogic(Builder &b, Op op, ValueId left, ValueId right) {
    auto decided = op == Op::And ? false : true; // The operand that decides alone.
    for (auto [one, other] : {std::pair{left, right}, std::pair{right, left}})
        if (auto known = constantBool(b, one))
            return *known == decided ? boolean(b, decided) : other;
    return left == right ? Folded(left) : Folded{};
}

Folded foldSelect(Builder &b, ValueId condition, ValueId yes, ValueId no) {
    if (auto known = constantBool(b, condition))
        return *known ? yes : no;
    return yes == no ? Folded(yes) : Folded{};
}

} // namespace

std::optional<ValueId> foldOperation(Builder &b, Op op, const std::vector<ValueId> &operands) {
    if (isFloatArithmetic(op))
        return foldArithmetic(b, op, operands);
    if (isFloatComparison(op))
        return foldComparison(b, op, operands[0], operands[1]);
    switch (op) {
    case Op::And:
    case Op::Or: return foldLogic(b, op, operands[0], operands[1]);
    case Op::Not: {
        auto known = constantBool(b, operands[0]);
        return known ? Folded(boolean(b, !*known)) : Folded{};
    }
    case Op::Select: return foldSelect(b, operands[0], operands[1], operands[2]);
    case Op::FloatFromBool: {
        auto known = constantBool(b, operands[0]);
        return known ? Folded(number(b, *known ? 1.0f : 0.0f)) : Folded{};
    }
    case Op::IntegerFromFloat: {
        const float *known = constantFloat(b, operands[0]);
        return known ? Folded(integer(b, integerFromFloat(*known))) : Folded{};
    }
    case Op::StringEqual: {
        const std::string *left = constantText(b, operands[0]);
        const std::string *right = constantText(b, operands[1]);
        return left && right ? Folded(boolean(b, *left == *right)) : Folded{};
    }
    default: return {};
    }
}

void markInputsRead(Function &function) {
    function.inputsRead.assign(std::size_t(ShaderInput::Count), false);
    forEachInstruction(function.body, [&](const Instruction &i) {
        if (i.op == Op::Input)
            function.inputsRead[i.immediate] = true;
        if (i.op == Op::Random)
            function.inputsRead[std::size_t(ShaderInput::seed)] = true;
    });
}

} // namespace candela::ir
