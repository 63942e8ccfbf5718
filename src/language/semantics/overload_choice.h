// SPDX-License-Identifier: Apache-2.0
// Which function a call means.
#pragma once

#include <optional>
#include <string>

#include "language/semantics/builtins.h"
#include "language/semantics/surroundings.h"
#include "language/syntax/ast.h"

namespace candela::sl {

/// One of the two, or neither.
struct Callee {
    const BuiltinOverload *overload = nullptr;
    FunctionDefinition *definition = nullptr;
};

/// The cheapest reading of the call in a context that wants a certain type. The user's own
/// functions hide built-in ones, unless none of them fits. In its own body, a function that is
/// called like a built-in one means that one: there is no recursion.
Callee chooseCallee(const ast::Expr &call, std::optional<BaseType> wanted, const Surroundings &);

/// How functions of that name can be called, for messages: "float f(float x); float f(color c)".
std::string signatures(const std::string &name, const Names &);

} // namespace candela::sl
