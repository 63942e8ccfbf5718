// SPDX-License-Identifier: Apache-2.0
// Shaders and lights, also those of pictures.
#include "interface/ri/state_handlers.h"

#include <algorithm>

namespace candela {

ShaderRecord StateHandlers::shader(const SourceLocation &where, const char *request,
                                   ShaderKind kind, const std::string &name,
                                   const TokenList &tokens) {
    if (state_.transform.current.flat)
        diagnostics_.warning(where, request,
                             "the transformation is singular (it flattens space), and so is "
                             "shader space");
    return {name, parameters_.ofShader(where, tokens, request, kind, name, state_.options),
            state_.currentFromObject()};
}

void StateHandlers::surface(const SourceLocation &where, const std::string &name,
                            const TokenList &tokens) {
    state_.edit(own::Surface).surface = std::make_shared<const ShaderRecord>(
        shader(where, "Surface", ShaderKind::Surface, name, tokens));
}

/// RI 3.2, 5.6: the null shader is none at all.
std::shared_ptr<const ShaderRecord> StateHandlers::volume(const SourceLocation &where,
                                                          const char *request,
                                                          const std::string &name,
                                                          const TokenList &tokens) {
    if (name.empty() || name == "null")
        return nullptr;
    return std::make_shared<const ShaderRecord>(
        shader(where, request, ShaderKind::Volume, name, tokens));
}

void StateHandlers::atmosphere(const SourceLocation &where, const std::string &name,
                               const TokenList &tokens) {
    state_.edit(own::Atmosphere).atmosphere = volume(where, "Atmosphere", name, tokens);
}

void StateHandlers::interior(const SourceLocation &where, const std::string &name,
                             const TokenList &tokens) {
    state_.edit(own::Interior).interior = volume(where, "Interior", name, tokens);
}

void StateHandlers::exterior(const SourceLocation &where, const std::string &name,
                             const TokenList &tokens) {
    state_.edit(own::Exterior).exterior = volume(where, "Exterior", name, tokens);
}

void StateHandlers::displacement(const SourceLocation &where, const std::string &name,
                                 const TokenList &tokens) {
    // RI 3.2, 4.2.1: the null shader is none at all.
    if (name.empty() || name == "null")
        state_.edit(own::Displacement).displacement.reset();
    else
        state_.edit(own::Displacement).displacement = std::make_shared<const ShaderRecord>(
            shader(where, "Displacement", ShaderKind::Displacement, name, tokens));
}

void StateHandlers::deformation(const SourceLocation &where, const std::string &name,
                                const TokenList &tokens) {
    if (name.empty() || name == "null")
        state_.edit(own::Deformation).deformation.reset();
    else
        state_.edit(own::Deformation).deformation = std::make_shared<const ShaderRecord>(
            shader(where, "Deformation", ShaderKind::Transformation, name, tokens));
}

/// Of a picture, which lies in no space.
ShaderRecord StateHandlers::pictureShader(const SourceLocation &where, const char *request,
                                          ShaderKind kind, const std::string &name,
                                          const TokenList &tokens) {
    return {name, parameters_.ofShader(where, tokens, request, kind, name, state_.options), {}};
}

void StateHandlers::pushFilter(const SourceLocation &where, const std::string &name,
                               const TokenList &tokens) {
    state_.options.filters.push_back(
        pictureShader(where, "PushFilter", ShaderKind::Filter, name, tokens));
}

void StateHandlers::popFilter(const SourceLocation &where) {
    if (state_.options.filters.empty())
        return diagnostics_.error(where, "PopFilter", "there is no filter on the stack");
    state_.options.filters.pop_back();
}

void StateHandlers::imager(const SourceLocation &where, const std::string &name,
                           const TokenList &tokens) {
    // RI 3.2, 4.1.2: the null shader is none at all.
    if (name.empty() || name == "null")
        state_.options.imager.reset();
    else
        state_.options.imager = pictureShader(where, "Imager", ShaderKind::Imager, name, tokens);
}

static LightUnits lightUnits(const FrameState &state, RequestDiagnostics &diagnostics,
                             const SourceLocation &where) {
    std::string standard = state.options.named.string("radiometry:units", "classic");
    std::string units = state.attributes->named.string("light:units", standard);
    if (units != "classic" && units != "si")
        diagnostics.warnOnce(where, "units:" + units,
                             "'" + units +
                                 "' is no system of units for lights: expected \"classic\" or "
                                 "\"si\"; using \"classic\"");
    return units == "si" ? LightUnits::Si : LightUnits::Classic;
}

static bool lightShadows(const FrameState &state, RequestDiagnostics &diagnostics,
                         const SourceLocation &where) {
    std::string shadows = state.attributes->named.string("light:shadows", "off");
    if (shadows != "on" && shadows != "off")
        diagnostics.warnOnce(
            where, "shadows:" + shadows,
            "Attribute \"light\" \"shadows\": expected \"on\" or \"off\", found '" + shadows +
                "'; using \"off\"");
    return shadows == "on";
}

void StateHandlers::addLight(const SourceLocation &where, const char *request,
                             const std::string &name, const Handle &handle, const TokenList &tokens,
                             bool area) {
    auto light = std::make_shared<LightRecord>();
    light->index = int(state_.lights.all.size());
    light->handle = handle.text;
    light->area = area;
    light->shader = shader(where, request, ShaderKind::Light, name, tokens);
    light->units = lightUnits(state_, diagnostics_, where);
    light->shadows = lightShadows(state_, diagnostics_, where);
    state_.lights.all.push_back(light);
    state_.lights.byHandle[handle.text] = light->index;
    Attributes &attributes = state_.edit();
    attributes.lightsOn.push_back(light->index); // The highest so far: the list stays sorted.
    if (area)
        attributes.areaLight = light;
    if (state_.inWorld)
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
        state_.edit().areaLight.reset();
    else
        addLight(where, "AreaLightSource", name, handle, tokens, true);
}

void StateHandlers::illuminate(const SourceLocation &where, const Handle &handle, bool on) {
    auto found = state_.lights.byHandle.find(handle.text);
    if (found == state_.lights.byHandle.end())
        return diagnostics_.error(where, "Illuminate", "there is no light '" + handle.text + "'");
    std::vector<int> &lights = state_.edit().lightsOn;
    auto place = std::ranges::lower_bound(lights, found->second);
    bool isOn = place != lights.end() && *place == found->second;
    if (on && !isOn)
        lights.insert(place, found->second);
    else if (!on && isOn)
        lights.erase(place);
}

} // namespace candela
