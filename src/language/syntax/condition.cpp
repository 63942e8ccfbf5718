// SPDX-License-Identifier: Apache-2.0
#include "language/syntax/condition.h"

#include <cmath>

namespace candela::sl {
namespace {

struct Operator {
    const char *spelling;
    int precedence;
    double (*apply)(double, double);
};

constexpr Operator operators[] = {
    {"||", 1, [](double a, double b) { return double(a != 0 || b != 0); }},
    {"&&", 2, [](double a, double b) { return double(a != 0 && b != 0); }},
    {"==", 3, [](double a, double b) { return double(a == b); }},
    {"!=", 3, [](double a, double b) { return double(a != b); }},
    {"<", 4, [](double a, double b) { return double(a < b); }},
    {">", 4, [](double a, double b) { return double(a > b); }},
    {"<=", 4, [](double a, double b) { return double(a <= b); }},
    {">=", 4, [](double a, double b) { return double(a >= b); }},
    {"+", 5, [](double a, double b) { return a + b; }},
    {"-", 5, [](double a, double b) { return a - b; }},
    {"*", 6, [](double a, double b) { return a * b; }},
    {"/", 6, [](double a, double b) { return a / b; }},
    {"%", 6, [](double a, double b) { return std::fmod(a, b); }},
};

constexpr int nestingLimit = 64;

class Condition {
public:
    Condition(const std::vector<Token> &tokens, const Place &directive, Reporter &reporter)
        : tokens_(tokens), directive_(directive), reporter_(reporter) {}

    std::optional<double> run() {
        double value = choice();
        if (!failed_ && at_ < tokens_.size())
            fail("unexpected '" + tokens_[at_].spelling + "' in this condition");
        return failed_ ? std::nullopt : std::optional(value);
    }

private:
    bool next(const char *spelling) {
        if (at_ >= tokens_.size() || !tokens_[at_].is(spelling))
            return false;
        ++at_;
        return true;
    }

    double fail(const std::string &message) {
        if (!failed_)
            reporter_.error(at_ < tokens_.size() ? tokens_[at_].where : directive_, message);
        failed_ = true;
        at_ = tokens_.size();
        return 0;
    }

    double choice() {
        double condition = binary(1);
        if (!next("?"))
            return condition;
        if (++depth_ > nestingLimit)
            return fail("condition is nested too deeply");
        double yes = choice();
        if (!next(":"))
            return fail("expected ':' in this condition");
        double no = choice();
        --depth_;
        return condition != 0 ? yes : no;
    }

    const Operator *operatorHere(int least) const {
        for (const Operator &op : operators)
            if (at_ < tokens_.size() && tokens_[at_].is(op.spelling) && op.precedence >= least)
                return &op;
        return nullptr;
    }

    double binary(int least) {
        double left = unary();
        while (const Operator *op = operatorHere(least)) {
            ++at_;
            double right = binary(op->precedence + 1);
            bool divides = op->spelling[0] == '/' || op->spelling[0] == '%';
            if (divides && right == 0)
                return fail("division by zero in this condition");
            left = op->apply(left, right);
        }
        return left;
    }

    double unary() {
        if (++depth_ > nestingLimit)
            return fail("condition is nested too deeply");
        double value = 0;
        if (next("!"))
            value = unary() == 0;
        else if (next("-"))
            value = -unary();
        else if (next("+"))
            value = unary();
        else
            value = primary();
        --depth_;
        return value;
    }

    double primary() {
        if (next("(")) {
            double value = choice();
            return next(")") ? value : fail("expected ')' in this condition");
        }
        if (at_ >= tokens_.size())
            return fail("expected a value in this condition");
        const Token &token = tokens_[at_];
        if (token.kind == TokenKind::Number || token.isIdentifier()) {
            ++at_;
            return token.number; // Words that are no macros count as 0.
        }
        return fail("expected a value in this condition, not '" + token.spelling + "'");
    }

    const std::vector<Token> &tokens_;
    Place directive_;
    Reporter &reporter_;
    size_t at_ = 0;
    int depth_ = 0;
    bool failed_ = false;
};

} // namespace

std::optional<double> evaluateCondition(const std::vector<Token> &tokens, const Place &directive,
                                        Reporter &reporter) {
    return Condition(tokens, directive, reporter).run();
}

} // namespace candela::sl
