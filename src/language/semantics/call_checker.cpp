// SPDX-License-Identifier: Apache-2.0
#include "language/semantics/call_checker.h"

#include <algorithm>

#include "language/semantics/known_arguments.h"
#include "language/semantics/overload_choice.h"
#include "language/semantics/targets.h"
#include "language/semantics/type_inference.h"
#include "language/semantics/typed_nodes.h"
#include "language/semantics/user_functions.h"

namespace candela::sl {

ExprPtr CallChecker::check(const ast::Expr &e, ExpressionChecker::Wanted wanted) {
    const Builtin *function = findBuiltin(e.text);
    if (!function && here_.names.functions(e.text).empty())
        return unknown(e);
    Callee callee = chooseCallee(e, wanted, here_);
    if (callee.definition)
        return user(e, *callee.definition);
    if (function && function->available == Available::Later)
        return here_.error(e.where, "function " + e.text +
                                        "() is not available yet in this version "
                                        "of Candela");
    return callee.overload ? builtin(e, *callee.overload) : fittingNone(e);
}

ExprPtr CallChecker::unknown(const ast::Expr &e) {
    here_.reporter.error(e.where, "unknown function '" + e.text + "'" +
                                      here_.names.functionSuggestion(e.text));
    for (const ast::ExprPtr &argument : e.operands)
        expressions_.check(*argument);
    return nullptr;
}

ExprPtr CallChecker::fittingNone(const ast::Expr &e) {
    int errors = here_.reporter.errorCount();
    for (const ast::ExprPtr &argument : e.operands)
        if (!typesOf(*argument, here_).arrayLength)
            expressions_.check(*argument);
    if (here_.reporter.errorCount() > errors)
        return nullptr;
    std::string given;
    for (const TypeSet &types : argumentTypes(e, here_))
        given += (given.empty() ? "" : ", ") + (types.empty() ? "?" : types.text());
    return here_.error(e.where, e.text + " cannot be called with (" + given + "); expected " +
                                    signatures(e.text, here_.names));
}

/// The channel in name[channel], where a texture's name stands; null for other arguments.
const ast::Expr *CallChecker::channelOf(const Builtin &function, const ast::Expr &argument) const {
    if (function.lowering != Lowering::Texture || argument.kind != ast::ExprKind::Index)
        return nullptr;
    const TypeSet types = typesOf(*argument.operands[0], here_);
    return types.isOnly(BaseType::String) && !types.arrayLength ? argument.operands[1].get()
                                                                : nullptr;
}

/// Behind the arguments, as a parameter like "blur".
void CallChecker::addChannel(const ast::Expr &channel, std::vector<ExprPtr> &arguments) {
    if (ExprPtr value = expressions_.checkAs(channel, BaseType::Float, "a texture's channel")) {
        arguments.push_back(makeText("channel", channel.where));
        arguments.push_back(std::move(value));
    }
}

ExprPtr CallChecker::argument(const ast::Expr &e, const BuiltinParameter &parameter,
                              const std::string &name) {
    std::string role = "argument '" + parameter.name + "' of " + name;
    ExprPtr result;
    if (parameter.array)
        result = expressions_.checkWholeArray(e, parameter.output);
    else if (parameter.output)
        result = expressions_.checkTarget(e);
    else if (parameter.anyType)
        result = expressions_.check(e);
    else
        result = expressions_.checkAs(e, parameter.type, role);
    if (result && parameter.uniform && result->type.isVarying())
        return here_.error(result->where, role + " must be uniform");
    return result;
}

ExprPtr CallChecker::builtin(const ast::Expr &e, const BuiltinOverload &overload) {
    const Builtin &function = *overload.function;
    std::vector<ExprPtr> arguments;
    const auto &parameters = overload.parameters;
    for (size_t i = 0; i < e.operands.size(); ++i) {
        bool open = i >= parameters.size() && !overload.repeatsLast;
        const BuiltinParameter *parameter =
            open ? nullptr : &parameters[std::min(i, parameters.size() - 1)];
        const ast::Expr *given = e.operands[i].get();
        if (i == 0 && channelOf(function, *given))
            given = given->operands[0].get();
        ExprPtr value =
            parameter ? argument(*given, *parameter, e.text) : expressions_.check(*given);
        if (value)
            arguments.push_back(std::move(value));
    }
    if (arguments.size() != e.operands.size())
        return nullptr;
    checkStrings(e, function.id, arguments, here_.reporter);
    if (const ast::Expr *channel =
            e.operands.empty() ? nullptr : channelOf(function, *e.operands[0]))
        addChannel(*channel, arguments);
    if (!componentsExist(e, overload, here_.reporter))
        return nullptr;
    Detail inputs = Detail::Uniform;
    for (const ExprPtr &argument : arguments)
        inputs = joined(inputs, argument->type.detail);
    for (size_t i = 0; i < parameters.size(); ++i)
        if (parameters[i].output &&
            !detailFits(*arguments[i], inputs, arguments[i]->where, here_.reporter))
            return nullptr;
    ExprPtr result = makeNode(ExprKind::Builtin, {overload.result, Detail::Uniform, 0}, e.where,
                              std::move(arguments));
    if (function.uniformity == Uniformity::Varying)
        result->type.detail = Detail::Varying;
    if (function.uniformity == Uniformity::Uniform)
        result->type.detail = Detail::Uniform;
    result->overload = &overload;
    return result;
}

ExprPtr CallChecker::userArgument(const ast::Expr &e, const ast::Variable &formal,
                                  const std::string &name) {
    bool uniform = formal.detail == Detail::Uniform, varying = formal.detail == Detail::Varying;
    ExprPtr result =
        argument(e, {formal.name, formal.type, formal.output, formal.isArray, uniform}, name);
    if (result && formal.output && varying &&
        !detailFits(*result, Detail::Varying, result->where, here_.reporter))
        return nullptr;
    return result;
}

ExprPtr CallChecker::user(const ast::Expr &e, FunctionDefinition &definition) {
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
    const Function *function = here_.functions.instantiate(definition, types, e.where);
    if (!function)
        return nullptr;
    if (function->hasLightStatement && here_.lightStatement)
        return here_.error(e.where, "function " + e.text +
                                        " has a light statement and cannot be "
                                        "called inside another");
    if (here_.function)
        here_.function->hasLightStatement |= function->hasLightStatement;
    ExprPtr result = makeNode(ExprKind::Call, {}, e.where, std::move(arguments));
    result->type = function->result;
    result->function = function;
    return result;
}

} // namespace candela::sl
