// SPDX-License-Identifier: Apache-2.0
// Parameter lists, shaders and lights.
#include "interface/ri/state_handlers.h"

#include <algorithm>
#include <cmath>

namespace candela {

std::optional<ParsedToken> StateHandlers::tokenOf(const TokenValue &value, const char *request) {
    auto token = parseToken(value.token);
    if (!token)
        error(value.where, request,
              "'" + value.token +
                  "' is no parameter: expected \"name\" or \"[class] type[n] "
                  "name\"; the parameter is left out");
    return token;
}

Declaration StateHandlers::guess(const TokenValue &value, const ParsedToken &token,
                                 const char *request, const std::string &qualifiedName) {
    bool strings = !value.strings.empty();
    Declaration result{StorageClass::Uniform, strings ? ValueType::String : ValueType::Float,
                       std::max(1, int(value.strings.size() + value.floats.size()))};
    warnOnce(value.where, qualifiedName,
             std::string(request) + ": parameter '" + token.name +
                 "' has not been declared; taken as a " + textOf(result));
    return result;
}

std::vector<Parameter> StateHandlers::categorised(const TokenList &tokens, const char *request,
                                                  const std::string &category) {
    std::vector<Parameter> result;
    for (const TokenValue &value : tokens.all) {
        auto token = tokenOf(value, request);
        if (!token)
            continue;
        std::string qualified = category + ":" + token->name;
        auto declaration = token->declaration;
        for (const std::string &name : {qualified, token->name})
            if (!declaration)
                declaration = dictionary_.declaredByUser(name);
        if (!declaration)
            declaration = Dictionary::standard(qualified);
        if (!declaration)
            declaration = guess(value, *token, request, qualified);
        // A search path may come as several strings, which is one path.
        bool path = category == "searchpath" && declaration->type == ValueType::String;
        auto parameter = (path ? typedParameter : singleValue)(value, *token, *declaration, request,
                                                               diagnostics_);
        if (parameter)
            result.push_back(std::move(*parameter));
    }
    return result;
}

ParameterList StateHandlers::parameters(const SourceLocation &where, const TokenList &tokens,
                                        const char *request) {
    ParameterList result{where, {}};
    for (const TokenValue &value : tokens.all) {
        auto token = tokenOf(value, request);
        if (!token)
            continue;
        auto declaration = token->declaration;
        if (!declaration)
            declaration = dictionary_.declaredByUser(token->name);
        if (!declaration)
            declaration = Dictionary::standard(token->name);
        if (!declaration)
            declaration = guess(value, *token, request, request + (":" + token->name));
        if (auto parameter = singleValue(value, *token, *declaration, request, diagnostics_))
            result.all.push_back(std::move(*parameter));
    }
    return result;
}

/// Inline declaration, Declare, the shader itself, the standard, in this order.
std::optional<Declaration>
StateHandlers::shaderParameterType(const TokenValue &value, const ParsedToken &token,
                                   const char *request, const std::string &shader,
                                   const std::optional<SharedParameters> &known) {
    if (token.declaration)
        return token.declaration;
    if (auto declared = dictionary_.declaredByUser(token.name))
        return declared;
    if (known) {
        auto found = std::ranges::find(*known, token.name, &ShaderLookup::ParameterType::name);
        if (found != known->end())
            return found->declaration;
        diagnostics_.warning(value.where, std::string(request) + ": shader '" + shader +
                                              "' has no parameter '" + token.name +
                                              "'; it is left out");
        return std::nullopt;
    }
    if (auto standard = Dictionary::standard(token.name))
        return standard;
    return guess(value, token, request, shader + ":" + token.name);
}

ShaderRecord StateHandlers::shader(const SourceLocation &where, const char *request,
                                   ShaderKind kind, const std::string &name,
                                   const TokenList &tokens) {
    if (ctm_.flat)
        diagnostics_.warning(where, std::string(request) +
                                        ": the transformation is singular (it flattens space), and "
                                        "so is shader space");
    auto known = shaders_.parametersOf(kind, name, options_, where);
    ShaderRecord result{name, {where, {}}, currentTransform()};
    for (const TokenValue &value : tokens.all) {
        auto token = tokenOf(value, request);
        if (!token)
            continue;
        auto declaration = shaderParameterType(value, *token, request, name, known);
        if (!declaration)
            continue;
        auto parameter = singleValue(value, *token, *declaration, request, diagnostics_);
        if (!parameter)
            continue;
        if (std::ranges::all_of(parameter->floats, [](float f) { return std::isfinite(f); }))
            result.parameters.all.push_back(std::move(*parameter));
        else
            error(value.where, request,
                  "parameter '" + token->name + "' is not finite; it is left out");
    }
    return result;
}

void StateHandlers::surface(const SourceLocation &where, const std::string &name,
                            const TokenList &tokens) {
    edit().surface = std::make_shared<const ShaderRecord>(
        shader(where, "Surface", ShaderKind::Surface, name, tokens));
}

LightUnits StateHandlers::lightUnits(const SourceLocation &where) {
    std::string standard = options_.string("radiometry:units", "classic");
    std::string units = attributes_->string("light:units", standard);
    if (units != "classic" && units != "si")
        warnOnce(where, "units:" + units,
                 "'" + units +
                     "' is no system of units for lights: expected \"classic\" or "
                     "\"si\"; using \"classic\"");
    return units == "si" ? LightUnits::Si : LightUnits::Classic;
}

bool StateHandlers::lightShadows(const SourceLocation &where) {
    std::string shadows = attributes_->string("light:shadows", "off");
    if (shadows != "on" && shadows != "off")
        warnOnce(where, "shadows:" + shadows,
                 "Attribute \"light\" \"shadows\": expected \"on\" or \"off\", found '" + shadows +
                     "'; using \"off\"");
    return shadows == "on";
}

void StateHandlers::addLight(const SourceLocation &where, const char *request,
                             const std::string &name, const Handle &handle, const TokenList &tokens,
                             bool area) {
    auto light = std::make_shared<LightRecord>();
    light->index = int(lights_.all.size());
    light->handle = handle.text;
    light->area = area;
    light->shader = shader(where, request, ShaderKind::Light, name, tokens);
    light->units = lightUnits(where);
    light->shadows = lightShadows(where);
    lights_.all.push_back(light);
    lights_.byHandle[handle.text] = light->index;
    Attributes &attributes = edit();
    attributes.lightsOn.push_back(light->index); // The highest so far: the list stays sorted.
    if (area)
        attributes.areaLight = light;
    if (inWorld_)
        builder_.light(light);
}

void StateHandlers::lightSource(const SourceLocation &where, const std::string &name,
                                const Handle &handle, const TokenList &tokens) {
    addLight(where, "LightSource", name, handle, tokens, false);
}

void StateHandlers::areaLightSource(const SourceLocation &where, const std::string &name,
                                    const Handle &handle, const TokenList &tokens) {
    // RI 3.2, 4.2.3: the null shader ends the list of primitives that make the light.
    if (name.empty() || name == "null")
        edit().areaLight.reset();
    else
        addLight(where, "AreaLightSource", name, handle, tokens, true);
}

void StateHandlers::illuminate(const SourceLocation &where, const Handle &handle, bool on) {
    auto found = lights_.byHandle.find(handle.text);
    if (found == lights_.byHandle.end())
        return error(where, "Illuminate", "there is no light '" + handle.text + "'");
    std::vector<int> &lights = edit().lightsOn;
    auto place = std::ranges::lower_bound(lights, found->second);
    bool isOn = place != lights.end() && *place == found->second;
    if (on && !isOn)
        lights.insert(place, found->second);
    else if (!on && isOn)
        lights.erase(place);
}

} // namespace candela
