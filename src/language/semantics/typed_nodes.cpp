// SPDX-License-Identifier: Apache-2.0
#include "language/semantics/typed_nodes.h"

#include "language/semantics/conversion.h"

namespace candela::sl {

std::vector<ExprPtr> list(ExprPtr a, ExprPtr b, ExprPtr c) {
    std::vector<ExprPtr> result;
    for (ExprPtr *e : {&a, &b, &c})
        if (*e)
            result.push_back(std::move(*e));
    return result;
}

ExprPtr makeNode(ExprKind kind, const Type &type, const Place &where,
                 std::vector<ExprPtr> operands) {
    auto result = std::make_unique<Expr>();
    result->kind = kind;
    result->type = type;
    result->where = where;
    for (const ExprPtr &operand : operands)
        result->type.detail = joined(result->type.detail, operand->type.detail);
    result->operands = std::move(operands);
    return result;
}

ExprPtr makeNumber(double number, const Place &where) {
    ExprPtr result = makeNode(ExprKind::Number, single(BaseType::Float), where);
    result->number = number;
    return result;
}

ExprPtr makeText(const std::string &text, const Place &where) {
    ExprPtr result = makeNode(ExprKind::Text, single(BaseType::String), where);
    result->text = text;
    return result;
}

ExprPtr makeZero(BaseType type, const Place &where) {
    if (type == BaseType::String)
        return makeText("", where);
    ExprPtr number = makeNumber(0, where);
    const bool isFloat = type == BaseType::Float || type == BaseType::Void;
    return isFloat ? std::move(number) : converted(std::move(number), type);
}

ExprPtr makeBinary(BinaryOp op, BaseType type, const Place &where, ExprPtr left, ExprPtr right) {
    ExprPtr result =
        makeNode(ExprKind::Binary, single(type), where, list(std::move(left), std::move(right)));
    result->op = op;
    return result;
}

ExprPtr makeVariable(Symbol &symbol, const Place &where) {
    ExprPtr result = makeNode(ExprKind::Variable, symbol.type, where);
    result->symbol = &symbol;
    return result;
}

StmtPtr makeNode(StmtKind kind, const Place &where) {
    auto result = std::make_unique<Stmt>();
    result->kind = kind;
    result->where = where;
    return result;
}

ExprPtr converted(ExprPtr e, BaseType to) {
    const Place where = e->where;
    return makeNode(ExprKind::Convert, single(to), where, list(std::move(e)));
}

ExprPtr coerce(ExprPtr e, BaseType to, const std::string &role, Reporter &reporter) {
    if (!e || (e->type.base == to && !e->type.isArray()))
        return e;
    if (e->type.isArray() || conversionCost(e->type.base, to) >= impossible) {
        reporter.error(e->where, role + " must be a " + nameOf(to) + ", not a " + shapeOf(e->type) +
                                     conversionHint(e->type.base, to));
        return nullptr;
    }
    return converted(std::move(e), to);
}

} // namespace candela::sl
