// SPDX-License-Identifier: Apache-2.0
// Expressions: a Pratt parser over the table of operators.h.
#pragma once

#include <string>
#include <vector>

#include "language/syntax/ast.h"
#include "language/syntax/lookahead.h"
#include "language/syntax/operators.h"
#include "language/syntax/token_cursor.h"

namespace candela::sl {

class ExpressionParser {
public:
    ExpressionParser(TokenCursor &tokens, const Lookahead &ahead)
        : tokens_(tokens), ahead_(ahead) {}

    /// Up to the first operator that binds looser than `least`.
    ast::ExprPtr expression(Precedence least = Precedence::Assignment);
    /// What is evaluated for its effect, in a statement or a step of `for`: ++i and --i count up
    /// and down there, as in C.
    ast::ExprPtr effect();
    /// From the '(' of a call of `name` to its ')'.
    std::vector<ast::ExprPtr> arguments(const std::string &name);

private:
    ast::ExprPtr infix(ast::ExprPtr left, const Infix &, const Place &);
    ast::ExprPtr unary();
    ast::ExprPtr cast();
    ast::ExprPtr postfix();
    bool atSigns(const char *sign) const;
    ast::ExprPtr step(ast::ExprPtr value, BinaryOp, const Place &);
    ast::ExprPtr counted(ast::ExprPtr variable, BinaryOp, const Place &);
    ast::ExprPtr primary();
    ast::ExprPtr text();
    bool atBracketedType() const;
    ast::ExprPtr brackets();
    ast::ExprPtr make(ast::ExprKind, const Place &, std::vector<ast::ExprPtr> operands = {});

    TokenCursor &tokens_;
    const Lookahead &ahead_;
};

} // namespace candela::sl
