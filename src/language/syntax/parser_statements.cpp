// SPDX-License-Identifier: Apache-2.0
// Statements, and how parsing starts again after an error in one.
#include <algorithm>
#include <cmath>

#include "language/syntax/parser_state.h"

namespace candela::sl {

using ast::StmtKind;

ast::StmtPtr Parser::make(StmtKind kind) {
    auto result = std::make_unique<ast::Stmt>();
    result->kind = kind;
    result->where = peek().where;
    return result;
}

/// A statement; after an error, an empty one with the cursor where the next may begin.
ast::StmtPtr Parser::statement() {
    size_t start = at_;
    try {
        return statementProper();
    } catch (Panic) {
        recoverInBlock(start);
        return make(StmtKind::Empty);
    }
}

void Parser::recoverInBlock(size_t start) {
    if (at_ == start && at("{"))
        return skipBlock(); // Nested too deeply: parsing it again would lead here again.
    if (at_ == start && !at("}"))
        take();
    int depth = 0; // Of brackets: a ';' in the head of a `for` does not end the statement.
    for (size_t i = start; i < at_; ++i)
        depth = std::max(0, depth + tokens_[i].is("(") - tokens_[i].is(")"));
    while (!atEnd() && !at("}") && !at("{")) {
        bool startsNext =
            startsDeclaration() || atAny({"if", "while", "for", "return", "break", "continue",
                                          "illuminance", "illuminate", "solar"});
        if (peek().startsLine && startsNext)
            return;
        depth = std::max(0, depth + at("(") - at(")"));
        if (take().is(";") && (depth == 0 || peek().startsLine))
            return;
    }
}

void Parser::skipBlock() {
    int depth = 0;
    do {
        depth += at("{") - at("}");
        take();
    } while (depth > 0 && !atEnd());
}

ast::StmtPtr Parser::statementProper() {
    Nesting nesting(*this);
    if (at("{"))
        return block();
    if (at(";")) {
        ast::StmtPtr result = make(StmtKind::Empty);
        take();
        return result;
    }
    if (at("if"))
        return ifStatement();
    if (at("while"))
        return whileStatement();
    if (at("for"))
        return forStatement();
    if (at("break"))
        return jumpStatement(StmtKind::Break);
    if (at("continue"))
        return jumpStatement(StmtKind::Continue);
    if (at("return"))
        return returnStatement();
    if (at("else"))
        fail(peek().where, "'else' without an 'if' before it");
    if (at("(", 1)) {
        if (at("illuminance"))
            return lightStatement(StmtKind::Illuminance);
        if (at("illuminate"))
            return lightStatement(StmtKind::Illuminate);
        if (at("solar"))
            return lightStatement(StmtKind::Solar);
        if (at("gather"))
            return lightStatement(StmtKind::Gather);
    }
    if (startsFunction()) {
        ast::StmtPtr result = make(StmtKind::Function);
        result->function = std::make_unique<ast::Function>(function());
        return result;
    }
    return startsDeclaration() ? declaration() : expressionStatement();
}

ast::StmtPtr Parser::block() {
    DeclaredNames own(*this);
    ast::StmtPtr result = make(StmtKind::Block);
    int line = take().where.line;
    while (!atEnd() && !at("}") && !reporter_.hopeless())
        result->body.push_back(statement());
    if (!accept("}") && !reporter_.hopeless())
        reporter_.error(peek().where, "expected '}' to close the block that line " +
                                          std::to_string(line) + " opens, not the end of the file");
    return result;
}

ast::ExprPtr Parser::condition(const char *word) {
    take();
    expect("(", std::string("after '") + word + "'");
    ast::ExprPtr result = expression();
    expect(")", std::string("after the condition of '") + word + "'");
    return result;
}

ast::StmtPtr Parser::ifStatement() {
    ast::StmtPtr result = make(StmtKind::If);
    result->value = condition("if");
    result->body.push_back(statement());
    if (accept("else"))
        result->body.push_back(statement());
    return result;
}

ast::StmtPtr Parser::whileStatement() {
    ast::StmtPtr result = make(StmtKind::While);
    result->value = condition("while");
    result->body.push_back(statement());
    return result;
}

ast::StmtPtr Parser::forStatement() {
    DeclaredNames own(*this);
    ast::StmtPtr result = make(StmtKind::For);
    take();
    expect("(", "after 'for'");
    if (!accept(";"))
        result->first = startsDeclaration() ? declaration() : expressionStatement();
    if (!at(";"))
        result->value = expression();
    expect(";", "after the condition of 'for'");
    while (!at(")")) {
        result->steps.push_back(expression());
        if (!accept(","))
            break;
    }
    expect(")", "to close the head of 'for'");
    result->body.push_back(statement());
    return result;
}

ast::StmtPtr Parser::jumpStatement(StmtKind kind) {
    ast::StmtPtr result = make(kind);
    std::string word = take().spelling;
    if (peek().kind == TokenKind::Number) {
        const Token &number = take();
        if (number.number != std::floor(number.number) || number.number < 1 || number.number > 1000)
            fail(number.where, "expected a positive whole number of loops after '" + word + "'");
        result->levels = int(number.number);
    }
    expectSemicolon("after '" + word + "'");
    return result;
}

ast::StmtPtr Parser::returnStatement() {
    ast::StmtPtr result = make(StmtKind::Return);
    take();
    if (!at(";"))
        result->value = expression();
    expectSemicolon("after the value of 'return'");
    return result;
}

ast::StmtPtr Parser::lightStatement(StmtKind kind) {
    ast::StmtPtr result = make(kind);
    std::string word = take().spelling;
    result->arguments = arguments(word);
    result->body.push_back(statement());
    if (kind == StmtKind::Gather && accept("else"))
        result->body.push_back(statement());
    return result;
}

ast::StmtPtr Parser::expressionStatement() {
    ast::StmtPtr result = make(StmtKind::Evaluate);
    const Token &first = peek();
    result->value = expression();
    bool misspelt = result->value->kind == ast::ExprKind::Name && isName();
    if (misspelt)
        fail(first.where, "'" + first.spelling +
                              "' is not a type; expected one, or an operator "
                              "after it");
    expectSemicolon("after the expression");
    return result;
}

} // namespace candela::sl
