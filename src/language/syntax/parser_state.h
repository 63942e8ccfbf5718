// SPDX-License-Identifier: Apache-2.0
// The parser itself, for its own source files only: parser_expressions.cpp, parser_statements.cpp,
// parser_declarations.cpp.
#pragma once

#include <initializer_list>
#include <set>
#include <string>
#include <vector>

#include "language/syntax/ast.h"
#include "language/syntax/operators.h"
#include "language/syntax/reporter.h"
#include "language/syntax/token.h"

namespace candela::sl {

class Parser {
public:
    Parser(const std::vector<Token> &tokens, Reporter &reporter)
        : tokens_(tokens), reporter_(reporter) {}

    ast::File file();

private:
    /// Thrown after a report, caught where parsing can start again; never leaves the parser.
    struct Panic {};
    using Names = std::initializer_list<const char *>;

    // The cursor.
    const Token &peek(size_t ahead = 0) const;
    const Token &take();
    bool at(const char *spelling, size_t ahead = 0) const { return peek(ahead).is(spelling); }
    bool atAny(Names, size_t ahead = 0) const;
    bool accept(const char *spelling);
    bool atEnd(size_t ahead = 0) const { return peek(ahead).kind == TokenKind::End; }
    Place afterPrevious() const;
    void expect(const char *spelling, const std::string &context);
    void expectSemicolon(const std::string &context);
    [[noreturn]] void fail(const Place &, const std::string &message);
    [[noreturn]] void unexpected(const std::string &expected);
    /// Index behind the bracket that closes the one at `ahead`; 0 if there is none.
    size_t behindBrackets(size_t ahead) const;

    // Words: only control words are reserved; all else is decided by what follows.
    bool isReserved(size_t ahead = 0) const;
    bool isName(size_t ahead = 0) const;
    bool isTypeWord(size_t ahead = 0) const;
    std::string takeName(const std::string &what, Place &where);

    // Expressions.
    ast::ExprPtr expression(Precedence least = Precedence::Assignment);
    ast::ExprPtr infix(ast::ExprPtr left, const Infix &, const Place &);
    ast::ExprPtr unary();
    ast::ExprPtr postfix();
    ast::ExprPtr primary();
    ast::ExprPtr brackets();
    ast::ExprPtr cast();
    ast::ExprPtr text();
    std::vector<ast::ExprPtr> arguments(const std::string &name);
    ast::ExprPtr make(ast::ExprKind, const Place &, std::vector<ast::ExprPtr> operands = {});

    // Statements.
    ast::StmtPtr statement();
    ast::StmtPtr statementProper();
    ast::StmtPtr block();
    ast::StmtPtr ifStatement();
    ast::StmtPtr whileStatement();
    ast::StmtPtr forStatement();
    ast::StmtPtr jumpStatement(ast::StmtKind);
    ast::StmtPtr returnStatement();
    ast::StmtPtr lightStatement(ast::StmtKind);
    ast::StmtPtr expressionStatement();
    ast::StmtPtr make(ast::StmtKind);
    ast::ExprPtr condition(const char *word);
    void recoverInBlock(size_t start);
    void skipBlock();

    // Declarations.
    bool startsDeclaration() const;
    bool startsFunction() const;
    ast::Variable specifiers();
    ast::StmtPtr declaration();
    void declarator(ast::Variable &, bool isFormal);
    void initialiser(ast::Variable &);
    std::vector<ast::Variable> formals(const std::string &owner);
    void oneFormal(std::vector<ast::Variable> &, ast::Variable &pattern, bool &typed);
    void oldStyleFormals(std::vector<ast::Variable> &);
    void recoverInFormals();
    bool startsSpecifier() const;
    ast::Function function();
    ast::Shader shader();
    bool startsShader(size_t ahead = 0) const;
    void recoverAtTop();
    void attachComments(std::vector<ast::Variable> &) const;
    std::string commentBefore(const Place &) const;

    /// Counts nesting for as long as it lives; too much of it is an error, not a stack overflow.
    struct Nesting {
        explicit Nesting(Parser &parser);
        ~Nesting() { --parser_.depth_; }
        Parser &parser_;
    };

    /// Variables that are declared while it lives are forgotten with it.
    struct DeclaredNames {
        explicit DeclaredNames(Parser &parser) : parser_(parser), outer_(parser.namedAsTypes_) {}
        ~DeclaredNames() { parser_.namedAsTypes_ = std::move(outer_); }
        Parser &parser_;
        std::set<std::string> outer_;
    };

    const std::vector<Token> &tokens_;
    Reporter &reporter_;
    std::set<std::string> namedAsTypes_; ///< Type words that are names of variables here.
    size_t at_ = 0;
    int depth_ = 0;
};

} // namespace candela::sl
