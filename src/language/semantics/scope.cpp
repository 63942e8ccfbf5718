// SPDX-License-Identifier: Apache-2.0
#include "language/semantics/scope.h"

#include <algorithm>
#include <utility>

namespace candela::sl {

Scope &Scope::addInner() { return *inner_.emplace_back(std::make_unique<Scope>(this)); }

bool Scope::declare(const std::string &name, Symbol *symbol, Symbol **existing) {
    auto [entry, isNew] = symbols_.emplace(name, symbol);
    *existing = entry->second;
    return isNew;
}

void Scope::declareFunction(FunctionDefinition *definition) {
    functions_[definition->syntax->name].push_back(definition);
}

void Scope::dropFunction(const FunctionDefinition *definition) {
    std::erase(functions_[definition->syntax->name], definition);
}

Symbol *Scope::find(const std::string &name) const {
    for (const Scope *scope = this; scope; scope = scope->outer_) {
        auto found = scope->symbols_.find(name);
        if (found != scope->symbols_.end())
            return found->second;
    }
    return nullptr;
}

Symbol *Scope::findExternal(const std::string &name) const {
    for (const Scope *scope = this; scope; scope = scope->outer_) {
        Symbol *found = scope->outer_ ? scope->outer_->find(name) : nullptr;
        if (!found && scope->externs_)
            found = scope->externs_->find(name);
        if (found)
            return found;
    }
    return nullptr;
}

std::vector<FunctionDefinition *> Scope::findFunctions(const std::string &name) const {
    std::vector<FunctionDefinition *> result;
    for (const Scope *scope = this; scope; scope = scope->outer_) {
        auto found = scope->functions_.find(name);
        if (found != scope->functions_.end())
            result.insert(result.end(), found->second.begin(), found->second.end());
    }
    return result;
}

void Scope::collectNames(std::vector<std::string> &variables) const {
    for (const Scope *scope = this; scope; scope = scope->outer_)
        for (const auto &[name, symbol] : scope->symbols_)
            variables.push_back(name);
}

void Scope::collectFunctionNames(std::vector<std::string> &functions) const {
    for (const Scope *scope = this; scope; scope = scope->outer_)
        for (const auto &[name, definitions] : scope->functions_)
            functions.push_back(name);
}

} // namespace candela::sl
