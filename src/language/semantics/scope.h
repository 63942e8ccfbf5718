// SPDX-License-Identifier: Apache-2.0
// Names and what they stand for. Variables and functions live in separate spaces, so that a
// parameter may be called exp and exp() still be called.
#pragma once

#include "foundation/base/suggestion.h"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "language/semantics/typed_ast.h"
#include "language/syntax/ast.h"

namespace candela::sl {

class Scope;

/// A function as defined, in one surrounding. Its instances are checked when it is called.
struct FunctionDefinition {
    const ast::Function *syntax = nullptr;
    Scope *scope = nullptr;         ///< Where it is defined.
    std::optional<BaseType> result; ///< Stated, or found by looking at its return statements.
    bool inProgress = false;        ///< Being checked: a call now is a recursion.
    bool checked = false;           ///< At least one instance was.
    /// Instances by the detail and array length of each argument.
    std::map<std::string, const Function *> instances;
};

class Scope {
public:
    /// `externs`: where extern declarations look besides the outer scopes; may be null.
    explicit Scope(Scope *outer = nullptr, Scope *externs = nullptr)
        : outer_(outer), externs_(externs) {}

    /// A new scope inside of this one, which owns it.
    Scope &addInner();

    /// False if this very scope has the name already; `existing` is that symbol then.
    bool declare(const std::string &name, Symbol *, Symbol **existing);
    void declareFunction(FunctionDefinition *);
    /// Forgets a function of this very scope.
    void dropFunction(const FunctionDefinition *);

    /// From here outward; null if unknown.
    Symbol *find(const std::string &name) const;
    /// As extern looks: outside of this scope, and where `externs` says.
    Symbol *findExternal(const std::string &name) const;
    /// All functions of that name from here outward, inner ones first.
    std::vector<FunctionDefinition *> findFunctions(const std::string &name) const;

    void collectNames(std::vector<std::string> &variables) const;
    void collectFunctionNames(std::vector<std::string> &functions) const;

private:
    Scope *outer_;
    Scope *externs_;
    std::map<std::string, Symbol *> symbols_;
    std::map<std::string, std::vector<FunctionDefinition *>> functions_;
    std::vector<std::unique_ptr<Scope>> inner_;
};

} // namespace candela::sl
