// SPDX-License-Identifier: Apache-2.0
#include "language/semantics/call_checker.h"

#include <algorithm>

#include "language/semantics/known_arguments.h"
#include "language/semantics/lint.h"
#include "language/semantics/named_arguments.h"
#include "language/semantics/overload_choice.h"
#include "language/semantics/targets.h"
#include "language/semantics/type_inference.h"
#include "language/semantics/typed_nodes.h"
#include "language/semantics/user_functions.h"

namespace candela::sl {

ExprPtr CallChecker::check(const ast::Expr &e, ExpressionChecker::Wanted wanted) {
    const Builtin *function = findBuiltin(e.text);
    if (!function && here_.names.functions(e.text).empty())
        return unknown(e, wanted);
    if (isDistance(e, wanted))
        return builtin(e, findBuiltin("rayhittest")->overloads.front());
    Callee callee = chooseCallee(e, wanted, here_);
    if (callee.definition)
        return user(e, *callee.definition);
    return callee.overload ? builtin(e, *callee.overload) : fittingNone(e);
}

/// trace() as a float is how far the ray gets.
bool CallChecker::isDistance(const ast::Expr &e, ExpressionChecker::Wanted wanted) const {
    return e.text == "trace" && wanted == BaseType::Float && e.operands.size() == 2 &&
           here_.names.functions(e.text).empty();
}

// What looks like a slip is one; all else is taken for a function of another renderer, loaded from
// an object file that is not here.
ExprPtr CallChecker::unknown(const ast::Expr &e, ExpressionChecker::Wanted wanted) {
    for (const ast::ExprPtr &argument : e.operands) {
        if (!typesOf(*argument, here_).arrayLength)
            expressions_.check(*argument);
        Symbol *symbol =
            argument->kind == ast::ExprKind::Name ? here_.names.find(argument->text) : nullptr;
        if (symbol) // It might have been set.
            symbol->written = true;
    }
    const std::string slip = here_.names.functionSuggestion(e.text);
    const std::string headers = here_.functions.headersRead();
    if (!slip.empty())
        return here_.error(e.where, "unknown function '" + e.text + "'" + slip + headers);
    here_.reporter.warnOnce(e.where, "unknown function '" + e.text +
                                         "' is taken for an external function of another "
                                         "renderer: its calls give 0" +
                                         (headers.empty() ? "; no header was read" : headers));
    return makeZero(wanted.value_or(BaseType::Float), e.where);
}

ExprPtr CallChecker::zero(const ast::Expr &e, const BuiltinOverload &overload) {
    here_.reporter.warnOnce(e.where, "function " + e.text +
                                         "() is known and gives 0: " + overload.function->doc);
    return makeZero(overload.result, e.where);
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

/// Angles are radians, but where a parameter is called otherwise.
void CallChecker::hintAtDegrees(const ast::Expr &e, const BuiltinOverload &overload) {
    for (size_t i = 0; i < std::min(e.operands.size(), overload.parameters.size()); ++i)
        if (overload.parameters[i].name == "angle" && looksLikeDegrees(*e.operands[i]))
            here_.reporter.hint(e.operands[i]->where, "the angle of " + e.text +
                                                          "() is in radians; this looks like "
                                                          "degrees");
}

/// One that follows the parameters, as a rule behind its name.
ExprPtr CallChecker::optionalArgument(const ast::Expr &e, size_t i, BuiltinId function) {
    const ast::Expr &given = *e.operands[i];
    const bool isArray = typesOf(given, here_).arrayLength > 0;
    const bool isSet = isNamedResult(function, e, i);
    if (isArray)
        return expressions_.checkWholeArray(given, isSet);
    return isSet ? expressions_.checkTarget(given) : expressions_.check(given);
}

ExprPtr CallChecker::builtin(const ast::Expr &e, const BuiltinOverload &overload) {
    const Builtin &function = *overload.function;
    std::vector<ExprPtr> arguments;
    const auto &parameters = overload.parameters;
    for (size_t i = 0; i < e.operands.size(); ++i) {
        bool open = i >= parameters.size() && !overload.repeatsLast;
        const BuiltinParameter *parameter =
            open ? nullptr : &parameters[std::min(i, parameters.size() - 1)];
        const bool hasChannel = i == 0 && channelOf(function, *e.operands[i]);
        const ast::Expr &given = hasChannel ? *e.operands[i]->operands[0] : *e.operands[i];
        ExprPtr value =
            parameter ? argument(given, *parameter, e.text) : optionalArgument(e, i, function.id);
        if (value)
            arguments.push_back(std::move(value));
    }
    if (arguments.size() != e.operands.size())
        return nullptr;
    if (function.available == Available::Zero)
        return zero(e, overload);
    hintAtDegrees(e, overload);
    checkStrings(e, function.id, arguments, here_.reporter);
    if (const ast::Expr *channel =
            e.operands.empty() ? nullptr : channelOf(function, *e.operands[0]))
        addChannel(*channel, arguments);
    if (!componentsExist(e, overload, here_.reporter))
        return nullptr;
    warnOfColorAsVector(e, overload, here_.reporter);
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
