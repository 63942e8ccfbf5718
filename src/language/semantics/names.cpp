// SPDX-License-Identifier: Apache-2.0
#include "language/semantics/names.h"

namespace candela::sl {

Symbol &Symbols::add(Symbol::Kind kind, const std::string &name, const Type &type,
                     const Place &where) {
    Symbol &symbol = *shader_.symbols.emplace_back(std::make_unique<Symbol>());
    symbol.kind = kind;
    symbol.name = name;
    symbol.type = type;
    symbol.where = where;
    return symbol;
}

Symbol *Symbols::predefined(const std::string &name) {
    const PredefinedVariable *variable = findPredefined(name, shader_.kind);
    if (!variable)
        return nullptr;
    Symbol *&symbol = predefined_[variable->id];
    if (!symbol) {
        symbol = &add(Symbol::Kind::Predefined, variable->name, variable->type, {});
        symbol->predefined = variable;
    }
    return symbol;
}

Symbol *Names::find(const std::string &name) const {
    Symbol *symbol = scope_->find(name);
    return symbol ? symbol : symbols_.predefined(name);
}

std::vector<FunctionDefinition *> Names::functions(const std::string &name) const {
    return scope_->findFunctions(name);
}

Symbol &Names::declare(Symbol::Kind kind, const ast::Variable &v, const Type &type) {
    Symbol &symbol = symbols_.add(kind, v.name, type, v.where);
    symbol.output = v.output;
    symbol.detailStated = v.detail.has_value();
    symbol.owner = owner_;
    if (kind == Symbol::Kind::Local && !v.initialised)
        symbols_.noteUnset(symbol);
    Symbol *existing = nullptr;
    if (!scope_->declare(v.name, &symbol, &existing))
        reporter_.error(v.where, v.name + " is declared in line " +
                                     std::to_string(existing->where.line) + " already");
    return symbol;
}

void Names::declareExternal(const ast::Variable &v) {
    Symbol *found = scope_->findExternal(v.name);
    if (!found)
        found = symbols_.predefined(v.name);
    if (!found) {
        reporter_.error(v.where, "extern variable " + v.name + " is not known outside of here" +
                                     variableSuggestion(v.name));
        return;
    }
    bool same =
        found->type.base == v.type || (isGeometric(found->type.base) && isGeometric(v.type));
    if (!same || found->type.isArray() != v.isArray)
        reporter_.error(v.where, "extern variable " + v.name + " is a " + shapeOf(found->type) +
                                     " where it is defined");
    Symbol *existing = nullptr;
    if (!scope_->declare(v.name, found, &existing) && existing != found)
        reporter_.error(v.where, v.name + " is declared here already");
}

std::string Names::variableSuggestion(const std::string &name) const {
    for (int kind = 0; kind < shaderKindCount; ++kind)
        if (findPredefined(name, ShaderKind(kind)))
            return std::string(" in a ") + nameOf(shaderKind()) + " shader; " +
                   nameOf(ShaderKind(kind)) + " shaders have it";
    std::vector<std::string> names;
    scope_->collectNames(names);
    for (const PredefinedVariable &variable : predefinedVariables())
        if (variable.readableIn(shaderKind()))
            names.emplace_back(variable.name);
    return suggestion(name, names);
}

std::string Names::functionSuggestion(const std::string &name) const {
    std::vector<std::string> names;
    scope_->collectFunctionNames(names);
    for (const Builtin &function : builtins())
        names.emplace_back(function.name);
    return suggestion(name, names);
}

} // namespace candela::sl
