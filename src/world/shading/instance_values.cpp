// SPDX-License-Identifier: Apache-2.0
#include "world/shading/instance_values.h"

#include "world/shading/attribute_value.h"

#include <algorithm>
#include <optional>

namespace candela {

namespace {

const char *typeName(ValueType type) {
    switch (type) {
    case ValueType::Float: return "float";
    case ValueType::Integer: return "integer";
    case ValueType::String: return "string";
    case ValueType::Color: return "color";
    case ValueType::Point: return "point";
    case ValueType::Vector: return "vector";
    case ValueType::Normal: return "normal";
    case ValueType::HPoint: return "hpoint";
    case ValueType::Matrix: return "matrix";
    }
    return "float";
}

bool isTriple(const std::string &type) {
    return type == "point" || type == "vector" || type == "normal";
}

/// May a value of the declared type stand for a parameter of this type? Points, vectors and
/// normals exchange freely, as RI 3.1 files have only points.
bool fits(ValueType given, const std::string &wanted) {
    bool givenTriple =
        given == ValueType::Point || given == ValueType::Vector || given == ValueType::Normal;
    return typeName(given) == wanted || (given == ValueType::Integer && wanted == "float") ||
           (givenTriple && isTriple(wanted));
}

std::size_t componentsOf(const ir::ShaderParameter &parameter) {
    return parameter.type == "string" ? 1 : parameter.defaults.size() / parameter.arraySize;
}

std::size_t elementsOf(const Parameter &given, const ir::ShaderParameter &parameter) {
    return parameter.type == "string" ? given.strings.size()
                                      : given.floats.size() / componentsOf(parameter);
}

std::string shape(const std::string &type, std::size_t elements) {
    return type + (elements == 1 ? "" : "[" + std::to_string(elements) + "]");
}

/// True if the value that the record gives can stand for the parameter; else it is reported.
bool isUsable(const Parameter &given, const ir::ShaderParameter &parameter,
              const ir::LoweredShader &shader, const ShaderRecord &record,
              DiagnosticSink &diagnostics) {
    const bool sameType = fits(given.declaration.type, parameter.type);
    const std::size_t elements = sameType ? elementsOf(given, parameter) : 1;
    if (sameType && elements == std::size_t(parameter.arraySize))
        return true;
    diagnostics.error(record.parameters.where,
                      "parameter \"" + parameter.name + "\" of shader \"" + shader.name +
                          "\" is a " + shape(parameter.type, sameType ? parameter.arraySize : 1) +
                          ", but a " + shape(typeName(given.declaration.type), elements) +
                          " is given: its default is used");
    return false;
}

/// Points, vectors and normals from a space to current space.
void transformTriples(const std::string &type, const Matrix4 &currentFromSpace,
                      std::vector<float> &values) {
    Matrix4 inverted = inverse(currentFromSpace).value_or(Matrix4{});
    for (std::size_t at = 0; at + 2 < values.size(); at += 3) {
        Vec3 v{values[at], values[at + 1], values[at + 2]};
        v = type == "point"    ? transformPoint(currentFromSpace, v)
            : type == "vector" ? transformVector(currentFromSpace, v)
                               : transformNormal(inverted, v);
        values[at] = v.x, values[at + 1] = v.y, values[at + 2] = v.z;
    }
}

/// Matrices that start at a space to such as start at current space.
void startAtCurrent(const Matrix4 &currentFromSpace, std::vector<float> &values) {
    const Matrix4 spaceFromCurrent = inverse(currentFromSpace).value_or(Matrix4{});
    for (auto at = values.begin(); at != values.end(); at += 16) {
        Matrix4 fromSpace;
        std::copy_n(at, 16, fromSpace.m.begin());
        std::ranges::copy((spaceFromCurrent * fromSpace).m, at);
    }
}

/// The space of a default, which must be one that the file defines before the shader is bound.
Matrix4 spaceOf(const ir::ShaderParameter &parameter, const ir::LoweredShader &shader,
                const ShaderRecord &record, const Options &options, DiagnosticSink &diagnostics) {
    const std::string &name = parameter.defaultSpace;
    if (name == "current" || name == "camera")
        return {};
    if (name == "shader" || name == "object")
        return record.currentFromShader.atOpen();
    auto found = options.coordinateSystems.find(name);
    if (found != options.coordinateSystems.end())
        return found->second;
    diagnostics.warning(record.parameters.where,
                        "the default of parameter \"" + parameter.name + "\" of shader \"" +
                            shader.name + "\" is in the coordinate system \"" + name +
                            "\", which is not known here: taking \"shader\"");
    return record.currentFromShader.atOpen();
}

std::vector<float> defaultValues(const ir::LoweredShader &shader,
                                 const ir::ShaderParameter &parameter, const ShaderRecord &record,
                                 const Options &options, DiagnosticSink &diagnostics) {
    std::vector<float> values = parameter.defaults;
    const bool isMatrix = parameter.type == "matrix";
    if (!isMatrix && !isTriple(parameter.type))
        return values;
    const Matrix4 currentFromSpace = spaceOf(parameter, shader, record, options, diagnostics);
    if (isMatrix)
        startAtCurrent(currentFromSpace, values);
    else
        transformTriples(parameter.type, currentFromSpace, values);
    return values;
}

std::optional<std::vector<float>> givenValues(const ir::LoweredShader &shader,
                                              const ir::ShaderParameter &parameter,
                                              const ShaderRecord &record,
                                              DiagnosticSink &diagnostics) {
    const Parameter *given = record.parameters.find(parameter.name);
    if (!given || !isUsable(*given, parameter, shader, record, diagnostics) ||
        parameter.type == "string") // LoweredText has those.
        return std::nullopt;
    std::vector<float> values = given->floats;
    if (isTriple(parameter.type))
        transformTriples(parameter.type, record.currentFromShader.atOpen(), values);
    return values;
}

void reportUnknown(const ir::LoweredShader &shader, const ShaderRecord &record,
                   DiagnosticSink &diagnostics) {
    for (const Parameter &given : record.parameters.all) {
        bool known = std::ranges::any_of(shader.parameters,
                                         [&](const auto &p) { return p.name == given.name; });
        // Lights may carry parameters for the renderer (RI 3.2: __category and its kin).
        if (!known && !given.name.starts_with("__"))
            diagnostics.warning(record.parameters.where, "shader \"" + shader.name +
                                                             "\" has no parameter \"" + given.name +
                                                             "\": it is ignored");
    }
}

} // namespace

std::vector<ToldParameter> toldParameters(const ir::LoweredShader &shader,
                                          const ShaderRecord &record, const Options &options) {
    DiagnosticList heard; // What is wrong with the values is said where the instance is made.
    std::vector<ToldParameter> told;
    for (const ir::ShaderParameter &parameter : shader.parameters) {
        const std::size_t elements = std::size_t(parameter.arraySize);
        ToldParameter value{parameter.name, shape(parameter.type, elements), {}, {}};
        if (parameter.type == "string") {
            const Parameter *given = record.parameters.find(parameter.name);
            const bool fits = given && given->declaration.type == ValueType::String &&
                              given->strings.size() == elements;
            value.strings = fits ? given->strings : parameter.stringDefaults;
        } else {
            auto given = givenValues(shader, parameter, record, heard);
            value.values = given ? std::move(*given)
                                 : defaultValues(shader, parameter, record, options, heard);
        }
        told.push_back(std::move(value));
    }
    for (const Parameter &given : record.parameters.all)
        if (given.name.starts_with("__") &&
            std::ranges::find(told, given.name, &ToldParameter::name) == told.end()) {
            const ValueType type = given.declaration.type;
            told.push_back({given.name,
                            shape(typeName(type == ValueType::Integer ? ValueType::Float : type),
                                  std::size_t(given.declaration.arraySize)),
                            given.floats, given.strings});
        }
    return told;
}

namespace {

/// What a hidden parameter of ir::attributeParameter() holds: 1 and the value, or nothing (zeros).
std::vector<float> hiddenAttribute(const std::string &parameter, const Attributes &attributes) {
    constexpr std::string_view prefix = "attribute ";
    if (!parameter.starts_with(prefix))
        return {};
    const std::size_t space = parameter.find(' ', prefix.size());
    const std::string type = parameter.substr(prefix.size(), space - prefix.size());
    std::vector<float> value = attributeValue(attributes, parameter.substr(space + 1), type);
    if (!value.empty())
        value.insert(value.begin(), 1);
    return value;
}

/// 1 and the numbers.
std::map<std::string, std::vector<float>> hiddenValues(const ToldValues &told) {
    std::map<std::string, std::vector<float>> values;
    for (const auto &[name, parameter] : told) {
        std::vector<float> &value = values[name];
        value = {1};
        value.insert(value.end(), parameter.values.begin(), parameter.values.end());
    }
    return values;
}

} // namespace

bool asksForAttributes(const ir::LoweredShader &shader) {
    return std::ranges::any_of(shader.whole.parameters, [](const ir::ParameterSlot &slot) {
        return slot.name.starts_with("attribute ");
    });
}

std::vector<float> parameterBlock(const ir::LoweredShader &shader, const ShaderRecord &record,
                                  const Options &options, const ToldValues &told,
                                  DiagnosticSink &diagnostics, const Attributes *attributes) {
    reportUnknown(shader, record, diagnostics);
    std::vector<float> block(shader.whole.parameters.size());
    std::map<std::string, std::vector<float>> values = hiddenValues(told);
    for (const ir::ShaderParameter &parameter : shader.parameters) {
        auto given = givenValues(shader, parameter, record, diagnostics);
        values[ir::givenName(parameter.name)] = {given ? 1.0f : 0.0f};
        values[parameter.name] =
            given ? std::move(*given)
                  : defaultValues(shader, parameter, record, options, diagnostics);
    }
    Matrix4 currentFromShader = record.currentFromShader.atOpen();
    std::vector<float> &hidden = values["shader"];
    if (hidden.empty()) {
        hidden.assign(currentFromShader.m.begin(), currentFromShader.m.end());
        Matrix4 shaderFromCurrent = inverse(currentFromShader).value_or(Matrix4{});
        hidden.insert(hidden.end(), shaderFromCurrent.m.begin(), shaderFromCurrent.m.end());
    }
    for (std::size_t slot = 0; slot < block.size(); ++slot) {
        const ir::ParameterSlot &parameter = shader.whole.parameters[slot];
        if (attributes && !values.contains(parameter.name))
            values[parameter.name] = hiddenAttribute(parameter.name, *attributes);
        const std::vector<float> &value = values[parameter.name];
        if (parameter.component < int(value.size()))
            block[slot] = value[parameter.component];
    }
    return block;
}

} // namespace candela
