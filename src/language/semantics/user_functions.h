// SPDX-License-Identifier: Apache-2.0
// The user's functions: one checked instance for each combination of uniform and varying arguments.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "language/semantics/names.h"
#include "language/semantics/scope.h"
#include "language/semantics/typed_ast.h"
#include "language/syntax/ast.h"
#include "language/syntax/reporter.h"

namespace candela::sl {

/// All of one shader. The shader owns the instances, callees first.
class UserFunctions {
public:
    UserFunctions(TypedShader &shader, Symbols &symbols, Reporter &reporter,
                  std::string headersRead)
        : shader_(shader), symbols_(symbols), reporter_(reporter),
          headersRead_(std::move(headersRead)) {}

    /// What a message about an unknown function adds: "; headers that were read: ..."; empty if
    /// none was.
    const std::string &headersRead() const { return headersRead_; }

    /// Makes the function known in the scope. A second one with the same arguments
    /// takes the place of the first, with a warning.
    void define(const ast::Function &, Scope &);
    /// As stated, or else found by checking its body with arguments that stand for any.
    BaseType resultOf(FunctionDefinition &);
    /// The instance for arguments of these types, checked if it is new; null, reported at the
    /// call, if there can be none.
    const Function *instantiate(FunctionDefinition &, const std::vector<Type> &arguments,
                                const Place &call);
    /// Checks the functions of that file which nobody has called, except those of one scope (null:
    /// none).
    void checkUncalled(const SourceFile &, const Scope *except);

private:
    void check(FunctionDefinition &, const std::vector<Type> &arguments, Function &instance);
    std::vector<Symbol *> declareFormals(const ast::Function &, const std::vector<Type> &arguments,
                                         Names &);
    std::vector<Type> generalArguments(const ast::Function &);

    TypedShader &shader_;
    Symbols &symbols_;
    Reporter &reporter_;
    std::string headersRead_;
    std::vector<std::unique_ptr<FunctionDefinition>> definitions_;
    int depth_ = 0; ///< Of instances that are being checked, one called in the other.
};

} // namespace candela::sl
