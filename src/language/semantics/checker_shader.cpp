// SPDX-License-Identifier: Apache-2.0
// Variables, parameters, and the shader as a whole.
#include <cmath>

#include "language/semantics/checker.h"
#include "language/semantics/constant_value.h"

namespace candela::sl {

static constexpr int arrayLimit = 1 << 16;

Checker::Checker(const ast::File &file, const SourceFile &mainFile, Reporter &reporter)
    : file_(file), mainFile_(mainFile), reporter_(reporter) {}

Scope *Checker::newScope(Scope *outer, Scope *externs) {
    return scopes_.emplace_back(std::make_unique<Scope>(outer, externs)).get();
}

std::unique_ptr<TypedShader> Checker::check(const ast::Shader &syntax) {
    auto shader = std::make_unique<TypedShader>();
    shader_ = shader.get();
    shader->kind = syntax.kind;
    shader->name = syntax.name;
    shader->where = syntax.where;
    shader->doc = syntax.doc;
    // Functions of the file see parameters only by extern.
    parameterScope_ = newScope(nullptr);
    fileScope_ = newScope(nullptr, parameterScope_);
    Scope *shaderScope = newScope(fileScope_);
    for (const ast::Item &item : file_.items)
        if (const auto *function = std::get_if<ast::Function>(&item))
            defineFunction(*function, fileScope_);
    context_ = Context{};
    context_.scope = shaderScope;
    for (const ast::Variable &variable : syntax.parameters)
        parameter(variable);
    context_.scope = newScope(shaderScope);
    statements(syntax.body->body, shader->body);
    checkUncalled();
    if (reporter_.errorCount() == 0)
        warnAboutUnused();
    return shader;
}

void Checker::parameter(const ast::Variable &v) {
    Type type{v.type, v.detail.value_or(Detail::Uniform), 0};
    if (v.isArray)
        type.length = arrayLength(v).value_or(1);
    Symbol shape;
    shape.name = v.name;
    shape.type = type;
    Parameter result;
    context_.inDefaults = true;
    result.defaults = initialValues(v, shape);
    context_.inDefaults = false;
    if (!v.initialised)
        reporter_.warning(v.where, "parameter " + v.name + " has no default; it is " +
                                       (v.type == BaseType::String ? "\"\"" : "0"));
    result.symbol = declareSymbol(Symbol::Kind::Parameter, v, type);
    Symbol *ignored = nullptr;
    parameterScope_->declare(v.name, result.symbol, &ignored);
    for (const ExprPtr &value : result.defaults)
        if (value->type.isVarying() && !type.isVarying())
            reporter_.error(value->where,
                            "the default of uniform parameter " + v.name + " must be uniform");
    result.doc = v.doc;
    shader_->parameters.push_back(std::move(result));
}

std::optional<int> Checker::arrayLength(const ast::Variable &v) {
    if (!v.length) {
        if (v.initialised && v.braced && !v.initial.empty())
            return int(v.initial.size());
        reporter_.error(v.where, "array " + v.name + " needs a length or initial values");
        return std::nullopt;
    }
    std::optional<double> length = constantValue(*v.length);
    if (length && *length >= 1 && *length <= arrayLimit && *length == std::floor(*length))
        return int(*length);
    reporter_.error(v.length->where, "the length of array " + v.name +
                                         " must be a whole number from 1 to " +
                                         std::to_string(arrayLimit) + ", known at compile time");
    return std::nullopt;
}

std::vector<ExprPtr> Checker::initialValues(const ast::Variable &v, const Symbol &shape) {
    std::vector<ExprPtr> result;
    if (!v.initialised)
        return result;
    if (v.isArray != v.braced)
        reporter_.error(v.where,
                        v.isArray ? "the initial values of array " + v.name + " must stand in { }"
                                  : "only arrays take initial values in { }");
    else if (v.isArray && v.initial.size() > size_t(shape.type.length))
        reporter_.error(v.initial[size_t(shape.type.length)]->where,
                        "more initial values than array " + v.name + " has elements (" +
                            std::to_string(shape.type.length) + ")");
    for (const ast::ExprPtr &initial : v.initial)
        if (ExprPtr value = checkAs(*initial, v.type, "the initial value of " + v.name))
            result.push_back(std::move(value));
    return result;
}

Symbol *Checker::newSymbol(Symbol::Kind kind, const std::string &name, Type type,
                           const Place &where) {
    auto symbol = std::make_unique<Symbol>();
    symbol->kind = kind;
    symbol->name = name;
    symbol->type = type;
    symbol->where = where;
    symbol->owner = context_.function;
    return shader_->symbols.emplace_back(std::move(symbol)).get();
}

Symbol *Checker::declareSymbol(Symbol::Kind kind, const ast::Variable &v, Type type) {
    Symbol *symbol = newSymbol(kind, v.name, type, v.where);
    symbol->output = v.output;
    symbol->detailStated = v.detail.has_value();
    Symbol *existing = nullptr;
    if (!context_.scope->declare(v.name, symbol, &existing))
        reporter_.error(v.where, v.name + " is declared in line " +
                                     std::to_string(existing->where.line) + " already");
    return symbol;
}

Symbol *Checker::predefinedSymbol(const PredefinedVariable &variable) {
    Symbol *&symbol = predefined_[variable.name];
    if (!symbol) {
        symbol = newSymbol(Symbol::Kind::Predefined, variable.name, variable.type, {});
        symbol->predefined = &variable;
        symbol->owner = nullptr;
    }
    return symbol;
}

Symbol *Checker::findVariable(const std::string &name) {
    if (Symbol *symbol = context_.scope->find(name))
        return symbol;
    const PredefinedVariable *predefined = findPredefined(name, shader_->kind);
    return predefined ? predefinedSymbol(*predefined) : nullptr;
}

std::string Checker::variableSuggestion(const std::string &name) {
    for (int kind = 0; kind <= int(ShaderKind::Filter); ++kind)
        if (findPredefined(name, ShaderKind(kind)))
            return std::string(" in a ") + nameOf(shader_->kind) + " shader; " +
                   nameOf(ShaderKind(kind)) + " shaders have it";
    std::vector<std::string> names;
    context_.scope->collectNames(names);
    for (const PredefinedVariable &variable : predefinedVariables())
        if (variable.readableIn(shader_->kind))
            names.emplace_back(variable.name);
    return suggestion(name, names);
}

void Checker::warnAboutUnused() {
    for (const auto &symbol : shader_->symbols) {
        bool read = symbol->read || symbol->output;
        // Light categories and the like are read by others: __category, __nondiffuse.
        if (read || symbol->where.file != &mainFile_ || symbol->name.starts_with("__"))
            continue;
        if (symbol->kind == Symbol::Kind::Parameter)
            reporter_.warning(symbol->where, "parameter " + symbol->name + " is never used");
        if (symbol->kind == Symbol::Kind::Local && !symbol->written)
            reporter_.warning(symbol->where, "variable " + symbol->name + " is never used");
    }
}

} // namespace candela::sl
