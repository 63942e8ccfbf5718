// SPDX-License-Identifier: Apache-2.0
#include "language/semantics/call_cost.h"

#include "language/semantics/named_arguments.h"

#include <algorithm>

namespace candela::sl {

static bool isTargetLike(const ast::Expr &e) {
    return e.kind == ast::ExprKind::Name || e.kind == ast::ExprKind::Index;
}

/// Of handing a value of these types to a parameter.
static int argumentCost(const TypeSet &types, BaseType type, bool output, bool array,
                        const ast::Expr &argument) {
    if (types.empty())
        return 0; // An error that checking the argument will report.
    if (output && !isTargetLike(argument))
        return impossible;
    if (array != (types.arrayLength > 0))
        return impossible;
    TypeSet elements = types;
    elements.arrayLength = 0;
    int cost = conversionCost(elements, type);
    // References and arrays can be reinterpreted, not promoted.
    return (output || array) && cost > 1 ? impossible : cost;
}

int callCost(const BuiltinOverload &overload, const ast::Expr &call,
             const std::vector<TypeSet> &types) {
    const auto &parameters = overload.parameters;
    bool more = types.size() > parameters.size();
    if (types.size() < parameters.size() || (more && !overload.repeatsLast && !overload.openEnded))
        return impossible;
    int cost = 0;
    for (size_t i = 0; i < types.size() && cost < impossible; ++i) {
        bool extra = i >= parameters.size();
        if (extra && !overload.repeatsLast) {
            if (types[i].arrayLength && !isNamedResult(overload.function->id, call, i))
                cost = impossible;
            continue;
        }
        const BuiltinParameter &p = parameters[std::min(i, parameters.size() - 1)];
        const ast::Expr &argument = *call.operands[i];
        if (p.proper && types[i].has(BaseType::Float))
            cost = impossible;
        else if (!p.anyType)
            cost += argumentCost(types[i], p.type, p.output, p.array, argument);
        else if (p.array != (types[i].arrayLength > 0) || (p.output && !isTargetLike(argument)))
            cost = impossible;
    }
    return std::min(cost, impossible);
}

int callCost(const ast::Function &function, const ast::Expr &call,
             const std::vector<TypeSet> &types) {
    const auto &formals = function.formals;
    if (types.size() != formals.size())
        return impossible;
    int cost = 0;
    for (size_t i = 0; i < types.size() && cost < impossible; ++i) {
        const ast::Variable &f = formals[i];
        cost += argumentCost(types[i], f.type, f.output, f.isArray, *call.operands[i]);
    }
    return std::min(cost, impossible);
}

} // namespace candela::sl
