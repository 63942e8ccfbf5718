// SPDX-License-Identifier: Apache-2.0
#include "interface/ri/parameter_reader.h"

#include <algorithm>
#include <cmath>

namespace candela {

void ParameterReader::declare(const SourceLocation &where, const std::string &name,
                              const std::string &text) {
    if (auto declaration = parseDeclaration(text))
        dictionary_.declare(name, *declaration);
    else
        diagnostics_.error(where, "Declare",
                           "'" + text +
                               "' is no declaration: expected \"[class] type[n]\", for example " +
                               "\"varying color\" or \"float[2]\"");
}

template <class Body>
void ParameterReader::forTokens(const TokenList &tokens, const char *request, Body body) {
    for (const TokenValue &value : tokens.all)
        if (const auto token = parseToken(value.token))
            body(value, *token);
        else
            diagnostics_.error(value.where, request,
                               "'" + value.token +
                                   "' is no parameter: expected \"name\" or \"[class] type[n] "
                                   "name\"; the parameter is left out");
}

std::optional<Declaration> ParameterReader::declarationOf(const ParsedToken &token) const {
    if (token.declaration)
        return token.declaration;
    if (auto declared = dictionary_.declaredByUser(token.name))
        return declared;
    return Dictionary::standard(token.name);
}

Declaration ParameterReader::guess(const TokenValue &value, const ParsedToken &token,
                                   const char *request, const std::string &qualifiedName,
                                   bool matters) {
    bool strings = !value.strings.empty();
    Declaration result{StorageClass::Uniform, strings ? ValueType::String : ValueType::Float,
                       std::max(1, int(value.strings.size() + value.floats.size()))};
    if (matters)
        diagnostics_.warnOnce(value.where, qualifiedName,
                              std::string(request) + ": parameter '" + token.name +
                                  "' has not been declared; taken as a " + textOf(result));
    return result;
}

ParameterList ParameterReader::ofRequest(const SourceLocation &where, const TokenList &tokens,
                                         const char *request) {
    ParameterList result{where, {}};
    forTokens(tokens, request, [&](const TokenValue &value, const ParsedToken &token) {
        auto declaration = declarationOf(token);
        if (!declaration)
            declaration = guess(value, token, request, request + (":" + token.name));
        if (auto parameter =
                singleValue(value, token, *declaration, request, diagnostics_.policy()))
            result.all.push_back(std::move(*parameter));
    });
    return result;
}

std::vector<Parameter> ParameterReader::ofCategory(const TokenList &tokens, const char *request,
                                                   const std::string &category) {
    std::vector<Parameter> result;
    forTokens(tokens, request, [&](const TokenValue &value, const ParsedToken &token) {
        std::string qualified = category + ":" + token.name;
        auto declaration = token.declaration;
        for (const std::string &name : {qualified, token.name})
            if (!declaration)
                declaration = dictionary_.declaredByUser(name);
        if (!declaration)
            declaration = Dictionary::standard(qualified);
        if (!declaration)
            declaration = guess(value, token, request, qualified, category != "hider");
        // A search path may come as several strings, which is one path.
        bool path = category == "searchpath" && declaration->type == ValueType::String;
        auto parameter = (path ? typedParameter : singleValue)(value, token, *declaration, request,
                                                               diagnostics_.policy());
        if (parameter)
            result.push_back(std::move(*parameter));
    });
    return result;
}

/// Inline declaration, Declare, the shader itself, the standard, in this order.
std::optional<Declaration>
ParameterReader::shaderParameterType(const TokenValue &value, const ParsedToken &token,
                                     const char *request, const std::string &shader,
                                     const std::optional<ShaderParameters> &known) {
    if (token.declaration)
        return token.declaration;
    if (auto declared = dictionary_.declaredByUser(token.name))
        return declared;
    if (known) {
        auto found = std::ranges::find(*known, token.name, &ShaderLookup::ParameterType::name);
        if (found != known->end())
            return found->declaration;
        diagnostics_.warning(value.where, request,
                             "shader '" + shader + "' has no parameter '" + token.name +
                                 "'; it is left out");
        return std::nullopt;
    }
    if (auto standard = Dictionary::standard(token.name))
        return standard;
    return guess(value, token, request, shader + ":" + token.name);
}

ParameterList ParameterReader::ofShader(const SourceLocation &where, const TokenList &tokens,
                                        const char *request, ShaderKind kind,
                                        const std::string &name, const Options &options) {
    const auto known = shaders_.parametersOf(kind, name, options, where);
    ParameterList result{where, {}};
    forTokens(tokens, request, [&](const TokenValue &value, const ParsedToken &token) {
        auto declaration = shaderParameterType(value, token, request, name, known);
        if (!declaration)
            return;
        auto parameter = singleValue(value, token, *declaration, request, diagnostics_.policy());
        if (!parameter)
            return;
        if (std::ranges::all_of(parameter->floats, [](float f) { return std::isfinite(f); }))
            result.all.push_back(std::move(*parameter));
        else
            diagnostics_.error(value.where, request,
                               "parameter '" + token.name + "' is not finite; it is left out");
    });
    return result;
}

ParameterList ParameterReader::ofPrimitive(const SourceLocation &where, const TokenList &tokens,
                                           const char *request) {
    ParameterList result{where, {}};
    forTokens(tokens, request, [&](const TokenValue &value, const ParsedToken &token) {
        auto declaration = declarationOf(token);
        if (!declaration)
            diagnostics_.warnOnce(
                value.where, "variable:" + token.name,
                std::string(request) + ": primitive variable '" + token.name +
                    "' has not been declared, so that its class is unknown; it is left out");
        else if (result.find(token.name))
            diagnostics_.error(value.where, request,
                               "'" + token.name + "' is given twice; the first counts");
        else if (auto parameter =
                     typedParameter(value, token, *declaration, request, diagnostics_.policy()))
            result.all.push_back(std::move(*parameter));
    });
    return result;
}

} // namespace candela
