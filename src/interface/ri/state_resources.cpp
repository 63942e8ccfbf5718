// SPDX-License-Identifier: Apache-2.0
// Resources, and the values that conditions ask for.
#include "interface/ri/state_handlers.h"

#include <algorithm>

namespace candela {

void StateHandlers::resourceBegin(const SourceLocation &) { resources_.begin(); }

void StateHandlers::resourceEnd(const SourceLocation &where) {
    if (!resources_.end())
        diagnostics_.error(where, "ResourceEnd", "there is no ResourceBegin to it");
}

/// What stands between commas.
static std::vector<std::string> words(const std::string &list) {
    std::vector<std::string> result;
    for (std::size_t begin = 0; begin <= list.size();) {
        const std::size_t end = std::min(list.find(',', begin), list.size());
        result.push_back(list.substr(begin, end - begin));
        begin = end + 1;
    }
    return result;
}

void StateHandlers::resource(const SourceLocation &where, const std::string &name,
                             const std::string &type, const TokenList &tokens) {
    const ParameterList parameters = parameters_.ofRequest(where, tokens, "Resource");
    const std::string operation = parameters.string("operation", "");
    if (type != "attributes")
        return diagnostics_.warnOnce(where, "resource:" + type,
                                     "Resource: those of type '" + type +
                                         "' are left out: expected \"attributes\"");
    if (operation == "save")
        return resources_.save(
            name, {std::make_shared<const Attributes>(*state_.attributes), state_.transform});
    if (operation != "restore")
        return diagnostics_.error(where, "Resource",
                                  "expected \"operation\" \"save\" or \"restore\", found '" +
                                      operation + "'");
    const Resource *resource = resources_.find(name);
    if (!resource)
        return diagnostics_.error(where, "Resource",
                                  "no attributes have been saved as '" + name + "'");
    for (const std::string &subset : words(parameters.string("subset", "all"))) {
        // Lights of an earlier world are not there any more.
        if ((subset == "shading" || subset == "all") && resource->lights == lightLists_) {
            state_.edit().areaLight = resource->attributes->areaLight;
            state_.edit().lightsOn = resource->attributes->lightsOn;
        }
        if (subset == "transform" || subset == "all")
            state_.transform.current = resource->transform.current;
        if (subset != "transform" && !restoreSubset(state_.edit(), *resource->attributes, subset))
            diagnostics_.error(
                where, "Resource",
                "there is no subset '" + subset +
                    "': expected \"all\", \"shading\", \"geometry\", "
                    "\"geometrymodification\", \"geometrydefinition\", \"hiding\" or "
                    "\"transform\"");
    }
}

static std::optional<StateValue> firstOf(const Parameter *parameter) {
    if (parameter && !parameter->strings.empty())
        return parameter->strings.front();
    if (parameter && !parameter->floats.empty())
        return double(parameter->floats.front());
    return std::nullopt;
}

std::optional<StateValue> StateHandlers::valueOf(const std::string &name) const {
    constexpr std::string_view asAttribute = "Attribute:", asOption = "Option:";
    if (name.starts_with(asAttribute))
        return firstOf(state_.attributes->named.find(name.substr(asAttribute.size())));
    if (name.starts_with(asOption))
        return firstOf(state_.options.named.find(name.substr(asOption.size())));
    if (name == "Frame")
        return double(state_.options.frame);
    if (const auto attribute = firstOf(state_.attributes->named.find(name)))
        return attribute;
    return firstOf(state_.options.named.find(name));
}

} // namespace candela
