// SPDX-License-Identifier: Apache-2.0
#include "language/semantics/user_functions.h"

#include <algorithm>

#include "language/semantics/statement_checker.h"
#include "language/semantics/variables.h"

namespace candela::sl {

static constexpr int instanceDepthLimit = 64;
static constexpr size_t instanceLimit = 2000;

static bool sameSignature(const FunctionDefinition &a, const ast::Function &b) {
    auto sameFormal = [](const ast::Variable &f, const ast::Variable &g) {
        return f.type == g.type && f.isArray == g.isArray;
    };
    return a.result == b.result && std::ranges::equal(a.syntax->formals, b.formals, sameFormal);
}

void UserFunctions::define(const ast::Function &syntax, Scope &scope) {
    for (FunctionDefinition *other : scope.findFunctions(syntax.name)) {
        if (other->scope != &scope || !sameSignature(*other, syntax))
            continue;
        const Place &first = other->syntax->where;
        reporter_.warning(syntax.where, "function " + syntax.name +
                                            " with these arguments is defined again: this "
                                            "definition counts, not that in " +
                                            first.file->name() + ", line " +
                                            std::to_string(first.line));
        scope.dropFunction(other);
        other->checked = true;
    }
    auto definition = std::make_unique<FunctionDefinition>();
    definition->syntax = &syntax;
    definition->scope = &scope;
    definition->result = syntax.result;
    scope.declareFunction(definition.get());
    definitions_.push_back(std::move(definition));
}

std::vector<Type> UserFunctions::generalArguments(const ast::Function &syntax) {
    std::vector<Type> result;
    for (const ast::Variable &formal : syntax.formals) {
        int length = 0;
        if (formal.isArray)
            length = formal.length ? arrayLength(formal, reporter_).value_or(1) : arrayLimit;
        result.push_back({formal.type, formal.detail.value_or(naturalDetail(formal.type)), length});
    }
    return result;
}

BaseType UserFunctions::resultOf(FunctionDefinition &definition) {
    if (!definition.result && !definition.inProgress) {
        instantiate(definition, generalArguments(*definition.syntax), definition.syntax->where);
        if (!definition.result)
            definition.result = BaseType::Void;
    }
    return definition.result.value_or(BaseType::Void);
}

const Function *UserFunctions::instantiate(FunctionDefinition &definition,
                                           const std::vector<Type> &arguments, const Place &call) {
    const std::string &name = definition.syntax->name;
    if (definition.inProgress) {
        reporter_.error(call, "function " + name +
                                  " calls itself; the Shading Language has no "
                                  "recursion");
        return nullptr;
    }
    std::string key;
    for (const Type &type : arguments)
        key += (type.isVarying() ? "v" : "u") + std::to_string(type.length);
    auto known = definition.instances.find(key);
    if (known != definition.instances.end())
        return known->second;
    if (depth_ >= instanceDepthLimit || shader_.functions.size() >= instanceLimit) {
        reporter_.error(call, "functions call each other too deeply here");
        return nullptr;
    }
    auto instance = std::make_unique<Function>();
    ++depth_;
    check(definition, arguments, *instance);
    --depth_;
    const Function *result = instance.get();
    definition.instances[key] = result;
    shader_.functions.push_back(std::move(instance)); // Behind all that it calls.
    return result;
}

void UserFunctions::check(FunctionDefinition &definition, const std::vector<Type> &arguments,
                          Function &instance) {
    const ast::Function &syntax = *definition.syntax;
    instance.name = syntax.name;
    instance.where = syntax.where;
    Surroundings here{Names(symbols_, reporter_, definition.scope->addInner(), &instance), *this,
                      reporter_, &instance};
    StatementChecker body(here, &definition);
    definition.inProgress = definition.checked = true;
    instance.formals = declareFormals(syntax, arguments, here.names);
    body.check(syntax.body->body, instance.body);
    definition.inProgress = false;
    bool promises = definition.result.value_or(BaseType::Void) != BaseType::Void;
    if (promises && !body.returned().any)
        reporter_.hint(syntax.where, "function " + syntax.name +
                                         " returns no value; its "
                                         "result is 0");
    instance.result.base = definition.result.value_or(BaseType::Void);
    instance.result.detail = body.returned().detail;
}

std::vector<Symbol *> UserFunctions::declareFormals(const ast::Function &syntax,
                                                    const std::vector<Type> &arguments,
                                                    Names &names) {
    std::vector<Symbol *> result;
    for (size_t i = 0; i < arguments.size(); ++i) {
        const ast::Variable &formal = syntax.formals[i];
        const int given = arguments[i].length;
        if (formal.initialised)
            reporter_.error(formal.where, "arguments of functions have no default values");
        if (formal.length && arrayLength(formal, reporter_).value_or(given) != given)
            reporter_.error(formal.where,
                            "array argument " + formal.name +
                                " is given an array of another length: " + std::to_string(given));
        Symbol &symbol = names.declare(Symbol::Kind::Formal, formal, arguments[i]);
        symbol.read = true;
        result.push_back(&symbol);
    }
    return result;
}

void UserFunctions::checkUncalled(const SourceFile &file, const Scope *except) {
    for (size_t i = 0; i < definitions_.size(); ++i) { // Checking may add nested ones.
        FunctionDefinition &definition = *definitions_[i];
        const ast::Function &syntax = *definition.syntax;
        if (!definition.checked && syntax.where.file == &file && definition.scope != except)
            instantiate(definition, generalArguments(syntax), syntax.where);
    }
}

} // namespace candela::sl
