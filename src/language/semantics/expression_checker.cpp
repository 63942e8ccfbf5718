// SPDX-License-Identifier: Apache-2.0
#include "language/semantics/expression_checker.h"

#include <cmath>

#include "language/semantics/call_checker.h"
#include "language/semantics/constant_value.h"
#include "language/semantics/operator_forms.h"
#include "language/semantics/targets.h"
#include "language/semantics/type_inference.h"
#include "language/semantics/typed_nodes.h"

namespace candela::sl {

ExprPtr ExpressionChecker::checkAs(const ast::Expr &e, BaseType type, const std::string &role) {
    return coerce(check(e, type), type, role, here_.reporter);
}

ExprPtr ExpressionChecker::check(const ast::Expr &e, Wanted wanted) {
    switch (e.kind) {
    case ast::ExprKind::Number: return makeNumber(e.number, e.where);
    case ast::ExprKind::Text: return makeText(e.text, e.where);
    case ast::ExprKind::Name: return name(e);
    case ast::ExprKind::Tuple: return tuple(e, wanted);
    case ast::ExprKind::Index: return index(e, false);
    case ast::ExprKind::Call: return CallChecker(here_, *this).check(e, wanted);
    case ast::ExprKind::Negate: return negation(e, wanted);
    case ast::ExprKind::Not: return logicalNot(e);
    case ast::ExprKind::Binary: return binary(e, wanted);
    case ast::ExprKind::Conditional: return conditional(e, wanted);
    case ast::ExprKind::Assign: return assignment(e);
    case ast::ExprKind::Cast: return cast(e);
    }
    return nullptr;
}

static std::nullptr_t unknownVariable(const ast::Expr &e, const Surroundings &here) {
    return here.error(e.where,
                      "unknown variable '" + e.text + "'" + here.names.variableSuggestion(e.text));
}

ExprPtr ExpressionChecker::name(const ast::Expr &e) {
    Symbol *symbol = here_.names.find(e.text);
    if (!symbol && e.text == "PI")
        return makeNumber(M_PI, e.where);
    if (!symbol)
        return unknownVariable(e, here_);
    symbol->read = true;
    bool lightValue = symbol->predefined && symbol->predefined->scope == PredefinedScope::Light;
    // A function may be called from inside a loop, and a light may read back what it set.
    if (lightValue && !here_.lightStatement && !here_.function && !symbol->written)
        here_.reporter.hint(e.where, e.text + " has a value only inside an illuminance, illuminate "
                                              "or solar statement; here it is 0");
    if (symbol->type.isArray())
        return here_.error(e.where, "array " + e.text + " needs an index here");
    return makeVariable(*symbol, e.where);
}

ExprPtr ExpressionChecker::tuple(const ast::Expr &e, Wanted wanted) {
    std::vector<ExprPtr> parts;
    for (const ast::ExprPtr &operand : e.operands)
        if (ExprPtr part = checkAs(*operand, BaseType::Float, "a component of a tuple"))
            parts.push_back(std::move(part));
    if (parts.size() != e.operands.size())
        return nullptr;
    BaseType triple = wanted && isTriple(*wanted) ? *wanted : BaseType::Vector;
    BaseType type = parts.size() == 16 ? BaseType::Matrix : triple;
    return makeNode(ExprKind::Tuple, single(type), e.where, std::move(parts));
}

ExprPtr ExpressionChecker::index(const ast::Expr &e, bool asTarget) {
    const ast::Expr &indexed = *e.operands[0];
    TypeSet types = typesOf(indexed, here_);
    if (types.isOnly(BaseType::String) && !types.arrayLength)
        return here_.error(e.where, "a string cannot be indexed; a texture's channel, as in "
                                    "name[0], stands only as the first argument of texture(), "
                                    "environment(), shadow() or bump()");
    ExprPtr index = checkAs(*e.operands[1], BaseType::Float, "an index");
    if (types.arrayLength) {
        ExprPtr array = checkWholeArray(indexed, asTarget);
        if (!array || !index ||
            !constantIndexFits(*e.operands[1], array->type.length, "array " + indexed.text,
                               here_.reporter))
            return nullptr;
        Type element = single(array->type.base);
        return makeNode(ExprKind::Element, element, e.where,
                        list(std::move(array), std::move(index)));
    }
    ExprPtr triple = asTarget ? checkTarget(indexed) : check(indexed);
    if (!triple || !index)
        return nullptr;
    if (!isTriple(triple->type.base))
        return here_.error(e.where, "only arrays, colors, points, vectors and normals can be "
                                    "indexed, not a " +
                                        shapeOf(triple->type));
    if (!constantIndexFits(*e.operands[1], 3, std::string("a ") + nameOf(triple->type.base),
                           here_.reporter))
        return nullptr;
    return makeNode(ExprKind::Component, single(BaseType::Float), e.where,
                    list(std::move(triple), std::move(index)));
}

ExprPtr ExpressionChecker::logicalNot(const ast::Expr &e) {
    ExprPtr operand = checkAs(*e.operands[0], BaseType::Float, "the operand of '!'");
    if (!operand)
        return nullptr;
    return makeNode(ExprKind::Not, single(BaseType::Float), e.where, list(std::move(operand)));
}

ExprPtr ExpressionChecker::negation(const ast::Expr &e, Wanted wanted) {
    ExprPtr operand = check(*e.operands[0], wanted);
    if (!operand)
        return nullptr;
    BaseType base = operand->type.base;
    if (base == BaseType::String || base == BaseType::Void)
        return here_.error(e.where, std::string("'-' cannot be applied to a ") + nameOf(base));
    return makeNode(ExprKind::Negate, single(base), e.where, list(std::move(operand)));
}

// Point, vector and normal are one to the operators: no node between them.
static ExprPtr asOperand(ExprPtr e, BaseType type, const std::string &role, Reporter &reporter) {
    bool same = e && isGeometric(e->type.base) && isGeometric(type);
    return same ? std::move(e) : coerce(std::move(e), type, role, reporter);
}

/// What the chain may be is found from its first operand on, what it is from its last operator on.
ExprPtr ExpressionChecker::binary(const ast::Expr &e, Wanted wanted) {
    std::vector<Link> chain; // The last operator first.
    const ast::Expr *first = &e;
    for (; first->kind == ast::ExprKind::Binary; first = first->operands[0].get())
        chain.push_back({first, {}, {}, nullptr});
    TypeSet types = typesOf(*first, here_);
    for (auto link = chain.rbegin(); link != chain.rend(); ++link) {
        link->left = types;
        link->right = typesOf(*link->e->operands[1], here_);
        types = resultsOf(link->e->op, link->left, link->right);
    }
    auto link = chain.begin();
    for (; link != chain.end(); ++link) {
        link->form = chooseForm(link->e->op, link->left, link->right, wanted);
        if (!link->form)
            break;
        wanted = link->form->left;
    }
    ExprPtr value;
    if (link == chain.end())
        value = check(*first, wanted);
    else
        here_.error(link->e->where, std::string("operator '") + nameOf(link->e->op) +
                                        "' cannot be applied to " + link->left.text() + " and " +
                                        link->right.text());
    while (link != chain.begin())
        value = operation(*--link, std::move(value));
    return value;
}

ExprPtr ExpressionChecker::operation(const Link &link, ExprPtr left) {
    const ast::Expr &e = *link.e;
    const OperatorForm &form = *link.form;
    ExprPtr right = check(*e.operands[1], form.right);
    if (!left || !right)
        return nullptr;
    const std::string role = std::string("an operand of '") + nameOf(e.op) + "'";
    const bool dotOfColors = form.left == BaseType::Color && e.op == BinaryOp::Dot;
    for (auto [side, type] : {std::pair(&left, form.left), std::pair(&right, form.right)}) {
        *side = asOperand(std::move(*side), type, role, here_.reporter);
        if (!*side)
            return nullptr;
        if (dotOfColors)
            *side = converted(std::move(*side), BaseType::Vector);
    }
    return makeBinary(e.op, form.result, e.where, std::move(left), std::move(right));
}

ExprPtr ExpressionChecker::conditional(const ast::Expr &e, Wanted wanted) {
    TypeSet yes = typesOf(*e.operands[1], here_), no = typesOf(*e.operands[2], here_),
            types = typesOf(e, here_);
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
    if (types.empty() && !yes.empty() && !no.empty())
        return here_.error(e.where, "the branches of '?:' have no common type: " + yes.text() +
                                        " and " + no.text());
    ExprPtr test = checkAs(*e.operands[0], BaseType::Float, "the condition of '?:'");
    ExprPtr first = checkAs(*e.operands[1], best, "a branch of '?:'");
    ExprPtr second = checkAs(*e.operands[2], best, "a branch of '?:'");
    if (!test || !first || !second)
        return nullptr;
    return makeNode(ExprKind::Conditional, single(best), e.where,
                    list(std::move(test), std::move(first), std::move(second)));
}

ExprPtr ExpressionChecker::checkTarget(const ast::Expr &e) {
    if (e.kind == ast::ExprKind::Index)
        return index(e, true);
    if (e.kind != ast::ExprKind::Name)
        return here_.error(e.where,
                           "only variables, array elements and components can be assigned");
    Symbol *symbol = here_.names.find(e.text);
    if (!symbol && e.text == "PI")
        return here_.error(e.where, "PI is a constant and cannot be assigned");
    if (!symbol)
        return unknownVariable(e, here_);
    symbol->written = true;
    hintIfReadOnly(*symbol, e.where, here_);
    return makeVariable(*symbol, e.where);
}

ExprPtr ExpressionChecker::checkWholeArray(const ast::Expr &e, bool asTarget) {
    Symbol *symbol = e.kind == ast::ExprKind::Name ? here_.names.find(e.text) : nullptr;
    if (!symbol || !symbol->type.isArray())
        return here_.error(e.where, "expected the name of an array here");
    (asTarget ? symbol->written : symbol->read) = true;
    if (asTarget)
        hintIfReadOnly(*symbol, e.where, here_);
    return makeVariable(*symbol, e.where);
}

ExprPtr ExpressionChecker::assignment(const ast::Expr &e) {
    ExprPtr target = checkTarget(*e.operands[0]);
    if (target && target->type.isArray()) {
        here_.reporter.error(e.where, "an array cannot be assigned as a whole");
        target = nullptr;
    }
    if (!target) {
        check(*e.operands[1]);
        return nullptr;
    }
    ExprPtr value = assignedValue(e, target->type);
    if (!value)
        return nullptr;
    bool indexVaries = target->type.isVarying() && !symbolOf(*target).type.isVarying();
    Detail detail = indexVaries ? Detail::Varying : value->type.detail;
    if (!detailFits(*target, detail, e.where, here_.reporter))
        return nullptr;
    Type type = single(target->type.base);
    return makeNode(ExprKind::Assign, type, e.where, list(std::move(target), std::move(value)));
}

ExprPtr ExpressionChecker::assignedValue(const ast::Expr &e, const Type &target) {
    std::string role = "what is assigned here";
    const ast::Expr &right = *e.operands[1];
    if (!e.compound)
        return checkAs(right, target.base, role);
    TypeSet rightTypes = typesOf(right, here_);
    const OperatorForm *form = chooseForm(e.op, {target.base}, rightTypes, target.base);
    if (!form)
        return here_.error(e.where, std::string("operator '") + nameOf(e.op) +
                                        "=' cannot be applied to " + nameOf(target.base) + " and " +
                                        rightTypes.text());
    ExprPtr before =
        coerce(makeNode(ExprKind::TargetValue, target, e.where), form->left, role, here_.reporter);
    ExprPtr value = asOperand(check(right, form->right), form->right, role, here_.reporter);
    if (!value || !before)
        return nullptr;
    ExprPtr sum = makeBinary(e.op, form->result, e.where, std::move(before), std::move(value));
    return coerce(std::move(sum), target.base, role, here_.reporter);
}

ExprPtr ExpressionChecker::cast(const ast::Expr &e) {
    std::string type = nameOf(e.type);
    ExprPtr value = check(*e.operands[0], e.type);
    bool spaced = e.operands.size() > 1;
    if (spaced && (e.type == BaseType::Float || e.type == BaseType::Void))
        return here_.error(e.operands[1]->where, "a " + type +
                                                     " is in no space; only color, point, "
                                                     "vector, normal and matrix are");
    if (!value)
        return nullptr;
    if (!castable(value->type.base, e.type))
        return here_.error(e.where, "a " + shapeOf(value->type) + " cannot be cast to a " + type +
                                        conversionHint(value->type.base, e.type));
    if (value->type.base != e.type)
        value = makeNode(ExprKind::Convert, single(e.type), e.where, list(std::move(value)));
    if (!spaced)
        return value;
    ExprPtr space = check(*e.operands[1]);
    return makeNode(ExprKind::FromSpace, single(e.type), e.where,
                    list(std::move(value), std::move(space)));
}

} // namespace candela::sl
