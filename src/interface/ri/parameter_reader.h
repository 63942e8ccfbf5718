// SPDX-License-Identifier: Apache-2.0
// Parameter lists as requests carry them: what type each token has (by itself, by Declare, by the
// shader, by the standard), and its values checked against it. What is wrong is reported, and the
// parameter left out. Private to the room.
#pragma once

#include "interface/ri/declarations.h"
#include "interface/ri/request_diagnostics.h"
#include "interface/ri/scene_builder.h"

#include <optional>
#include <string>
#include <vector>

namespace candela {

class ParameterReader {
public:
    /// Both must outlive it.
    ParameterReader(ShaderLookup &shaders, RequestDiagnostics &diagnostics)
        : shaders_(shaders), diagnostics_(diagnostics) {}

    /// Declare.
    void declare(const SourceLocation &, const std::string &name, const std::string &text);

    /// Of a request with parameters of its own: one value each.
    ParameterList ofRequest(const SourceLocation &, const TokenList &, const char *request);
    /// Of a category of options or attributes, where "category:name" may have been declared too.
    std::vector<Parameter> ofCategory(const TokenList &, const char *request,
                                      const std::string &category);
    /// Of a shader, found as the options say: one finite value each.
    ParameterList ofShader(const SourceLocation &, const TokenList &, const char *request,
                           ShaderKind, const std::string &name, const Options &);
    /// Primitive variables, whose number of values is not checked here.
    ParameterList ofPrimitive(const SourceLocation &, const TokenList &, const char *request);

private:
    using ShaderParameters = std::vector<ShaderLookup::ParameterType>;

    /// Calls body(value, token) for each; what is no token is reported.
    template <class Body> void forTokens(const TokenList &, const char *request, Body);
    /// By the token itself, Declare or the standard.
    std::optional<Declaration> declarationOf(const ParsedToken &) const;
    std::optional<Declaration> shaderParameterType(const TokenValue &, const ParsedToken &,
                                                   const char *request, const std::string &shader,
                                                   const std::optional<ShaderParameters> &known);
    /// `matters`: somebody may want to know.
    Declaration guess(const TokenValue &, const ParsedToken &, const char *request,
                      const std::string &qualifiedName, bool matters = true);

    ShaderLookup &shaders_;
    RequestDiagnostics &diagnostics_;
    Dictionary dictionary_;
};

} // namespace candela
