// SPDX-License-Identifier: Apache-2.0
// The user's functions: one checked instance for each combination of uniform and varying arguments.
#include <algorithm>

#include "language/semantics/checker.h"

namespace candela::sl {

static constexpr int instanceDepthLimit = 64;
static constexpr size_t instanceLimit = 2000;

void Checker::defineFunction(const ast::Function &syntax, Scope *scope) {
    for (FunctionDefinition *other : scope->findFunctions(syntax.name)) {
        if (other->scope != scope || other->syntax->formals.size() != syntax.formals.size() ||
            other->result != syntax.result)
            continue;
        bool same = true;
        for (size_t i = 0; i < syntax.formals.size(); ++i)
            same &= other->syntax->formals[i].type == syntax.formals[i].type &&
                    other->syntax->formals[i].isArray == syntax.formals[i].isArray;
        if (same)
            reporter_.error(syntax.where, "function " + syntax.name +
                                              " with these arguments is defined in line " +
                                              std::to_string(other->syntax->where.line) +
                                              " already");
    }
    auto definition = std::make_unique<FunctionDefinition>();
    definition->syntax = &syntax;
    definition->scope = scope;
    definition->result = syntax.result;
    scope->declareFunction(definition.get());
    definitions_.push_back(std::move(definition));
}

// Arguments that stand for any: what a function is checked with that nobody calls.
std::vector<Type> Checker::generalArguments(const FunctionDefinition &definition) {
    std::vector<Type> result;
    for (const ast::Variable &formal : definition.syntax->formals) {
        int length = 0;
        if (formal.isArray)
            length = formal.length ? arrayLength(formal).value_or(1) : 1 << 16;
        Detail natural = formal.type == BaseType::String ? Detail::Uniform : Detail::Varying;
        result.push_back({formal.type, formal.detail.value_or(natural), length});
    }
    return result;
}

BaseType Checker::resultOf(FunctionDefinition &definition) {
    if (!definition.result && !definition.inProgress) {
        instantiate(definition, generalArguments(definition), definition.syntax->where);
        if (!definition.result)
            definition.result = BaseType::Void;
    }
    return definition.result.value_or(BaseType::Void);
}

const Function *Checker::instantiate(FunctionDefinition &definition,
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
    if (instanceDepth_ >= instanceDepthLimit || shader_->functions.size() >= instanceLimit) {
        reporter_.error(call, "functions call each other too deeply here");
        return nullptr;
    }
    auto function = std::make_unique<Function>();
    function->name = name;
    function->where = definition.syntax->where;
    function->result.base = definition.result.value_or(BaseType::Void);
    checkInstance(definition, *function, arguments);
    const Function *result = function.get();
    definition.instances[key] = result;
    shader_->functions.push_back(std::move(function)); // Behind all that it calls.
    return result;
}

void Checker::checkInstance(FunctionDefinition &definition, Function &function,
                            const std::vector<Type> &arguments) {
    Context outer = std::move(context_);
    context_ = Context{};
    context_.scope = newScope(definition.scope);
    context_.function = &function;
    context_.definition = &definition;
    definition.inProgress = definition.checked = true;
    ++instanceDepth_;
    for (size_t i = 0; i < arguments.size(); ++i) {
        const ast::Variable &formal = definition.syntax->formals[i];
        if (formal.initialised)
            reporter_.error(formal.where, "arguments of functions have no default values");
        if (formal.length &&
            arrayLength(formal).value_or(arguments[i].length) != arguments[i].length)
            reporter_.error(formal.where, "array argument " + formal.name +
                                              " is given an array of another length: " +
                                              std::to_string(arguments[i].length));
        Symbol *symbol = declareSymbol(Symbol::Kind::Formal, formal, arguments[i]);
        symbol->read = true;
        function.formals.push_back(symbol);
    }
    statements(definition.syntax->body->body, function.body);
    --instanceDepth_;
    definition.inProgress = false;
    bool promises = definition.result && *definition.result != BaseType::Void;
    if (promises && !context_.returns)
        reporter_.warning(function.where, "function " + function.name +
                                              " returns no value; its "
                                              "result is 0");
    if (definition.result)
        function.result.base = *definition.result;
    function.result.detail = context_.resultDetail;
    context_ = std::move(outer);
}

// Errors in functions of this file are told even if nobody calls them; those that an #include
// brought in, or that stand between several shaders, may be meant for other kinds of shaders.
void Checker::checkUncalled() {
    auto isShader = [](const ast::Item &item) { return std::holds_alternative<ast::Shader>(item); };
    bool several = std::ranges::count_if(file_.items, isShader) > 1;
    for (size_t i = 0; i < definitions_.size(); ++i) {
        FunctionDefinition &definition = *definitions_[i];
        bool elsewhere = definition.syntax->where.file != &mainFile_;
        if (definition.checked || elsewhere || (several && definition.scope == fileScope_))
            continue;
        instantiate(definition, generalArguments(definition), definition.syntax->where);
    }
}

} // namespace candela::sl
