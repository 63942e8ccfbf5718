// SPDX-License-Identifier: Apache-2.0
// Declarations of variables, and the formals of functions and shaders.
#pragma once

#include <string>
#include <vector>

#include "language/syntax/ast.h"
#include "language/syntax/expression_parser.h"
#include "language/syntax/lookahead.h"
#include "language/syntax/token_cursor.h"

namespace candela::sl {

class DeclarationParser {
public:
    DeclarationParser(TokenCursor &tokens, Lookahead &ahead, ExpressionParser &expressions)
        : tokens_(tokens), ahead_(ahead), expressions_(expressions) {}

    /// The variables of one declaration with its ';'.
    std::vector<ast::Variable> variables();
    /// What stands between the name of a function or shader and its body.
    std::vector<ast::Variable> formals(const std::string &owner);

private:
    ast::Variable specifiers();
    void declarator(ast::Variable &, bool isFormal);
    void initialiser(ast::Variable &, Precedence least);
    void oneFormal(std::vector<ast::Variable> &, ast::Variable &pattern, bool &typed);
    void oldStyleFormals(std::vector<ast::Variable> &);
    void recoverInFormals();

    TokenCursor &tokens_;
    Lookahead &ahead_;
    ExpressionParser &expressions_;
};

} // namespace candela::sl
