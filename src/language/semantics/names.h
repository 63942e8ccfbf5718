// SPDX-License-Identifier: Apache-2.0
// What names stand for at one place of a shader: the symbols of the shader, and the view of them
// from a scope.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "language/semantics/scope.h"
#include "language/semantics/typed_ast.h"
#include "language/syntax/ast.h"
#include "language/syntax/reporter.h"

namespace candela::sl {

/// Makes the symbols of one shader, which owns them.
class Symbols {
public:
    explicit Symbols(TypedShader &shader) : shader_(shader) {}

    ShaderKind shaderKind() const { return shader_.kind; }
    Symbol &add(Symbol::Kind, const std::string &name, const Type &, const Place &);
    /// A local that is declared without a value.
    void noteUnset(const Symbol &symbol) { unset_.push_back(&symbol); }
    const std::vector<const Symbol *> &unset() const { return unset_; }
    /// Of a predefined variable that this kind of shader knows; null if there is none.
    Symbol *predefined(const std::string &name);

private:
    TypedShader &shader_;
    std::vector<const Symbol *> unset_;
    std::map<PredefinedId, Symbol *> predefined_;
};

class Names {
public:
    /// `owner`: the instance of a function to which what is declared belongs, or null.
    Names(Symbols &symbols, Reporter &reporter, Scope &scope, const Function *owner)
        : symbols_(symbols), reporter_(reporter), scope_(&scope), owner_(owner) {}

    ShaderKind shaderKind() const { return symbols_.shaderKind(); }
    Scope &scope() const { return *scope_; }

    /// The variable of that name, or null.
    Symbol *find(const std::string &name) const;
    /// All functions of that name, inner ones first.
    std::vector<FunctionDefinition *> functions(const std::string &name) const;

    /// A new variable of this scope. A second one of its name is reported.
    Symbol &declare(Symbol::Kind, const ast::Variable &, const Type &);
    /// Makes an outer variable known here, as `extern` says; the symbol stays the outer one.
    void declareExternal(const ast::Variable &);

    /// What an error about an unknown name adds: "; did you mean 'Kd'?", or "".
    std::string variableSuggestion(const std::string &name) const;
    std::string functionSuggestion(const std::string &name) const;

    /// What is declared while it lives is known no longer.
    class InnerScope {
    public:
        explicit InnerScope(Names &names) : names_(names), outer_(names.scope_) {
            names.scope_ = &outer_->addInner();
        }
        ~InnerScope() { names_.scope_ = outer_; }
        InnerScope(const InnerScope &) = delete;
        InnerScope &operator=(const InnerScope &) = delete;

    private:
        Names &names_;
        Scope *outer_;
    };

private:
    Symbols &symbols_;
    Reporter &reporter_;
    Scope *scope_;
    const Function *owner_;
};

} // namespace candela::sl
