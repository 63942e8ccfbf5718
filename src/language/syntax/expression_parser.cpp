// SPDX-License-Identifier: Apache-2.0
#include "language/syntax/expression_parser.h"

#include "language/syntax/rsl2.h"

#include <algorithm>
#include <tuple>

namespace candela::sl {

// Long chains (a + b + c ...) grow the tree without nesting the parser; the passes that walk the
// tree recurse, on a deep stack, so its height is limited too.
static constexpr int heightLimit = 5000;

ast::ExprPtr ExpressionParser::make(ast::ExprKind kind, const Place &where,
                                    std::vector<ast::ExprPtr> operands) {
    auto result = std::make_unique<ast::Expr>();
    result->kind = kind;
    result->where = where;
    for (const ast::ExprPtr &operand : operands)
        result->depth = std::max(result->depth, operand->depth + 1);
    if (result->depth > heightLimit)
        tokens_.fail(where, "expression is too long; split it (the limit is " +
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

ast::ExprPtr ExpressionParser::expression(Precedence least) {
    TokenCursor::Nesting nesting(tokens_);
    ast::ExprPtr left = unary();
    while (tokens_.peek().kind == TokenKind::Punctuator) {
        const Infix *op = infixNamed(tokens_.peek().spelling);
        if (!op || op->precedence < least)
            break;
        Place where = tokens_.take().where;
        left = infix(std::move(left), *op, where);
    }
    return left;
}

ast::ExprPtr ExpressionParser::infix(ast::ExprPtr left, const Infix &op, const Place &where) {
    if (op.kind == InfixKind::Choice) {
        ast::ExprPtr yes = expression(Precedence::Choice);
        tokens_.expect(":", "in this ?: expression");
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

ast::ExprPtr ExpressionParser::unary() {
    if (ahead_.isTypeWord())
        return cast();
    if (!tokens_.at("-") && !tokens_.at("!") && !tokens_.at("+"))
        return postfix();
    TokenCursor::Nesting nesting(tokens_);
    const Token &sign = tokens_.take();
    ast::ExprPtr operand = unary();
    if (sign.is("+"))
        return operand;
    auto kind = sign.is("-") ? ast::ExprKind::Negate : ast::ExprKind::Not;
    return make(kind, sign.where, list(std::move(operand)));
}

ast::ExprPtr ExpressionParser::cast() {
    TokenCursor::Nesting nesting(tokens_);
    const Token &word = tokens_.take();
    ast::ExprPtr space;
    // A string after a type names a space, unless the string itself is what is cast.
    bool named =
        tokens_.peek().kind == TokenKind::Text && *baseTypeNamed(word.spelling) != BaseType::String;
    if (named)
        space = text();
    ast::ExprPtr value = unary();
    ast::ExprPtr result =
        make(ast::ExprKind::Cast, word.where, list(std::move(value), std::move(space)));
    result->type = *baseTypeNamed(word.spelling);
    return result;
}

ast::ExprPtr ExpressionParser::postfix() {
    ast::ExprPtr result = primary();
    while (tokens_.at("[")) {
        Place where = tokens_.take().where;
        ast::ExprPtr index = expression();
        tokens_.expect("]", "after the index");
        result = make(ast::ExprKind::Index, where, list(std::move(result), std::move(index)));
    }
    if (tokens_.at("->"))
        tokens_.fail(tokens_.peek().where, rsl2Message("'->'"));
    for (auto [sign, op, back] : {std::tuple("+", BinaryOp::Add, BinaryOp::Subtract),
                                  std::tuple("-", BinaryOp::Subtract, BinaryOp::Add)}) {
        if (!atSigns(sign) || !tokens_.atAny({";", ")", ",", "]"}, 2))
            continue;
        const Place where = tokens_.take().where;
        tokens_.take();
        if (!tokens_.at(";")) // The value is the one before: (i += 1) - 1.
            return step(counted(std::move(result), op, where), back, where);
        return counted(std::move(result), op, where);
    }
    return result;
}

/// Two signs without a space between them.
bool ExpressionParser::atSigns(const char *sign) const {
    return tokens_.at(sign) && tokens_.at(sign, 1) && !tokens_.peek(1).spaceBefore;
}

/// variable += 1 or variable -= 1
ast::ExprPtr ExpressionParser::counted(ast::ExprPtr variable, BinaryOp op, const Place &where) {
    ast::ExprPtr result = step(std::move(variable), op, where);
    result->kind = ast::ExprKind::Assign;
    result->compound = true;
    return result;
}

/// value + 1 or value - 1
ast::ExprPtr ExpressionParser::step(ast::ExprPtr value, BinaryOp op, const Place &where) {
    ast::ExprPtr one = make(ast::ExprKind::Number, where);
    one->number = 1;
    ast::ExprPtr result =
        make(ast::ExprKind::Binary, where, list(std::move(value), std::move(one)));
    result->op = op;
    return result;
}

ast::ExprPtr ExpressionParser::effect() {
    for (auto [sign, op] : {std::pair("+", BinaryOp::Add), std::pair("-", BinaryOp::Subtract)})
        if (atSigns(sign)) {
            const Place where = tokens_.take().where;
            tokens_.take();
            return counted(postfix(), op, where);
        }
    return expression();
}

ast::ExprPtr ExpressionParser::primary() {
    const Token &token = tokens_.peek();
    if (token.kind == TokenKind::Number) {
        tokens_.take();
        ast::ExprPtr result = make(ast::ExprKind::Number, token.where);
        result->number = token.number;
        return result;
    }
    if (token.kind == TokenKind::Text)
        return text();
    if (tokens_.at("("))
        return brackets();
    if (!token.isIdentifier() || isReserved(tokens_.peek()))
        tokens_.unexpected("an expression");
    tokens_.take();
    if (!tokens_.at("(")) {
        ast::ExprPtr result = make(ast::ExprKind::Name, token.where);
        result->text = token.spelling;
        return result;
    }
    ast::ExprPtr result = make(ast::ExprKind::Call, token.where, arguments(token.spelling));
    result->text = token.spelling;
    return result;
}

ast::ExprPtr ExpressionParser::text() {
    ast::ExprPtr result = make(ast::ExprKind::Text, tokens_.peek().where);
    while (tokens_.peek().kind == TokenKind::Text)
        result->text += tokens_.take().text;
    return result;
}

/// (float) x, as in C.
bool ExpressionParser::atBracketedType() const {
    const Token &operand = tokens_.peek(3);
    const bool isOperand = operand.isIdentifier() || operand.kind == TokenKind::Number ||
                           operand.kind == TokenKind::Text || operand.is("(");
    return baseTypeNamed(tokens_.peek(1).spelling) && tokens_.at(")", 2) && isOperand;
}

ast::ExprPtr ExpressionParser::brackets() {
    if (atBracketedType()) {
        tokens_.take();
        const Token &type = tokens_.take();
        tokens_.take();
        ast::ExprPtr result = make(ast::ExprKind::Cast, type.where, list(unary()));
        result->type = *baseTypeNamed(type.spelling);
        return result;
    }
    Place where = tokens_.take().where;
    std::vector<ast::ExprPtr> parts;
    do
        parts.push_back(expression());
    while (tokens_.accept(","));
    tokens_.expect(")", "to close the bracket");
    if (parts.size() == 1)
        return std::move(parts[0]);
    if (parts.size() != 3 && parts.size() != 16)
        tokens_.fail(
            where, "a tuple has 3 components (color, point, vector, normal) or 16 (matrix), not " +
                       std::to_string(parts.size()));
    return make(ast::ExprKind::Tuple, where, std::move(parts));
}

std::vector<ast::ExprPtr> ExpressionParser::arguments(const std::string &name) {
    tokens_.take(); // (
    std::vector<ast::ExprPtr> result;
    if (tokens_.accept(")"))
        return result;
    do
        result.push_back(expression());
    while (tokens_.accept(","));
    tokens_.expect(")", "or ',' in the arguments of " + name);
    return result;
}

} // namespace candela::sl
