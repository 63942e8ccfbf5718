// SPDX-License-Identifier: Apache-2.0
// What type a token of a parameter list has, and whether its values fit (RI 3.2, section 3).
#pragma once

#include "interface/ri/parameter_list.h"
#include "interface/ri/request_types.h"

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace candela {

/// A token taken apart: `declaration` is set for an inline one ("uniform float[2] dims").
struct ParsedToken {
    std::string name;
    std::optional<Declaration> declaration;
};

/// "[class] type[[n]]", as RiDeclare takes it. Nothing if it is not of that form.
std::optional<Declaration> parseDeclaration(std::string_view text);
/// "[class] type[[n]] name" or "name". Nothing if it is neither.
std::optional<ParsedToken> parseToken(std::string_view text);
/// As the user would write it: "varying float[2]".
std::string textOf(const Declaration &);

/// The values of a parameter are of the declared type; how many there are is not checked.
/// Otherwise reports what was expected, for `request`, and returns nothing.
std::optional<Parameter> typedParameter(const TokenValue &, const ParsedToken &,
                                        const Declaration &, std::string_view request,
                                        DiagnosticSink &);
/// Also the count: one value of the declared type and size.
std::optional<Parameter> singleValue(const TokenValue &, const ParsedToken &, const Declaration &,
                                     std::string_view request, DiagnosticSink &);

/// The user's declarations over the standard's.
class Dictionary {
public:
    void declare(const std::string &name, const Declaration &declaration) {
        declared_[name] = declaration;
    }
    /// What Declare said of the name.
    std::optional<Declaration> declaredByUser(const std::string &name) const;
    /// What the standard, or this renderer, says of it; `name` may be "category:name".
    static std::optional<Declaration> standard(const std::string &name);

private:
    std::map<std::string, Declaration> declared_;
};

} // namespace candela
