// SPDX-License-Identifier: Apache-2.0
// Expressions, from the outside in: the context says which type it wants.
#include <algorithm>
#include <cmath>

#include "language/semantics/checker.h"
#include "language/semantics/constant_value.h"
#include "language/semantics/operator_forms.h"
#include "language/semantics/spellings.h"

namespace candela::sl {

ExprPtr Checker::node(ExprKind kind, Type type, const Place &where, std::vector<ExprPtr> operands) {
    auto result = std::make_unique<Expr>();
    result->kind = kind;
    result->type = type;
    result->where = where;
    for (const ExprPtr &operand : operands)
        result->type.detail = joined(result->type.detail, operand->type.detail);
    result->operands = std::move(operands);
    return result;
}

static std::vector<ExprPtr> list(ExprPtr a, ExprPtr b = nullptr, ExprPtr c = nullptr) {
    std::vector<ExprPtr> result;
    for (ExprPtr *e : {&a, &b, &c})
        if (*e)
            result.push_back(std::move(*e));
    return result;
}

static Type single(BaseType base, Detail detail = Detail::Uniform) { return {base, detail, 0}; }

static const char *hintFor(BaseType from, BaseType to) {
    if (isTriple(from) && isTriple(to))
        return "; a cast says that it is meant";
    if (isGeometric(from) && to == BaseType::Float)
        return "; did you mean length(), xcomp() or a dot product?";
    if (from == BaseType::Color && to == BaseType::Float)
        return "; comp() takes one component";
    return "";
}

ExprPtr Checker::coerce(ExprPtr e, BaseType to, const std::string &role) {
    if (!e || (e->type.base == to && !e->type.isArray()))
        return e;
    if (e->type.isArray() || conversionCost(e->type.base, to) >= impossible) {
        reporter_.error(e->where, role + " must be a " + nameOf(to) + ", not a " +
                                      shapeOf(e->type) + hintFor(e->type.base, to));
        return nullptr;
    }
    Place where = e->where;
    return node(ExprKind::Convert, single(to), where, list(std::move(e)));
}

ExprPtr Checker::checkAs(const ast::Expr &e, BaseType type, const std::string &role) {
    return coerce(check(e, type), type, role);
}

ExprPtr Checker::check(const ast::Expr &e, Wanted wanted) {
    switch (e.kind) {
    case ast::ExprKind::Number: {
        ExprPtr result = node(ExprKind::Number, single(BaseType::Float), e.where);
        result->number = e.number;
        return result;
    }
    case ast::ExprKind::Text: {
        ExprPtr result = node(ExprKind::Text, single(BaseType::String), e.where);
        result->text = e.text;
        return result;
    }
    case ast::ExprKind::Name: return checkName(e);
    case ast::ExprKind::Tuple: return checkTuple(e, wanted);
    case ast::ExprKind::Index: return checkIndex(e, false);
    case ast::ExprKind::Call: return checkCall(e, wanted);
    case ast::ExprKind::Negate:
    case ast::ExprKind::Not: return checkSign(e, wanted);
    case ast::ExprKind::Binary: return checkBinary(e, wanted);
    case ast::ExprKind::Conditional: return checkConditional(e, wanted);
    case ast::ExprKind::Assign: return checkAssign(e);
    case ast::ExprKind::Cast: return checkCast(e);
    }
    return nullptr;
}

ExprPtr Checker::variable(Symbol &symbol, const Place &where) {
    ExprPtr result = node(ExprKind::Variable, symbol.type, where);
    result->symbol = &symbol;
    return result;
}

ExprPtr Checker::checkName(const ast::Expr &e) {
    Symbol *symbol = findVariable(e.text);
    if (!symbol && e.text == "PI") {
        ExprPtr result = node(ExprKind::Number, single(BaseType::Float), e.where);
        result->number = M_PI;
        return result;
    }
    if (!symbol) {
        reporter_.error(e.where, "unknown variable '" + e.text + "'" + variableSuggestion(e.text));
        return nullptr;
    }
    symbol->read = true;
    if (symbol->predefined && context_.inDefaults) {
        reporter_.error(e.where, "the default of a parameter cannot depend on " + e.text);
        return nullptr;
    }
    bool lightValue = symbol->predefined && symbol->predefined->scope == PredefinedScope::Light;
    // A function may be called from inside a loop, and a light may read back what it set.
    if (lightValue && !context_.lightStatement && !context_.function && !symbol->written)
        reporter_.warning(e.where, e.text + " has a value only inside an illuminance, illuminate "
                                            "or solar statement; here it is 0");
    if (symbol->type.isArray()) {
        reporter_.error(e.where, "array " + e.text + " needs an index here");
        return nullptr;
    }
    return variable(*symbol, e.where);
}

ExprPtr Checker::checkTuple(const ast::Expr &e, Wanted wanted) {
    std::vector<ExprPtr> parts;
    for (const ast::ExprPtr &operand : e.operands)
        if (ExprPtr part = checkAs(*operand, BaseType::Float, "a component of a tuple"))
            parts.push_back(std::move(part));
    if (parts.size() != e.operands.size())
        return nullptr;
    BaseType triple = wanted && isTriple(*wanted) ? *wanted : BaseType::Vector;
    BaseType type = parts.size() == 16 ? BaseType::Matrix : triple;
    return node(ExprKind::Tuple, single(type), e.where, std::move(parts));
}

bool Checker::constantIndexFits(const ast::Expr &index, int length, const std::string &what) {
    const std::optional<double> value = constantValue(index);
    if (!value || (*value >= 0 && *value < length))
        return true;
    reporter_.error(index.where, "index is outside of " + what + "; expected 0 to " +
                                     std::to_string(length - 1));
    return false;
}

ExprPtr Checker::checkIndex(const ast::Expr &e, bool asTarget) {
    const ast::Expr &indexed = *e.operands[0];
    TypeSet types = typesOf(indexed);
    if (types.isOnly(BaseType::String) && !types.arrayLength) {
        reporter_.error(e.where, "a string cannot be indexed; a texture's channel, as in "
                                 "name[0], stands only as the first argument of texture(), "
                                 "environment(), shadow() or bump()");
        return nullptr;
    }
    ExprPtr index = checkAs(*e.operands[1], BaseType::Float, "an index");
    if (types.arrayLength) {
        ExprPtr array = wholeArray(indexed, asTarget);
        if (!array || !index ||
            !constantIndexFits(*e.operands[1], array->type.length, "array " + indexed.text))
            return nullptr;
        Type element = single(array->type.base);
        return node(ExprKind::Element, element, e.where, list(std::move(array), std::move(index)));
    }
    ExprPtr triple = asTarget ? checkTarget(indexed) : check(indexed);
    if (!triple || !index)
        return nullptr;
    if (!isTriple(triple->type.base)) {
        reporter_.error(e.where, "only arrays, colors, points, vectors and normals can be "
                                 "indexed, not a " +
                                     shapeOf(triple->type));
        return nullptr;
    }
    if (!constantIndexFits(*e.operands[1], 3, std::string("a ") + nameOf(triple->type.base)))
        return nullptr;
    return node(ExprKind::Component, single(BaseType::Float), e.where,
                list(std::move(triple), std::move(index)));
}

ExprPtr Checker::checkSign(const ast::Expr &e, Wanted wanted) {
    if (e.kind == ast::ExprKind::Not) {
        ExprPtr operand = checkAs(*e.operands[0], BaseType::Float, "the operand of '!'");
        return operand
                   ? node(ExprKind::Not, single(BaseType::Float), e.where, list(std::move(operand)))
                   : nullptr;
    }
    ExprPtr operand = check(*e.operands[0], wanted);
    if (!operand)
        return nullptr;
    BaseType base = operand->type.base;
    if (base == BaseType::String || base == BaseType::Void) {
        reporter_.error(e.where, std::string("'-' cannot be applied to a ") + nameOf(base));
        return nullptr;
    }
    return node(ExprKind::Negate, single(base), e.where, list(std::move(operand)));
}

// Point, vector and normal are one to the operators: no node between them.
static bool sameToOperators(BaseType a, BaseType b) {
    return a == b || (isGeometric(a) && isGeometric(b));
}

ExprPtr Checker::checkBinary(const ast::Expr &e, Wanted wanted) {
    TypeSet leftTypes = typesOf(*e.operands[0]), rightTypes = typesOf(*e.operands[1]);
    const OperatorForm *form = chooseForm(e.op, leftTypes, rightTypes, wanted);
    if (!form) {
        reporter_.error(e.where, std::string("operator '") + nameOf(e.op) +
                                     "' cannot be applied to " + leftTypes.text() + " and " +
                                     rightTypes.text());
        return nullptr;
    }
    std::string role = std::string("an operand of '") + nameOf(e.op) + "'";
    ExprPtr left = check(*e.operands[0], form->left), right = check(*e.operands[1], form->right);
    if (!left || !right)
        return nullptr;
    bool dotOfColors = form->left == BaseType::Color && e.op == BinaryOp::Dot;
    for (auto [side, type] : {std::pair(&left, form->left), std::pair(&right, form->right)}) {
        if (!sameToOperators((*side)->type.base, type))
            *side = coerce(std::move(*side), type, role);
        if (!*side)
            return nullptr;
        Place where = (*side)->where;
        if (dotOfColors)
            *side =
                node(ExprKind::Convert, single(BaseType::Vector), where, list(std::move(*side)));
    }
    ExprPtr result = node(ExprKind::Binary, single(form->result), e.where,
                          list(std::move(left), std::move(right)));
    result->op = e.op;
    return result;
}

ExprPtr Checker::checkConditional(const ast::Expr &e, Wanted wanted) {
    TypeSet yes = typesOf(*e.operands[1]), no = typesOf(*e.operands[2]), types = typesOf(e);
    BaseType best = BaseType::Float;
    int bestCost = impossible;
    for (int i = 0; i < baseTypeCount; ++i) {
        if (!types.has(BaseType(i)))
            continue;
        int cost = conversionCost(yes, BaseType(i)) + conversionCost(no, BaseType(i)) +
                   contextCost(BaseType(i), wanted);
        if (cost < bestCost) {
            bestCost = cost;
            best = BaseType(i);
        }
    }
    if (types.empty() && !yes.empty() && !no.empty()) {
        reporter_.error(e.where, "the branches of '?:' have no common type: " + yes.text() +
                                     " and " + no.text());
        return nullptr;
    }
    ExprPtr test = checkAs(*e.operands[0], BaseType::Float, "the condition of '?:'");
    ExprPtr first = checkAs(*e.operands[1], best, "a branch of '?:'");
    ExprPtr second = checkAs(*e.operands[2], best, "a branch of '?:'");
    if (!test || !first || !second)
        return nullptr;
    return node(ExprKind::Conditional, single(best), e.where,
                list(std::move(test), std::move(first), std::move(second)));
}

bool Checker::mayWrite(const Symbol &symbol, const Place &where) {
    std::string problem;
    if (symbol.kind == Symbol::Kind::Predefined && !symbol.predefined->writableIn(shader_->kind))
        problem = symbol.name + " cannot be assigned in a " + nameOf(shader_->kind) + " shader";
    if (symbol.kind == Symbol::Kind::Parameter && !symbol.output)
        problem = "parameter " + symbol.name +
                  " cannot be assigned; declare it output, or copy it "
                  "into a variable";
    if (symbol.kind == Symbol::Kind::Formal && !symbol.output)
        problem = "argument " + symbol.name +
                  " cannot be assigned; declare it output, or copy it "
                  "into a variable";
    if (problem.empty())
        return true;
    reporter_.error(where, problem);
    return false;
}

ExprPtr Checker::checkTarget(const ast::Expr &e) {
    if (e.kind == ast::ExprKind::Index)
        return checkIndex(e, true);
    if (e.kind != ast::ExprKind::Name) {
        reporter_.error(e.where, "only variables, array elements and components can be assigned");
        return nullptr;
    }
    Symbol *symbol = findVariable(e.text);
    if (!symbol) {
        bool constant = e.text == "PI";
        reporter_.error(e.where, constant ? "PI is a constant and cannot be assigned"
                                          : "unknown variable '" + e.text + "'" +
                                                variableSuggestion(e.text));
        return nullptr;
    }
    symbol->written = true;
    return mayWrite(*symbol, e.where) ? variable(*symbol, e.where) : nullptr;
}

static Symbol *symbolOf(const Expr &target) {
    const Expr *e = &target;
    while (e->kind != ExprKind::Variable)
        e = e->operands[0].get();
    return e->symbol;
}

// Strings without a stated detail take that of what they are given.
bool Checker::detailFits(const Expr &target, Detail value, const Place &where) {
    Symbol &symbol = *symbolOf(target);
    if (value == Detail::Uniform || symbol.type.isVarying())
        return true;
    if (symbol.kind == Symbol::Kind::Local && symbol.type.base == BaseType::String &&
        !symbol.detailStated) {
        symbol.type.detail = Detail::Varying;
        return true;
    }
    reporter_.error(where, "a varying value cannot be assigned to uniform " +
                               std::string(nameOf(symbol.type.base)) + " " + symbol.name +
                               "; declare it varying");
    return false;
}

ExprPtr Checker::checkAssign(const ast::Expr &e) {
    ExprPtr target = checkTarget(*e.operands[0]);
    if (target && target->type.isArray()) {
        reporter_.error(e.where, "an array cannot be assigned as a whole");
        target = nullptr;
    }
    if (!target) {
        check(*e.operands[1]);
        return nullptr;
    }
    ExprPtr value = assignedValue(e, target->type);
    if (!value)
        return nullptr;
    bool indexVaries = target->type.isVarying() && !symbolOf(*target)->type.isVarying();
    Detail detail = indexVaries ? Detail::Varying : value->type.detail;
    if (!detailFits(*target, detail, e.where))
        return nullptr;
    Type type = single(target->type.base);
    return node(ExprKind::Assign, type, e.where, list(std::move(target), std::move(value)));
}

ExprPtr Checker::assignedValue(const ast::Expr &e, const Type &target) {
    std::string role = "what is assigned here";
    const ast::Expr &right = *e.operands[1];
    if (!e.compound)
        return checkAs(right, target.base, role);
    TypeSet rightTypes = typesOf(right);
    const OperatorForm *form = chooseForm(e.op, {target.base}, rightTypes, target.base);
    if (!form) {
        reporter_.error(e.where, std::string("operator '") + nameOf(e.op) +
                                     "=' cannot be applied to " + nameOf(target.base) + " and " +
                                     rightTypes.text());
        return nullptr;
    }
    ExprPtr before = coerce(node(ExprKind::TargetValue, target, e.where), form->left, role);
    ExprPtr value = check(right, form->right);
    if (value && !sameToOperators(value->type.base, form->right))
        value = coerce(std::move(value), form->right, role);
    if (!value || !before)
        return nullptr;
    ExprPtr sum = node(ExprKind::Binary, single(form->result), e.where,
                       list(std::move(before), std::move(value)));
    sum->op = e.op;
    return coerce(std::move(sum), target.base, role);
}

ExprPtr Checker::checkCast(const ast::Expr &e) {
    std::string type = nameOf(e.type);
    ExprPtr value = check(*e.operands[0], e.type);
    bool spaced = e.operands.size() > 1;
    if (spaced && (e.type == BaseType::Float || e.type == BaseType::Void)) {
        reporter_.error(e.operands[1]->where, "a " + type +
                                                  " is in no space; only color, point, "
                                                  "vector, normal and matrix are");
        return nullptr;
    }
    if (spaced && e.type == BaseType::Color && colorSpaceSpelled(e.operands[1]->text).empty()) {
        reporter_.error(e.operands[1]->where, "unknown colour space \"" + e.operands[1]->text +
                                                  "\"; expected " + colorSpaceNames);
        return nullptr;
    }
    if (!value)
        return nullptr;
    if (!castable(value->type.base, e.type)) {
        reporter_.error(e.where, "a " + shapeOf(value->type) + " cannot be cast to a " + type +
                                     hintFor(value->type.base, e.type));
        return nullptr;
    }
    if (value->type.base != e.type)
        value = node(ExprKind::Convert, single(e.type), e.where, list(std::move(value)));
    if (!spaced)
        return value;
    ExprPtr space = check(*e.operands[1]);
    return node(ExprKind::FromSpace, single(e.type), e.where,
                list(std::move(value), std::move(space)));
}

} // namespace candela::sl
