// SPDX-License-Identifier: Apache-2.0
// Expressions: a Pratt parser over the table of operators.h.
#include <algorithm>

#include "language/syntax/parser_state.h"

namespace candela::sl {

// Long chains (a + b + c ...) grow the tree without nesting the parser; the passes that walk the
// tree recurse, so its height is limited too.
static constexpr int heightLimit = 500;

ast::ExprPtr Parser::make(ast::ExprKind kind, const Place &where,
                          std::vector<ast::ExprPtr> operands) {
    auto result = std::make_unique<ast::Expr>();
    result->kind = kind;
    result->where = where;
    for (const ast::ExprPtr &operand : operands)
        result->depth = std::max(result->depth, operand->depth + 1);
    if (result->depth > heightLimit)
        fail(where, "expression is too long; split it (the limit is " +
                        std::to_string(heightLimit) + " operators deep)");
    result->operands = std::move(operands);
    return result;
}

static std::vector<ast::ExprPtr> list(ast::ExprPtr a, ast::ExprPtr b = nullptr,
                                      ast::ExprPtr c = nullptr) {
    std::vector<ast::ExprPtr> result;
    for (ast::ExprPtr *e : {&a, &b, &c})
        if (*e)
            result.push_back(std::move(*e));
    return result;
}

ast::ExprPtr Parser::expression(Precedence least) {
    Nesting nesting(*this);
    ast::ExprPtr left = unary();
    while (peek().kind == TokenKind::Punctuator) {
        const Infix *op = infixNamed(peek().spelling);
        if (!op || op->precedence < least)
            break;
        Place where = take().where;
        left = infix(std::move(left), *op, where);
    }
    return left;
}

ast::ExprPtr Parser::infix(ast::ExprPtr left, const Infix &op, const Place &where) {
    if (op.kind == InfixKind::Choice) {
        ast::ExprPtr yes = expression(Precedence::Choice);
        expect(":", "in this ?: expression");
        ast::ExprPtr no = expression(Precedence::Choice);
        return make(ast::ExprKind::Conditional, where,
                    list(std::move(left), std::move(yes), std::move(no)));
    }
    bool assigns = op.kind == InfixKind::Assign;
    Precedence least = assigns ? op.precedence : Precedence(int(op.precedence) + 1);
    ast::ExprPtr right = expression(least);
    auto kind = assigns ? ast::ExprKind::Assign : ast::ExprKind::Binary;
    ast::ExprPtr result = make(kind, where, list(std::move(left), std::move(right)));
    result->op = op.op;
    result->compound = op.compound;
    return result;
}

ast::ExprPtr Parser::unary() {
    if (isTypeWord())
        return cast();
    if (!at("-") && !at("!") && !at("+"))
        return postfix();
    Nesting nesting(*this);
    const Token &sign = take();
    ast::ExprPtr operand = unary();
    if (sign.is("+"))
        return operand;
    auto kind = sign.is("-") ? ast::ExprKind::Negate : ast::ExprKind::Not;
    return make(kind, sign.where, list(std::move(operand)));
}

ast::ExprPtr Parser::cast() {
    Nesting nesting(*this);
    const Token &word = take();
    ast::ExprPtr space;
    // A string after a type names a space, unless the string itself is what is cast.
    bool named =
        peek().kind == TokenKind::Text && *baseTypeNamed(word.spelling) != BaseType::String;
    if (named)
        space = text();
    ast::ExprPtr value = unary();
    ast::ExprPtr result =
        make(ast::ExprKind::Cast, word.where, list(std::move(value), std::move(space)));
    result->type = *baseTypeNamed(word.spelling);
    return result;
}

ast::ExprPtr Parser::postfix() {
    ast::ExprPtr result = primary();
    while (at("[")) {
        Place where = take().where;
        ast::ExprPtr index = expression();
        expect("]", "after the index");
        result = make(ast::ExprKind::Index, where, list(std::move(result), std::move(index)));
    }
    return result;
}

ast::ExprPtr Parser::primary() {
    const Token &token = peek();
    if (token.kind == TokenKind::Number) {
        take();
        ast::ExprPtr result = make(ast::ExprKind::Number, token.where);
        result->number = token.number;
        return result;
    }
    if (token.kind == TokenKind::Text)
        return text();
    if (at("("))
        return brackets();
    if (!token.isIdentifier() || isReserved())
        unexpected("an expression");
    take();
    if (!at("(")) {
        ast::ExprPtr result = make(ast::ExprKind::Name, token.where);
        result->text = token.spelling;
        return result;
    }
    ast::ExprPtr result = make(ast::ExprKind::Call, token.where, arguments(token.spelling));
    result->text = token.spelling;
    return result;
}

ast::ExprPtr Parser::text() {
    ast::ExprPtr result = make(ast::ExprKind::Text, peek().where);
    while (peek().kind == TokenKind::Text)
        result->text += take().text;
    return result;
}

ast::ExprPtr Parser::brackets() {
    Place where = take().where;
    std::vector<ast::ExprPtr> parts;
    do
        parts.push_back(expression());
    while (accept(","));
    expect(")", "to close the bracket");
    if (parts.size() == 1)
        return std::move(parts[0]);
    if (parts.size() != 3 && parts.size() != 16)
        fail(where, "a tuple has 3 components (color, point, vector, normal) or 16 (matrix), not " +
                        std::to_string(parts.size()));
    return make(ast::ExprKind::Tuple, where, std::move(parts));
}

std::vector<ast::ExprPtr> Parser::arguments(const std::string &name) {
    take(); // (
    std::vector<ast::ExprPtr> result;
    if (accept(")"))
        return result;
    do
        result.push_back(expression());
    while (accept(","));
    expect(")", "or ',' in the arguments of " + name);
    return result;
}

static std::string printed(const ast::Expr &e, size_t i) { return ast::print(*e.operands[i]); }

static std::string printedList(const ast::Expr &e) {
    std::string result;
    for (size_t i = 0; i < e.operands.size(); ++i)
        result += (i ? ", " : "") + printed(e, i);
    return "(" + result + ")";
}

static std::string printedNumber(double number) {
    std::string result = std::to_string(number);
    result.erase(result.find_last_not_of('0') + 1);
    return result.back() == '.' ? result.substr(0, result.size() - 1) : result;
}

std::string ast::print(const Expr &e) {
    switch (e.kind) {
    case ExprKind::Number: return printedNumber(e.number);
    case ExprKind::Text: return '"' + e.text + '"';
    case ExprKind::Name: return e.text;
    case ExprKind::Tuple: return printedList(e);
    case ExprKind::Index: return printed(e, 0) + "[" + printed(e, 1) + "]";
    case ExprKind::Call: return e.text + printedList(e);
    case ExprKind::Negate: return "(-" + printed(e, 0) + ")";
    case ExprKind::Not: return "(!" + printed(e, 0) + ")";
    case ExprKind::Binary:
        return "(" + printed(e, 0) + " " + nameOf(e.op) + " " + printed(e, 1) + ")";
    case ExprKind::Conditional:
        return "(" + printed(e, 0) + " ? " + printed(e, 1) + " : " + printed(e, 2) + ")";
    case ExprKind::Assign:
        return "(" + printed(e, 0) + " " + (e.compound ? nameOf(e.op) : "") + "= " + printed(e, 1) +
               ")";
    case ExprKind::Cast: {
        std::string space = e.operands.size() > 1 ? " " + printed(e, 1) : "";
        return "(" + std::string(nameOf(e.type)) + space + " " + printed(e, 0) + ")";
    }
    }
    return {};
}

} // namespace candela::sl
