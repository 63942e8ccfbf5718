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
    return {name,
            parameters_.ofShader(where, tokens, request, kind, name, state_.options),
            state_.currentFromObject(),
            {}};
}

void StateHandlers::setShader(const SourceLocation &where, const char *request, ShaderKind kind,
                              std::uint32_t bit, Shader Attributes::*member,
                              const std::string &name, const TokenList &tokens) {
    withMotion(shader(where, request, kind, name, tokens), [this, bit, member](ShaderRecord made) {
        state_.edit(bit).*member = std::make_shared<const ShaderRecord>(std::move(made));
    });
}

/// RI 3.2, 4.2.1 and 5.6: the null shader is none at all.
void StateHandlers::setOrNone(const SourceLocation &where, const char *request, ShaderKind kind,
                              std::uint32_t bit, Shader Attributes::*member,
                              const std::string &name, const TokenList &tokens) {
    if (name.empty() || name == "null")
        (state_.edit(bit).*member).reset();
    else
        setShader(where, request, kind, bit, member, name, tokens);
}

void StateHandlers::surface(const SourceLocation &where, const std::string &name,
                            const TokenList &tokens) {
    setShader(where, "Surface", ShaderKind::Surface, own::Surface, &Attributes::surface, name,
              tokens);
}

void StateHandlers::atmosphere(const SourceLocation &where, const std::string &name,
                               const TokenList &tokens) {
    setOrNone(where, "Atmosphere", ShaderKind::Volume, own::Atmosphere, &Attributes::atmosphere,
              name, tokens);
}

void StateHandlers::interior(const SourceLocation &where, const std::string &name,
                             const TokenList &tokens) {
    setOrNone(where, "Interior", ShaderKind::Volume, own::Interior, &Attributes::interior, name,
              tokens);
}

void StateHandlers::exterior(const SourceLocation &where, const std::string &name,
                             const TokenList &tokens) {
    setOrNone(where, "Exterior", ShaderKind::Volume, own::Exterior, &Attributes::exterior, name,
              tokens);
}

void StateHandlers::displacement(const SourceLocation &where, const std::string &name,
                                 const TokenList &tokens) {
    setOrNone(where, "Displacement", ShaderKind::Displacement, own::Displacement,
              &Attributes::displacement, name, tokens);
}

void StateHandlers::deformation(const SourceLocation &where, const std::string &name,
                                const TokenList &tokens) {
    setOrNone(where, "Deformation", ShaderKind::Transformation, own::Deformation,
              &Attributes::deformation, name, tokens);
}

/// Of a picture, which lies in no space.
ShaderRecord StateHandlers::pictureShader(const SourceLocation &where, const char *request,
                                          ShaderKind kind, const std::string &name,
                                          const TokenList &tokens) {
    return {name, parameters_.ofShader(where, tokens, request, kind, name, state_.options), {}, {}};
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
    std::optional<ShaderRecord> &imager = state_.options.imager;
    if (name.empty() || name == "null")
        imager.reset();
    else
        imager = pictureShader(where, "Imager", ShaderKind::Imager, name, tokens);
    // The options are frozen, but many files that were made for other renderers have it here.
    if (state_.inWorld)
        builder_.imager(imager ? std::make_shared<const ShaderRecord>(*imager) : nullptr);
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
    LightRecord light;
    light.handle = handle.text;
    light.area = area;
    light.units = lightUnits(state_, diagnostics_, where);
    light.shadows = lightShadows(state_, diagnostics_, where);
    withMotion(shader(where, request, ShaderKind::Light, name, tokens),
               [this, light](ShaderRecord made) mutable {
                   light.shader = std::move(made);
                   tellLight(light);
               });
}

void StateHandlers::tellLight(LightRecord record) {
    record.index = int(state_.lights.all.size());
    const auto light = std::make_shared<const LightRecord>(std::move(record));
    state_.lights.all.push_back(light);
    state_.lights.byHandle[light->handle] = light->index;
    Attributes &attributes = state_.edit();
    attributes.lightsOn.push_back(light->index); // The highest so far: the list stays sorted.
    if (light->area)
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
    if (!on)
        *state_.lights.all[std::size_t(found->second)]->isTurnedOff = true;
    std::vector<int> &lights = state_.edit().lightsOn;
    auto place = std::ranges::lower_bound(lights, found->second);
    bool isOn = place != lights.end() && *place == found->second;
    if (on && !isOn)
        lights.insert(place, found->second);
    else if (!on && isOn)
        lights.erase(place);
}

} // namespace candela
