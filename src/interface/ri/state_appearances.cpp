// SPDX-License-Identifier: Apache-2.0
// What later RenderMan describes otherwise: materials and lights by name (Bxdf, Light), surfaces by
// layers (ShaderLayer). They are taken for the shaders and shapes that come nearest to them.
#include "interface/ri/state_handlers.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace candela {

namespace {

/// The last word of a token: its name, whatever stands before it.
std::string_view lastWord(std::string_view token) {
    const std::size_t end = token.find_last_not_of(" \t");
    if (end == std::string_view::npos)
        return {};
    token = token.substr(0, end + 1);
    return token.substr(token.find_last_of(" \t") + 1);
}

/// The numbers that a parameter is given; none if it has others, or is connected to a pattern.
std::span<const float> numbersOf(const TokenList &tokens, std::string_view name,
                                 std::size_t count) {
    for (const TokenValue &value : tokens.all)
        if (lastWord(value.token) == name && value.floats.size() == count &&
            std::ranges::all_of(value.floats, [](float x) { return std::isfinite(x); }))
            return value.floats;
    return {};
}

float numberOf(const TokenList &tokens, std::string_view name, float fallback) {
    const auto found = numbersOf(tokens, name, 1);
    return found.empty() ? fallback : found[0];
}

TokenValue number(const char *token, const SourceLocation &where, float value) {
    return {token, where, {value}, {}};
}

TokenValue text(const char *token, const SourceLocation &where, const char *value) {
    return {token, where, {}, {value}};
}

/// A material, the surface that is drawn for it, and what holds its colour.
struct Material {
    std::string_view bxdf;
    const char *surface;
    std::string_view color;
};
constexpr Material materials[] = {
    {"PxrBlack", "constant", ""},
    {"PxrConstant", "constant", "emitColor"},
    {"PxrDiffuse", "matte", "diffuseColor"},
    {"PxrDisney", "plastic", "baseColor"},
    {"PxrDisneyBsdf", "plastic", "baseColor"},
    {"PxrGlass", "glass", ""},
    {"PxrHair", "plastic", "diffuseColor"},
    {"PxrLMDiffuse", "matte", "frontColor"},
    {"PxrLMGlass", "glass", ""},
    {"PxrLMMetal", "metal", "specularColor"},
    {"PxrLMPlastic", "plastic", "diffuseColor"},
    {"PxrLMSubsurface", "plastic", "diffuseColor"},
    {"PxrMarschnerHair", "plastic", "diffuseColor"},
    {"PxrSkin", "plastic", "shallowColor"},
    {"PxrSurface", "plastic", "diffuseColor"},
    {"LamaDiffuse", "matte", "diffuseColor"},
};

} // namespace

void StateHandlers::bxdf(const SourceLocation &where, const std::string &name, const Handle &,
                         const TokenList &tokens) {
    const auto known = std::ranges::find(materials, name, &Material::bxdf);
    const Material material =
        known != std::end(materials) ? *known : Material{name, "matte", "diffuseColor"};
    diagnostics_.warnOnce(where, "Bxdf " + name,
                          "Bxdf: \"" + name + "\" is drawn as the surface \"" + material.surface +
                              "\", in its colour if that is given; patterns are not followed");
    if (name == "PxrBlack")
        color(where, Color(0));
    else if (const auto c = numbersOf(tokens, material.color, 3); !c.empty())
        color(where, {c[0], c[1], c[2]});
    surface(where, material.surface, {});
}

/// A light that shines on the whole world, wherever it is described. It has the shape of a source
/// of unit size and the direction z, unless it is far away.
void StateHandlers::light(const SourceLocation &where, const std::string &name,
                          const Handle &handle, const TokenList &tokens) {
    const char *shape = name == "PxrRectLight"     ? "rectlight"
                        : name == "PxrDiskLight"   ? "disklight"
                        : name == "PxrSphereLight" ? "spherelight"
                                                   : "";
    const bool isDistant = name == "PxrDistantLight";
    const bool isDome = name == "PxrDomeLight" || name == "PxrEnvDayLight";
    if (!*shape && !isDistant && !isDome)
        return diagnostics_.warnOnce(where, "Light " + name,
                                     "Light: \"" + name + "\" is not known here: it is left out");
    const float strength =
        numberOf(tokens, "intensity", 1) * std::exp2(numberOf(tokens, "exposure", 0));
    TokenList told{{number(*shape ? "float radiance" : "float intensity", where, strength)}};
    if (const auto c = numbersOf(tokens, "lightColor", 3); !c.empty())
        told.all.push_back({"color lightcolor", where, {c[0], c[1], c[2]}, {}});
    attributeBegin(where);
    attribute(where, "light",
              {{text("string units", where, "si"), text("string shadows", where, "on")}});
    if (isDome) {
        diagnostics_.warnOnce(where, "Light " + name,
                              "Light: \"" + name +
                                  "\" is taken for ambient light; its picture is not looked at");
        lightSource(where, "ambientlight", handle, told);
    } else if (isDistant) {
        lightSource(where, "distantlight", handle, told);
    } else {
        areaLightSource(where, "arealight", handle, told);
        color(where, Color(0)); // It shines and does nothing else.
        surface(where, "matte", {});
        geometry(where, shape, {});
    }
    attributeEnd(where);
    switchOnEverywhere(where, handle);
}

/// In all blocks that are open, too.
void StateHandlers::switchOnEverywhere(const SourceLocation &where, const Handle &handle) {
    illuminate(where, handle, true);
    const int index = state_.lights.byHandle.at(handle.text);
    for (SavedBlock &block : savedBlocks_) {
        if (!block.attributes)
            continue;
        block.attributes = std::make_shared<Attributes>(*block.attributes);
        block.attributes->lightsOn.push_back(index); // The highest so far: the list stays sorted.
    }
}

/// The last layer counts: those before it hand their results on to it.
void StateHandlers::shaderLayer(const SourceLocation &where, const std::string &type,
                                const std::string &name, const std::string &,
                                const TokenList &tokens) {
    diagnostics_.warnOnce(where, "ShaderLayer " + type,
                          "ShaderLayer: of the layers of a " + type +
                              " the last one is drawn, by itself");
    if (type == "surface")
        surface(where, name, tokens);
    else if (type == "displacement")
        displacement(where, name, tokens);
    else if (type == "atmosphere")
        atmosphere(where, name, tokens);
    else
        diagnostics_.error(where, "ShaderLayer",
                           "'" + type +
                               "' is unknown: expected \"surface\", \"displacement\" or "
                               "\"atmosphere\"");
}

} // namespace candela
