// SPDX-License-Identifier: Apache-2.0
// What stands around an expression and decides what it means and whether it is legal.
#pragma once

#include <cstddef>
#include <string>

#include "language/semantics/names.h"
#include "language/semantics/typed_ast.h"
#include "language/syntax/reporter.h"

namespace candela::sl {

class UserFunctions;

struct Surroundings {
    Names names;
    UserFunctions &functions;
    Reporter &reporter;
    Function *function = nullptr;         ///< The instance being checked; null in a shader's code.
    const Stmt *lightStatement = nullptr; ///< The illuminance, illuminate or solar around.
    bool inDefaults = false;              ///< In the default of a parameter.

    /// Reports the error; null, for the caller to return.
    std::nullptr_t error(const Place &where, const std::string &message) const {
        reporter.error(where, message);
        return nullptr;
    }
};

} // namespace candela::sl
