// SPDX-License-Identifier: Apache-2.0
#include "world/shading/attribute_value.h"

namespace candela {

namespace {

/// An attribute that has a request of its own.
struct Standard {
    ValueType type = ValueType::Float;
    std::vector<float> values;
};

Standard standardAttribute(const Attributes &attributes, std::string_view name) {
    if (name == "ShadingRate")
        return {ValueType::Float, {attributes.shadingRate}};
    if (name == "Sides")
        return {ValueType::Float, {float(attributes.sides)}};
    if (name == "Matte" || name == "matte")
        return {ValueType::Float, {attributes.matte ? 1.0f : 0.0f}};
    if (name == "Color")
        return {ValueType::Color, {attributes.color.c.begin(), attributes.color.c.end()}};
    if (name == "Opacity")
        return {ValueType::Color, {attributes.opacity.c.begin(), attributes.opacity.c.end()}};
    if (name == "TextureCoordinates")
        return {ValueType::Float,
                {attributes.textureCoordinates.begin(), attributes.textureCoordinates.end()}};
    return {};
}

} // namespace

std::vector<float> namedValue(const NamedParameters &parameters, const std::string &name,
                              const Declaration &wanted) {
    const Parameter *given = parameters.find(name);
    if (!given)
        return {};
    const ValueType is = given->declaration.type;
    const bool fits = (is == ValueType::Integer ? ValueType::Float : is) == wanted.type &&
                      given->declaration.arraySize == wanted.arraySize;
    return fits ? given->floats : std::vector<float>{};
}

std::vector<float> attributeValue(const Attributes &attributes, std::string_view name,
                                  std::string_view type) {
    if (name.starts_with("Ri:"))
        name.remove_prefix(3);
    const auto wanted = parseDeclaration(type);
    if (!wanted)
        return {};
    const Standard standard = standardAttribute(attributes, name);
    if (standard.values.empty())
        return namedValue(attributes.named, std::string(name), *wanted);
    const size_t elements = standard.values.size() / (standard.type == ValueType::Color ? 3 : 1);
    const bool fits = wanted->type == standard.type && size_t(wanted->arraySize) == elements;
    return fits ? standard.values : std::vector<float>{};
}

} // namespace candela
