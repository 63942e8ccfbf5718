// SPDX-License-Identifier: Apache-2.0
#include "language/semantics/scope.h"

#include <algorithm>
#include <cctype>
#include <numeric>
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

/// Number of letters to insert, delete, change or swap to make one word the other.
static size_t editDistance(const std::string &a, const std::string &b) {
    std::vector<size_t> before(b.size() + 1), previous(b.size() + 1), row(b.size() + 1);
    std::iota(previous.begin(), previous.end(), 0);
    for (size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        for (size_t j = 1; j <= b.size(); ++j) {
            bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
            row[j] = std::min(
                {previous[j] + 1, row[j - 1] + 1, previous[j - 1] + (a[i - 1] != b[j - 1])});
            if (swapped)
                row[j] = std::min(row[j], before[j - 2] + 1);
        }
        before = std::exchange(previous, row);
    }
    return previous[b.size()];
}

static std::string lower(std::string word) {
    std::ranges::transform(word, word.begin(),
                           [](unsigned char c) { return char(std::tolower(c)); });
    return word;
}

std::string suggestion(const std::string &word, const std::vector<std::string> &candidates) {
    if (word.size() > 64)
        return {};
    std::string best;
    size_t bestDistance = word.size() <= 3 ? 2 : 3; // One or two slips are likely, more are not.
    for (const std::string &candidate : candidates) {
        if (candidate == word || candidate.size() > 64)
            continue;
        bool sameLetters = lower(word) == lower(candidate);
        size_t distance = sameLetters ? 0 : editDistance(word, candidate);
        if (distance < bestDistance && distance < word.size()) {
            best = candidate;
            bestDistance = distance;
        }
    }
    return best.empty() ? "" : "; did you mean '" + best + "'?";
}

} // namespace candela::sl
