// SPDX-License-Identifier: Apache-2.0
#include "language/syntax/operators.h"

namespace candela::sl {

static constexpr Infix infixes[] = {
    {"=", Precedence::Assignment, InfixKind::Assign},
    {"+=", Precedence::Assignment, InfixKind::Assign, BinaryOp::Add, true},
    {"-=", Precedence::Assignment, InfixKind::Assign, BinaryOp::Subtract, true},
    {"*=", Precedence::Assignment, InfixKind::Assign, BinaryOp::Multiply, true},
    {"/=", Precedence::Assignment, InfixKind::Assign, BinaryOp::Divide, true},
    {"?", Precedence::Choice, InfixKind::Choice},
    {"||", Precedence::Or, InfixKind::Binary, BinaryOp::Or},
    {"&&", Precedence::And, InfixKind::Binary, BinaryOp::And},
    {"==", Precedence::Equality, InfixKind::Binary, BinaryOp::Equal},
    {"!=", Precedence::Equality, InfixKind::Binary, BinaryOp::NotEqual},
    {"<", Precedence::Relation, InfixKind::Binary, BinaryOp::Less},
    {"<=", Precedence::Relation, InfixKind::Binary, BinaryOp::LessEqual},
    {">", Precedence::Relation, InfixKind::Binary, BinaryOp::Greater},
    {">=", Precedence::Relation, InfixKind::Binary, BinaryOp::GreaterEqual},
    {"+", Precedence::Sum, InfixKind::Binary, BinaryOp::Add},
    {"-", Precedence::Sum, InfixKind::Binary, BinaryOp::Subtract},
    {"^", Precedence::Cross, InfixKind::Binary, BinaryOp::Cross},
    {"*", Precedence::Product, InfixKind::Binary, BinaryOp::Multiply},
    {"/", Precedence::Product, InfixKind::Binary, BinaryOp::Divide},
    {".", Precedence::Dot, InfixKind::Binary, BinaryOp::Dot},
};

const Infix *infixNamed(std::string_view spelling) {
    for (const Infix &infix : infixes)
        if (infix.spelling == spelling)
            return &infix;
    return nullptr;
}

} // namespace candela::sl
