// SPDX-License-Identifier: Apache-2.0
// What Option and Attribute know: one table (state_parameters.def), for types, checks and pages.
#pragma once

#include "interface/ri/declarations.h"
#include "interface/ri/request_diagnostics.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace candela {

/// One of a category's parameters; a name "*" stands for any.
struct StateParameter {
    enum class Rule {
        Choice, ///< One of `values`.
        Number, ///< From `least` to `most`.
        Free,   ///< Any value.
        Foreign ///< Of other renderers: taken, and left alone.
    };
    Rule rule;
    std::string_view request, category, name, type;
    std::string_view initial; ///< Unless it is given.
    std::string_view values;  ///< "a|b|c"
    double least = 0, most = 0;
    std::string_view meaning;
};

/// In the order of the table.
std::span<const StateParameter> stateParameters();

/// The type of "category:name", of either request.
std::optional<Declaration> typeOfStateParameter(const std::string &qualifiedName);

/// Looks at what `request` ("Option" or "Attribute") gives. A value that the parameter does not
/// have is an error that says which it has; what is spelt like one of ours and is none is warned
/// about once. Choices become as the table spells them. False if the state is to stay as it was.
bool checkStateParameter(RequestDiagnostics &, const SourceLocation &, const char *request,
                         const std::string &category, Parameter &);

} // namespace candela
