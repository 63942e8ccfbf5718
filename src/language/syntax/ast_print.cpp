// SPDX-License-Identifier: Apache-2.0
// Expressions as text.
#include "language/syntax/ast.h"

namespace candela::sl {

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
