// SPDX-License-Identifier: Apache-2.0
// What an expression may be before its context is known. Reports nothing: an empty set means that
// checking the expression will report an error.
#include "language/semantics/checker.h"
#include "language/semantics/operator_forms.h"

namespace candela::sl {

TypeSet Checker::typesOf(const ast::Expr &e) {
    using enum ast::ExprKind;
    switch (e.kind) {
    case Number:
    case Not: return {BaseType::Float};
    case Text: return {BaseType::String};
    case Name: return typesOfName(e);
    case Tuple:
        if (e.operands.size() == 16)
            return {BaseType::Matrix};
        return {BaseType::Color, BaseType::Point, BaseType::Vector, BaseType::Normal};
    case Index: return typesOfIndex(e);
    case Call: return typesOfCall(e);
    case Negate:
    case Assign: return typesOf(*e.operands[0]);
    case Binary: return resultsOf(e.op, typesOf(*e.operands[0]), typesOf(*e.operands[1]));
    case Conditional: return typesOfConditional(e);
    case Cast: return {e.type};
    }
    return {};
}

TypeSet Checker::typesOfName(const ast::Expr &e) {
    Symbol *symbol = findVariable(e.text);
    if (!symbol)
        return e.text == "PI" ? TypeSet{BaseType::Float} : TypeSet{};
    TypeSet result{symbol->type.base};
    result.arrayLength = symbol->type.length;
    return result;
}

TypeSet Checker::typesOfIndex(const ast::Expr &e) {
    TypeSet indexed = typesOf(*e.operands[0]);
    if (indexed.arrayLength) {
        indexed.arrayLength = 0;
        return indexed;
    }
    bool triple = indexed.hasGeometric() || indexed.has(BaseType::Color);
    return triple ? TypeSet{BaseType::Float} : TypeSet{};
}

TypeSet Checker::typesOfConditional(const ast::Expr &e) {
    TypeSet yes = typesOf(*e.operands[1]), no = typesOf(*e.operands[2]), result;
    for (int i = 0; i < baseTypeCount; ++i) {
        BaseType type = BaseType(i);
        bool named = yes.has(type) || no.has(type);
        if (named && conversionCost(yes, type) + conversionCost(no, type) < impossible)
            result.add(type);
    }
    return result;
}

std::vector<TypeSet> Checker::argumentTypes(const ast::Expr &call) {
    std::vector<TypeSet> result;
    for (const ast::ExprPtr &argument : call.operands)
        result.push_back(typesOf(*argument));
    return result;
}

TypeSet Checker::typesOfCall(const ast::Expr &e) {
    TypeSet result;
    std::vector<TypeSet> arguments = argumentTypes(e);
    for (FunctionDefinition *definition : context_.scope->findFunctions(e.text))
        if (!definition->inProgress && userCost(*definition, e, arguments) < impossible)
            result.add(resultOf(*definition));
    if (!result.empty())
        return result;
    if (const Builtin *function = findBuiltin(e.text))
        for (const BuiltinOverload &overload : function->overloads)
            if (builtinCost(overload, e, arguments) < impossible)
                result.add(overload.result);
    return result;
}

} // namespace candela::sl
