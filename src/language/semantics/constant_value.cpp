// SPDX-License-Identifier: Apache-2.0
#include "language/semantics/constant_value.h"

namespace candela::sl {

std::optional<double> constantValue(const ast::Expr &e) {
    auto operand = [&](size_t i) { return constantValue(*e.operands[i]); };
    if (e.kind == ast::ExprKind::Number)
        return e.number;
    if (e.kind == ast::ExprKind::Negate) {
        const std::optional<double> positive = operand(0);
        return positive ? std::optional(-*positive) : std::nullopt;
    }
    if (e.kind != ast::ExprKind::Binary)
        return std::nullopt;
    std::optional<double> a = operand(0), b = operand(1);
    if (!a || !b)
        return std::nullopt;
    switch (e.op) {
    case BinaryOp::Add: return *a + *b;
    case BinaryOp::Subtract: return *a - *b;
    case BinaryOp::Multiply: return *a * *b;
    case BinaryOp::Divide: return *a / *b;
    default: return std::nullopt;
    }
}

bool constantIndexFits(const ast::Expr &index, int length, const std::string &what,
                       Reporter &reporter) {
    const std::optional<double> value = constantValue(index);
    if (!value || (*value >= 0 && *value < length))
        return true;
    reporter.error(index.where,
                   "index is outside of " + what + "; expected 0 to " + std::to_string(length - 1));
    return false;
}

} // namespace candela::sl
