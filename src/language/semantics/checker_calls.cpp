// SPDX-License-Identifier: Apache-2.0
// Calls: which function is meant, and its arguments.
#include <algorithm>

#include "language/semantics/checker.h"
#include "language/semantics/print_pattern.h"
#include "language/semantics/spellings.h"

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

int Checker::builtinCost(const BuiltinOverload &overload, const ast::Expr &call,
                         const std::vector<TypeSet> &types) {
    const auto &parameters = overload.parameters;
    bool more = types.size() > parameters.size();
    if (types.size() < parameters.size() || (more && !overload.repeatsLast && !overload.openEnded))
        return impossible;
    int cost = 0;
    for (size_t i = 0; i < types.size() && cost < impossible; ++i) {
        bool extra = i >= parameters.size();
        if (extra && !overload.repeatsLast) {
            cost += types[i].arrayLength ? impossible : 0;
            continue;
        }
        const BuiltinParameter &p = parameters[std::min(i, parameters.size() - 1)];
        const ast::Expr &argument = *call.operands[i];
        if (!p.anyType)
            cost += argumentCost(types[i], p.type, p.output, p.array, argument);
        else if (p.array != (types[i].arrayLength > 0) || (p.output && !isTargetLike(argument)))
            cost = impossible;
    }
    return std::min(cost, impossible);
}

int Checker::userCost(const FunctionDefinition &definition, const ast::Expr &call,
                      const std::vector<TypeSet> &types) {
    const auto &formals = definition.syntax->formals;
    if (types.size() != formals.size())
        return impossible;
    int cost = 0;
    for (size_t i = 0; i < types.size() && cost < impossible; ++i) {
        const ast::Variable &f = formals[i];
        cost += argumentCost(types[i], f.type, f.output, f.isArray, *call.operands[i]);
    }
    return std::min(cost, impossible);
}

// The user's own functions hide built-in ones, unless none of them fits. In its own body, a
// function that is called like a built-in one means that one: there is no recursion.
Checker::Callee Checker::chooseCallee(const ast::Expr &call, Wanted wanted) {
    Callee best;
    std::vector<TypeSet> types = argumentTypes(call);
    int bestTotal = impossible;
    auto consider = [&](Callee candidate) {
        if (candidate.cost >= impossible)
            return;
        int total = candidate.cost + contextCost(candidate.result, wanted);
        if (total < bestTotal) {
            best = candidate;
            bestTotal = total;
        }
    };
    const auto definitions = context_.scope->findFunctions(call.text);
    auto considerOwn = [&](bool inProgress) {
        for (FunctionDefinition *definition : definitions) {
            int cost = userCost(*definition, call, types);
            if (cost < impossible && definition->inProgress == inProgress)
                consider({nullptr, definition, resultOf(*definition), cost});
        }
    };
    considerOwn(false);
    const Builtin *function = findBuiltin(call.text);
    if (!best.definition && function)
        for (const BuiltinOverload &overload : function->overloads)
            consider({&overload, nullptr, overload.result, builtinCost(overload, call, types)});
    if (!best.definition && !best.overload)
        considerOwn(true); // A recursion, which is reported.
    return best;
}

ExprPtr Checker::checkCall(const ast::Expr &e, Wanted wanted) {
    bool known = !context_.scope->findFunctions(e.text).empty() || findBuiltin(e.text);
    if (!known) {
        unknownFunction(e);
        for (const ast::ExprPtr &argument : e.operands)
            check(*argument);
        return nullptr;
    }
    Callee callee = chooseCallee(e, wanted);
    if (callee.definition)
        return callUser(e, *callee.definition);
    const Builtin *function = findBuiltin(e.text);
    if (function && function->available == Available::Later) {
        reporter_.error(e.where, "function " + e.text +
                                     "() is not available yet in this version "
                                     "of Candela");
        return nullptr;
    }
    if (!callee.overload) {
        noFittingOverload(e);
        return nullptr;
    }
    return callBuiltin(e, *callee.overload);
}

void Checker::unknownFunction(const ast::Expr &e) {
    std::vector<std::string> names;
    context_.scope->collectFunctionNames(names);
    for (const Builtin &function : builtins())
        names.emplace_back(function.name);
    reporter_.error(e.where, "unknown function '" + e.text + "'" + suggestion(e.text, names));
}

static std::string signatureOf(const ast::Function &function) {
    std::string list;
    for (const ast::Variable &formal : function.formals)
        list += (list.empty() ? "" : ", ") + std::string(formal.output ? "output " : "") +
                nameOf(formal.type) + " " + formal.name + (formal.isArray ? "[]" : "");
    std::string result = function.result ? nameOf(*function.result) + std::string(" ") : "";
    return result + function.name + "(" + list + ")";
}

void Checker::noFittingOverload(const ast::Expr &e) {
    int errors = reporter_.errorCount();
    for (const ast::ExprPtr &argument : e.operands)
        if (!typesOf(*argument).arrayLength)
            check(*argument);
    if (reporter_.errorCount() > errors)
        return;
    std::string given;
    for (const TypeSet &types : argumentTypes(e))
        given += (given.empty() ? "" : ", ") + (types.empty() ? "?" : types.text());
    std::vector<std::string> forms;
    for (FunctionDefinition *definition : context_.scope->findFunctions(e.text))
        forms.push_back(signatureOf(*definition->syntax));
    if (const Builtin *function = findBuiltin(e.text))
        for (const BuiltinOverload &overload : function->overloads)
            forms.push_back(overload.signature());
    std::string expected;
    constexpr size_t shown = 4;
    for (size_t i = 0; i < std::min(forms.size(), shown); ++i)
        expected += (i ? "; " : "") + forms[i];
    if (forms.size() > shown)
        expected += "; and " + std::to_string(forms.size() - shown) + " more";
    reporter_.error(e.where,
                    e.text + " cannot be called with (" + given + "); expected " + expected);
}

ExprPtr Checker::builtinArgument(const ast::Expr &argument, const BuiltinParameter &parameter,
                                 const std::string &name) {
    std::string role = "argument '" + parameter.name + "' of " + name;
    ExprPtr result;
    if (parameter.array)
        result = wholeArray(argument, parameter.output);
    else if (parameter.output)
        result = checkTarget(argument);
    else if (parameter.anyType)
        result = check(argument);
    else
        result = checkAs(argument, parameter.type, role);
    if (result && parameter.uniform && result->type.isVarying()) {
        reporter_.error(result->where, role + " must be uniform");
        return nullptr;
    }
    return result;
}

ExprPtr Checker::callBuiltin(const ast::Expr &e, const BuiltinOverload &overload) {
    const Builtin &function = *overload.function;
    std::vector<ExprPtr> arguments;
    const auto &parameters = overload.parameters;
    for (size_t i = 0; i < e.operands.size(); ++i) {
        bool open = i >= parameters.size() && !overload.repeatsLast;
        const ast::Expr &operand = *e.operands[i];
        ExprPtr argument =
            open ? check(operand)
                 : builtinArgument(operand, parameters[std::min(i, parameters.size() - 1)], e.text);
        if (argument)
            arguments.push_back(std::move(argument));
    }
    if (arguments.size() != e.operands.size())
        return nullptr;
    checkStrings(e, overload, arguments);
    if (!componentExists(e, overload))
        return nullptr;
    Detail inputs = Detail::Uniform;
    for (const ExprPtr &argument : arguments)
        inputs = joined(inputs, argument->type.detail);
    for (size_t i = 0; i < parameters.size(); ++i)
        if (parameters[i].output && !detailFits(*arguments[i], inputs, arguments[i]->where))
            return nullptr;
    ExprPtr result = node(ExprKind::Builtin, {overload.result, Detail::Uniform, 0}, e.where,
                          std::move(arguments));
    if (function.uniformity == Uniformity::Varying)
        result->type.detail = Detail::Varying;
    if (function.uniformity == Uniformity::Uniform)
        result->type.detail = Detail::Uniform;
    result->overload = &overload;
    return result;
}

ExprPtr Checker::wholeArray(const ast::Expr &e, bool asTarget) {
    Symbol *symbol = e.kind == ast::ExprKind::Name ? findVariable(e.text) : nullptr;
    if (!symbol || !symbol->type.isArray()) {
        reporter_.error(e.where, "expected the name of an array here");
        return nullptr;
    }
    (asTarget ? symbol->written : symbol->read) = true;
    if (asTarget && !mayWrite(*symbol, e.where))
        return nullptr;
    return variable(*symbol, e.where);
}

ExprPtr Checker::userArgument(const ast::Expr &argument, const ast::Variable &formal,
                              const std::string &name) {
    std::string role = "argument '" + formal.name + "' of " + name;
    ExprPtr result;
    if (formal.isArray)
        result = wholeArray(argument, formal.output);
    else if (formal.output)
        result = checkTarget(argument);
    else
        result = checkAs(argument, formal.type, role);
    if (!result)
        return nullptr;
    if (formal.detail == Detail::Uniform && result->type.isVarying()) {
        reporter_.error(result->where, role + " must be uniform");
        return nullptr;
    }
    if (formal.output && formal.detail == Detail::Varying &&
        !detailFits(*result, Detail::Varying, result->where))
        return nullptr;
    return result;
}

ExprPtr Checker::callUser(const ast::Expr &e, FunctionDefinition &definition) {
    std::vector<ExprPtr> arguments;
    std::vector<Type> types;
    for (size_t i = 0; i < e.operands.size(); ++i) {
        const ast::Variable &formal = definition.syntax->formals[i];
        ExprPtr argument = userArgument(*e.operands[i], formal, e.text);
        if (!argument)
            continue;
        Detail detail = formal.detail.value_or(argument->type.detail);
        types.push_back({formal.type, detail, argument->type.length});
        arguments.push_back(std::move(argument));
    }
    if (arguments.size() != e.operands.size())
        return nullptr;
    const Function *function = instantiate(definition, types, e.where);
    if (!function)
        return nullptr;
    if (function->hasLightStatement && context_.lightStatement) {
        reporter_.error(e.where, "function " + e.text +
                                     " has a light statement and cannot be "
                                     "called inside another");
        return nullptr;
    }
    if (context_.function)
        context_.function->hasLightStatement |= function->hasLightStatement;
    ExprPtr result = node(ExprKind::Call, {}, e.where, std::move(arguments));
    result->type = function->result;
    result->function = function;
    return result;
}

// Strings that are known now and mean something are checked now.
void Checker::checkStrings(const ast::Expr &e, const BuiltinOverload &overload,
                           const std::vector<ExprPtr> &arguments) {
    BuiltinId id = overload.function->id;
    if (id == BuiltinId::printf || id == BuiltinId::format)
        checkPattern(e, arguments);
    for (const ExprPtr &argument : arguments) {
        if (argument->kind != ExprKind::Text)
            continue;
        if (id == BuiltinId::spline && splineBasisSpelled(argument->text).empty())
            reporter_.error(argument->where, "unknown spline basis \"" + argument->text +
                                                 "\"; expected " + splineBasisNames);
        if (id == BuiltinId::ctransform && colorSpaceSpelled(argument->text).empty())
            reporter_.error(argument->where, "unknown colour space \"" + argument->text +
                                                 "\"; expected " + colorSpaceNames);
    }
}

// Of comp() and setcomp(): (triple, index, ...) or (matrix, row, column, ...).
bool Checker::componentExists(const ast::Expr &e, const BuiltinOverload &overload) {
    const BuiltinId id = overload.function->id;
    if (id != BuiltinId::comp && id != BuiltinId::setcomp)
        return true;
    const BaseType base = overload.parameters[0].type;
    const std::string what = std::string("a ") + nameOf(base);
    if (base == BaseType::Matrix)
        return constantIndexFits(*e.operands[1], 4, what) &&
               constantIndexFits(*e.operands[2], 4, what);
    return constantIndexFits(*e.operands[1], 3, what);
}

void Checker::checkPattern(const ast::Expr &e, const std::vector<ExprPtr> &arguments) {
    if (arguments[0]->kind != ExprKind::Text)
        return;
    size_t next = 1;
    for (const PrintPiece &piece : splitPrintPattern(arguments[0]->text)) {
        if (!piece.converts)
            continue;
        if (next < arguments.size() && !printsType(piece.letter, arguments[next]->type.base))
            reporter_.error(arguments[next]->where,
                            "'" + piece.conversion() + "' in the pattern of " + e.text +
                                " cannot print a " + nameOf(arguments[next]->type.base));
        ++next;
    }
    if (next != arguments.size())
        reporter_.error(e.where, "the pattern of " + e.text + " asks for " +
                                     std::to_string(next - 1) + " values, but " +
                                     std::to_string(arguments.size() - 1) + " are given");
}

} // namespace candela::sl
