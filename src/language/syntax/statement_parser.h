// SPDX-License-Identifier: Apache-2.0
// Statements and the functions that nest in them, and how parsing starts again after an error.
#pragma once

#include <string>

#include "language/syntax/ast.h"
#include "language/syntax/declaration_parser.h"
#include "language/syntax/expression_parser.h"
#include "language/syntax/lookahead.h"
#include "language/syntax/token_cursor.h"

namespace candela::sl {

class StatementParser {
public:
    StatementParser(TokenCursor &tokens, Lookahead &ahead, ExpressionParser &expressions,
                    DeclarationParser &declarations)
        : tokens_(tokens), ahead_(ahead), expressions_(expressions), declarations_(declarations) {}

    /// A definition, from its type or name to its '}'.
    ast::Function function();
    /// The block of a shader or function; `owner` names it in the message if there is none.
    ast::StmtPtr body(const std::string &owner);

private:
    ast::StmtPtr block();
    ast::StmtPtr statement();
    ast::StmtPtr statementProper();
    ast::StmtPtr ifStatement();
    bool choice(ast::Stmt &);
    ast::StmtPtr whileStatement();
    ast::StmtPtr forStatement();
    ast::StmtPtr jumpStatement(ast::StmtKind);
    ast::StmtPtr returnStatement();
    ast::StmtPtr lightStatement(ast::StmtKind);
    ast::StmtPtr restOfBlock(const std::string &word);
    ast::StmtPtr declaration();
    ast::StmtPtr expressionStatement();
    ast::StmtPtr furtherExpressions(ast::StmtPtr first);
    ast::ExprPtr condition(const char *word);
    ast::StmtPtr make(ast::StmtKind) const;
    void recoverInBlock(size_t start);
    void skipBlock();

    TokenCursor &tokens_;
    Lookahead &ahead_;
    ExpressionParser &expressions_;
    DeclarationParser &declarations_;
};

} // namespace candela::sl
