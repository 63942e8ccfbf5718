// SPDX-License-Identifier: Apache-2.0
#include "render/filter_words.h"

#include "language/semantics/scope.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <utility>

namespace candela {

namespace {

using ParameterType = ShaderLookup::ParameterType;

constexpr const char *typeWord(ValueType type) {
    switch (type) {
    case ValueType::String: return "string";
    case ValueType::Color: return "color";
    case ValueType::Point: return "point";
    case ValueType::Vector: return "vector";
    case ValueType::Normal: return "normal";
    case ValueType::Matrix: return "matrix";
    default: return "float";
    }
}

std::string textOf(const ParameterType &parameter) {
    std::string text = typeWord(parameter.declaration.type);
    text += " " + parameter.name;
    if (const int length = parameter.declaration.arraySize; length > 1)
        text += "[" + std::to_string(length) + "]";
    return text;
}

/// The parts between commas, or between blanks within brackets.
std::vector<std::string> partsOf(std::string text) {
    if (text.size() >= 2 && text.front() == '[' && text.back() == ']')
        text = text.substr(1, text.size() - 2);
    std::vector<std::string> parts;
    std::string part;
    for (char c : text + ",") {
        const bool between = c == ',' || c == ' ' || c == '\t';
        if (!between)
            part += c;
        else if (!part.empty())
            parts.push_back(std::exchange(part, {}));
    }
    return parts;
}

std::optional<std::vector<float>> numbersOf(const std::string &text) {
    std::vector<float> numbers;
    for (const std::string &part : partsOf(text)) {
        const char *first = part.data() + (part.starts_with('+') ? 1 : 0);
        const char *last = part.data() + part.size();
        float number = 0;
        const auto [end, error] = std::from_chars(first, last, number);
        if (error != std::errc() || end != last || !std::isfinite(number))
            return std::nullopt;
        numbers.push_back(number);
    }
    return numbers;
}

/// Nothing if the text is no value of that type.
std::optional<Parameter> valueOf(const ParameterType &type, const std::string &text) {
    Parameter parameter{type.name, type.declaration, {}, {}};
    const int length = type.declaration.arraySize;
    if (type.declaration.type == ValueType::String) {
        parameter.strings = length > 1 ? partsOf(text) : std::vector{text};
        return int(parameter.strings.size()) == length ? std::optional(parameter) : std::nullopt;
    }
    auto numbers = numbersOf(text);
    const int needed = type.declaration.components();
    if (!numbers)
        return std::nullopt;
    if (numbers->size() == 1 && type.declaration.type == ValueType::Color && length == 1)
        numbers->resize(needed, numbers->front());
    parameter.floats = std::move(*numbers);
    return int(parameter.floats.size()) == needed ? std::optional(parameter) : std::nullopt;
}

} // namespace

std::string takeValue(const std::string &word, const std::vector<ParameterType> &types,
                      ShaderRecord &shader) {
    const std::size_t equals = word.find('=');
    const std::string name = word.substr(0, equals), text = word.substr(equals + 1);
    const auto type = std::ranges::find(types, name, &ParameterType::name);
    if (type == types.end()) {
        std::string all;
        std::vector<std::string> names;
        for (const ParameterType &known : types) {
            all += (all.empty() ? "" : ", ") + textOf(known);
            names.push_back(known.name);
        }
        return "has no parameter '" + name + "'" + suggestion(name, names) +
               (all.empty() ? "; it has none" : "; it has " + all);
    }
    auto parameter = valueOf(*type, text);
    if (!parameter)
        return "takes " + textOf(*type) + ", which '" + text + "' is not";
    std::erase_if(shader.parameters.all, [&](const Parameter &old) { return old.name == name; });
    shader.parameters.all.push_back(std::move(*parameter));
    return {};
}

bool readFilters(const std::vector<std::string> &words, ShaderLookup &shaders,
                 const Options &options, std::vector<ShaderRecord> &filters,
                 DiagnosticSink &diagnostics) {
    bool good = true;
    std::optional<std::vector<ParameterType>> types;
    for (const std::string &word : words) {
        const bool isValue = word.find('=') != word.npos;
        if (!isValue) {
            filters.push_back({word, {}, {}, {}});
            types = shaders.parametersOf(ShaderKind::Filter, word, options, {});
            good &= types.has_value();
            continue;
        }
        if (filters.empty()) {
            diagnostics.error({}, "-f: '" + word + "' stands before any filter's name");
            good = false;
            continue;
        }
        const std::string flaw = types ? takeValue(word, *types, filters.back()) : "";
        if (!flaw.empty())
            diagnostics.error({}, "filter \"" + filters.back().name + "\" " + flaw);
        good &= flaw.empty();
    }
    return good;
}

} // namespace candela
