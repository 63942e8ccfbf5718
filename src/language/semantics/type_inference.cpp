// SPDX-License-Identifier: Apache-2.0
#include "language/semantics/type_inference.h"

#include "language/semantics/call_cost.h"
#include "language/semantics/operator_forms.h"
#include "language/semantics/user_functions.h"

namespace candela::sl {

static const TypeSet anySingleType{BaseType::Float,  BaseType::Color,  BaseType::Point,
                                   BaseType::Vector, BaseType::Normal, BaseType::Matrix,
                                   BaseType::String};

static TypeSet typesOfName(const ast::Expr &e, const Surroundings &here) {
    Symbol *symbol = here.names.find(e.text);
    if (!symbol)
        return e.text == "PI" ? TypeSet{BaseType::Float} : TypeSet{};
    TypeSet result{symbol->type.base};
    result.arrayLength = symbol->type.length;
    return result;
}

static TypeSet typesOfIndex(const ast::Expr &e, const Surroundings &here) {
    TypeSet indexed = typesOf(*e.operands[0], here);
    if (indexed.arrayLength) {
        indexed.arrayLength = 0;
        return indexed;
    }
    if (indexed.isOnly(BaseType::String)) // A texture and its channel.
        return indexed;
    bool triple = indexed.hasGeometric() || indexed.has(BaseType::Color);
    return triple ? TypeSet{BaseType::Float} : TypeSet{};
}

static TypeSet typesOfConditional(const ast::Expr &e, const Surroundings &here) {
    TypeSet yes = typesOf(*e.operands[1], here), no = typesOf(*e.operands[2], here), result;
    for (int i = 0; i < baseTypeCount; ++i) {
        BaseType type = BaseType(i);
        bool named = yes.has(type) || no.has(type);
        if (named && conversionCost(yes, type) + conversionCost(no, type) < impossible)
            result.add(type);
    }
    return result;
}

static TypeSet typesOfCall(const ast::Expr &e, const Surroundings &here) {
    TypeSet result;
    std::vector<TypeSet> arguments = argumentTypes(e, here);
    for (FunctionDefinition *definition : here.names.functions(e.text))
        if (!definition->inProgress && callCost(*definition->syntax, e, arguments) < impossible)
            result.add(here.functions.resultOf(*definition));
    if (!result.empty())
        return result;
    const Builtin *function = findBuiltin(e.text);
    if (!function && here.names.functions(e.text).empty())
        return anySingleType; // An external function gives what is wanted of it.
    if (function)
        for (const BuiltinOverload &overload : function->overloads)
            if (callCost(overload, e, arguments) < impossible)
                result.add(overload.result);
    return result;
}

std::vector<TypeSet> argumentTypes(const ast::Expr &call, const Surroundings &here) {
    std::vector<TypeSet> result;
    for (const ast::ExprPtr &argument : call.operands)
        result.push_back(typesOf(*argument, here));
    return result;
}

TypeSet typesOf(const ast::Expr &e, const Surroundings &here) {
    auto operand = [&](size_t i) { return typesOf(*e.operands[i], here); };
    using enum ast::ExprKind;
    switch (e.kind) {
    case Number:
    case Not: return {BaseType::Float};
    case Text: return {BaseType::String};
    case Name: return typesOfName(e, here);
    case Tuple:
        if (e.operands.size() == 16)
            return {BaseType::Matrix};
        return {BaseType::Color, BaseType::Point, BaseType::Vector, BaseType::Normal};
    case Index: return typesOfIndex(e, here);
    case Call: return typesOfCall(e, here);
    case Negate:
    case Assign: return operand(0);
    case Binary: return resultsOf(e.op, operand(0), operand(1));
    case Conditional: return typesOfConditional(e, here);
    case Cast: return {e.type};
    }
    return {};
}

} // namespace candela::sl
