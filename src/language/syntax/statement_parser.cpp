// SPDX-License-Identifier: Apache-2.0
#include "language/syntax/statement_parser.h"

#include "language/syntax/rsl2.h"

#include <algorithm>
#include <cmath>

namespace candela::sl {

using ast::StmtKind;

// Each stands within the one before it, for passes that recurse on a deep stack.
static constexpr int chainLimit = 5000;

ast::StmtPtr StatementParser::make(StmtKind kind) const {
    auto result = std::make_unique<ast::Stmt>();
    result->kind = kind;
    result->where = tokens_.peek().where;
    return result;
}

/// A statement; after an error, an empty one with the cursor where the next may begin.
ast::StmtPtr StatementParser::statement() {
    size_t start = tokens_.position();
    try {
        return statementProper();
    } catch (Panic) {
        recoverInBlock(start);
        return make(StmtKind::Empty);
    }
}

void StatementParser::recoverInBlock(size_t start) {
    if (tokens_.position() == start && tokens_.at("{"))
        return skipBlock(); // Nested too deeply: parsing it again would lead here again.
    if (tokens_.position() == start && !tokens_.at("}"))
        tokens_.take();
    // A ';' in the head of a `for` does not end the statement.
    int depth = tokens_.bracketsOpenedSince(start);
    while (!tokens_.atEnd() && !tokens_.at("}") && !tokens_.at("{")) {
        bool startsNext = ahead_.startsDeclaration() ||
                          tokens_.atAny({"if", "while", "for", "return", "break", "continue",
                                         "illuminance", "illuminate", "solar"});
        if (tokens_.peek().startsLine && startsNext)
            return;
        depth = std::max(0, depth + tokens_.at("(") - tokens_.at(")"));
        if (tokens_.take().is(";") && (depth == 0 || tokens_.peek().startsLine))
            return;
    }
}

void StatementParser::skipBlock() {
    int depth = 0;
    do {
        depth += tokens_.at("{") - tokens_.at("}");
        tokens_.take();
    } while (depth > 0 && !tokens_.atEnd());
}

ast::StmtPtr StatementParser::statementProper() {
    TokenCursor::Nesting nesting(tokens_);
    if (tokens_.at("{"))
        return block();
    if (tokens_.at(";")) {
        ast::StmtPtr result = make(StmtKind::Empty);
        tokens_.take();
        return result;
    }
    if (tokens_.at("if"))
        return ifStatement();
    if (tokens_.at("while"))
        return whileStatement();
    if (tokens_.at("for"))
        return forStatement();
    if (tokens_.at("break"))
        return jumpStatement(StmtKind::Break);
    if (tokens_.at("continue"))
        return jumpStatement(StmtKind::Continue);
    if (tokens_.at("return"))
        return returnStatement();
    if (const std::string construct = rsl2Construct(tokens_); !construct.empty())
        tokens_.fail(tokens_.peek().where, rsl2Message(construct));
    if (tokens_.at("else"))
        tokens_.fail(tokens_.peek().where, "'else' without an 'if' before it");
    if (tokens_.at("(", 1)) {
        if (tokens_.at("illuminance"))
            return lightStatement(StmtKind::Illuminance);
        if (tokens_.at("illuminate"))
            return lightStatement(StmtKind::Illuminate);
        if (tokens_.at("solar"))
            return lightStatement(StmtKind::Solar);
        if (tokens_.at("gather"))
            return lightStatement(StmtKind::Gather);
    }
    if (ahead_.startsFunction()) {
        ast::StmtPtr result = make(StmtKind::Function);
        result->function = std::make_unique<ast::Function>(function());
        return result;
    }
    return ahead_.startsDeclaration() ? declaration() : expressionStatement();
}

ast::StmtPtr StatementParser::body(const std::string &owner) {
    if (!tokens_.at("{"))
        tokens_.unexpected("'{' to open the body of " + owner);
    return block();
}

ast::StmtPtr StatementParser::block() {
    Lookahead::InnerScope own(ahead_);
    ast::StmtPtr result = make(StmtKind::Block);
    int line = tokens_.take().where.line;
    while (!tokens_.atEnd() && !tokens_.at("}") && !tokens_.reporter().hopeless())
        result->body.push_back(statement());
    if (!tokens_.accept("}") && !tokens_.reporter().hopeless())
        tokens_.reporter().error(tokens_.peek().where,
                                 "expected '}' to close the block that line " +
                                     std::to_string(line) + " opens, not the end of the file");
    return result;
}

ast::ExprPtr StatementParser::condition(const char *word) {
    tokens_.take();
    tokens_.expect("(", std::string("after '") + word + "'");
    ast::ExprPtr result = expressions_.expression();
    tokens_.expect(")", std::string("after the condition of '") + word + "'");
    return result;
}

/// "if" and its body; true if an "else" follows.
bool StatementParser::choice(ast::Stmt &to) {
    to.value = condition("if");
    to.body.push_back(statement());
    return tokens_.accept("else");
}

/// With all the "else if" behind it, without recursion. An error in one of these ends the chain.
ast::StmtPtr StatementParser::ifStatement() {
    ast::StmtPtr result = make(StmtKind::If);
    bool goesOn = choice(*result);
    ast::Stmt *last = result.get();
    for (int links = 1; goesOn && tokens_.at("if"); ++links) {
        if (links == chainLimit)
            tokens_.reporter().error(tokens_.peek().where,
                                     "too many 'else if' in a row; the limit is " +
                                         std::to_string(chainLimit));
        const size_t start = tokens_.position();
        ast::StmtPtr link = make(StmtKind::If);
        try {
            goesOn = choice(*link);
        } catch (Panic) {
            recoverInBlock(start);
            return result;
        }
        if (links >= chainLimit)
            continue;
        last->body.push_back(std::move(link));
        last = last->body.back().get();
    }
    if (goesOn)
        last->body.push_back(statement());
    return result;
}

ast::StmtPtr StatementParser::whileStatement() {
    ast::StmtPtr result = make(StmtKind::While);
    result->value = condition("while");
    result->body.push_back(statement());
    return result;
}

ast::StmtPtr StatementParser::forStatement() {
    Lookahead::InnerScope own(ahead_);
    ast::StmtPtr result = make(StmtKind::For);
    tokens_.take();
    tokens_.expect("(", "after 'for'");
    if (!tokens_.accept(";"))
        result->first = ahead_.startsDeclaration() ? declaration() : expressionStatement();
    if (!tokens_.at(";"))
        result->value = expressions_.expression();
    tokens_.expect(";", "after the condition of 'for'");
    while (!tokens_.at(")")) {
        result->steps.push_back(expressions_.effect());
        if (!tokens_.accept(","))
            break;
    }
    tokens_.expect(")", "to close the head of 'for'");
    result->body.push_back(statement());
    return result;
}

ast::StmtPtr StatementParser::jumpStatement(StmtKind kind) {
    ast::StmtPtr result = make(kind);
    std::string word = tokens_.take().spelling;
    if (tokens_.peek().kind == TokenKind::Number) {
        const Token &number = tokens_.take();
        if (number.number != std::floor(number.number) || number.number < 1 || number.number > 1000)
            tokens_.fail(number.where,
                         "expected a positive whole number of loops after '" + word + "'");
        result->levels = int(number.number);
    }
    tokens_.expectSemicolon("after '" + word + "'");
    return result;
}

ast::StmtPtr StatementParser::returnStatement() {
    ast::StmtPtr result = make(StmtKind::Return);
    tokens_.take();
    if (!tokens_.at(";"))
        result->value = expressions_.expression();
    tokens_.expectSemicolon("after the value of 'return'");
    return result;
}

/// A declaration without braces would be for nothing: all that follows in the block belongs to the
/// statement, too.
ast::StmtPtr StatementParser::restOfBlock(const std::string &word) {
    tokens_.reporter().warning(tokens_.peek().where,
                               word + " has no { }: all that follows in this block belongs to it");
    Lookahead::InnerScope own(ahead_);
    ast::StmtPtr result = make(StmtKind::Block);
    while (!tokens_.atEnd() && !tokens_.at("}") && !tokens_.reporter().hopeless())
        result->body.push_back(statement());
    return result;
}

ast::StmtPtr StatementParser::lightStatement(StmtKind kind) {
    ast::StmtPtr result = make(kind);
    std::string word = tokens_.take().spelling;
    result->arguments = expressions_.arguments(word);
    result->body.push_back(ahead_.startsDeclaration() ? restOfBlock(word) : statement());
    if (kind == StmtKind::Gather && tokens_.accept("else"))
        result->body.push_back(statement());
    return result;
}

ast::StmtPtr StatementParser::declaration() {
    ast::StmtPtr result = make(StmtKind::Declare);
    result->variables = declarations_.variables();
    return result;
}

ast::StmtPtr StatementParser::expressionStatement() {
    ast::StmtPtr result = make(StmtKind::Evaluate);
    const Token &first = tokens_.peek();
    result->value = expressions_.effect();
    bool misspelt = result->value->kind == ast::ExprKind::Name && ahead_.isName();
    if (misspelt)
        tokens_.fail(first.where, "'" + first.spelling +
                                      "' is not a type; expected one, or an operator "
                                      "after it");
    if (tokens_.at(","))
        return furtherExpressions(std::move(result));
    tokens_.expectSemicolon("after the expression");
    return result;
}

/// a = 1, b = 2; runs one after the other, as in C.
ast::StmtPtr StatementParser::furtherExpressions(ast::StmtPtr first) {
    ast::StmtPtr result = make(StmtKind::Block);
    result->where = first->where;
    result->body.push_back(std::move(first));
    while (tokens_.accept(",")) {
        ast::StmtPtr next = make(StmtKind::Evaluate);
        next->value = expressions_.effect();
        result->body.push_back(std::move(next));
    }
    tokens_.expectSemicolon("after the expression");
    return result;
}

ast::Function StatementParser::function() {
    Lookahead::InnerScope own(ahead_);
    ast::Function result;
    while (tokens_.accept("uniform") || tokens_.accept("varying")) {
        // What a function returns has the detail of its values; saying so changes nothing.
    }
    if (ahead_.isTypeWord())
        result.result = baseTypeNamed(tokens_.take().spelling);
    result.where = tokens_.peek().where;
    result.name = tokens_.take().spelling;
    result.formals = declarations_.formals(result.name);
    result.body = body("function " + result.name);
    return result;
}

} // namespace candela::sl
