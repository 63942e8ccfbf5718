// SPDX-License-Identifier: Apache-2.0
#include "interface/ri/declarations.h"

#include "interface/ri/state_parameters.h"

#include <charconv>
#include <iterator>
#include <utility>

namespace candela {

namespace {

constexpr std::pair<std::string_view, StorageClass> storageClasses[] = {
    {"constant", StorageClass::Constant},       {"uniform", StorageClass::Uniform},
    {"varying", StorageClass::Varying},         {"vertex", StorageClass::Vertex},
    {"facevarying", StorageClass::FaceVarying}, {"facevertex", StorageClass::FaceVertex}};

constexpr std::pair<std::string_view, ValueType> valueTypes[] = {
    {"float", ValueType::Float},   {"integer", ValueType::Integer}, {"int", ValueType::Integer},
    {"string", ValueType::String}, {"color", ValueType::Color},     {"point", ValueType::Point},
    {"vector", ValueType::Vector}, {"normal", ValueType::Normal},   {"hpoint", ValueType::HPoint},
    {"matrix", ValueType::Matrix}, {"mpoint", ValueType::Matrix}}; // Points of blobs, as PRMan has.

template <class Table> auto valueOf(const Table &table, std::string_view word) {
    std::optional<decltype(table[0].second)> result;
    for (const auto &[name, value] : table)
        if (name == word)
            result.emplace(value);
    return result;
}

template <class Table, class Value>
std::string_view nameOf(const Table &table, const Value &value) {
    for (const auto &[name, each] : table)
        if (each == value)
            return name;
    return {};
}

/// Keeps the number of components far within an int.
constexpr int maximumArraySize = 1 << 20;

constexpr std::string_view blanks = " \t\r\n";

void skipBlanks(std::string_view &text) {
    text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
}

std::string_view takeWord(std::string_view &text) {
    skipBlanks(text);
    std::string_view word = text.substr(0, text.find_first_of(" \t\r\n["));
    text.remove_prefix(word.size());
    skipBlanks(text);
    return word;
}

/// "[n]" at the front of the text, 1 if there is none; nothing if it is malformed.
std::optional<int> takeArraySize(std::string_view &text) {
    if (text.empty() || text.front() != '[')
        return 1;
    text.remove_prefix(1);
    skipBlanks(text);
    int size = 0;
    auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), size);
    if (error != std::errc() || size < 1 || size > maximumArraySize)
        return std::nullopt;
    text.remove_prefix(end - text.data());
    skipBlanks(text);
    if (text.empty() || text.front() != ']')
        return std::nullopt;
    text.remove_prefix(1);
    skipBlanks(text);
    return size;
}

/// The declaration at the front of the text, taken off it.
std::optional<Declaration> takeDeclaration(std::string_view &text) {
    Declaration result;
    std::string_view word = takeWord(text);
    if (auto storage = valueOf(storageClasses, word)) {
        result.storage = *storage;
        word = takeWord(text);
    }
    auto type = valueOf(valueTypes, word);
    auto size = takeArraySize(text);
    if (!type || !size)
        return std::nullopt;
    result.type = *type;
    result.arraySize = *size;
    return result;
}

} // namespace

std::optional<Declaration> parseDeclaration(std::string_view text) {
    auto result = takeDeclaration(text);
    return text.empty() ? result : std::nullopt;
}

std::optional<ParsedToken> parseToken(std::string_view text) {
    std::string_view rest = text;
    std::string_view word = takeWord(rest);
    if (rest.empty() && !word.empty())
        return ParsedToken{std::string(word), std::nullopt};
    rest = text;
    auto declaration = takeDeclaration(rest);
    word = takeWord(rest);
    if (!declaration || word.empty() || !rest.empty())
        return std::nullopt;
    return ParsedToken{std::string(word), declaration};
}

std::string textOf(const Declaration &declaration) {
    std::string result(nameOf(storageClasses, declaration.storage));
    result += " " + std::string(nameOf(valueTypes, declaration.type));
    if (declaration.arraySize > 1)
        result += "[" + std::to_string(declaration.arraySize) + "]";
    return result;
}

std::optional<Parameter> typedParameter(const TokenValue &value, const ParsedToken &token,
                                        const Declaration &declaration, std::string_view request,
                                        DiagnosticSink &diagnostics) {
    bool wantsStrings = declaration.type == ValueType::String;
    if (wantsStrings ? !value.floats.empty() : !value.strings.empty()) {
        diagnostics.error(value.where,
                          std::string(request) + ": parameter '" + token.name + "' is a " +
                              textOf(declaration) + ": expected " +
                              (wantsStrings ? "strings, found numbers" : "numbers, found strings") +
                              "; the parameter is left out");
        return std::nullopt;
    }
    return Parameter{token.name, declaration, value.floats, value.strings};
}

std::optional<Parameter> singleValue(const TokenValue &value, const ParsedToken &token,
                                     const Declaration &declaration, std::string_view request,
                                     DiagnosticSink &diagnostics) {
    auto result = typedParameter(value, token, declaration, request, diagnostics);
    if (!result)
        return result;
    int given = int(value.floats.size() + value.strings.size());
    if (given == declaration.components())
        return result;
    diagnostics.error(value.where, std::string(request) + ": parameter '" + token.name + "' is a " +
                                       textOf(declaration) + ": expected " +
                                       std::to_string(declaration.components()) +
                                       (declaration.components() == 1 ? " value" : " values") +
                                       ", found " + std::to_string(given) +
                                       "; the parameter is left out");
    return std::nullopt;
}

std::optional<Declaration> Dictionary::declaredByUser(const std::string &name) const {
    auto found = declared_.find(name);
    if (found == declared_.end())
        return std::nullopt;
    return found->second;
}

std::optional<Declaration> Dictionary::standard(const std::string &name) {
    // RI 3.2, appendix A.2 ("predeclared").
    static const auto table = [] {
        constexpr std::pair<std::string_view, std::string_view> lines[] = {
            {"P", "vertex point"},
            {"Pz", "vertex float"},
            {"Pw", "vertex hpoint"},
            {"N", "varying normal"},
            {"Np", "uniform normal"},
            {"Cs", "varying color"},
            {"Os", "varying color"},
            {"s", "varying float"},
            {"t", "varying float"},
            {"st", "varying float[2]"},
            {"width", "varying float"},
            {"constantwidth", "constant float"},
            {"Ka", "float"},
            {"Kd", "float"},
            {"Ks", "float"},
            {"Kr", "float"},
            {"roughness", "float"},
            {"texturename", "string"},
            {"specularcolor", "color"},
            {"intensity", "float"},
            {"lightcolor", "color"},
            {"from", "point"},
            {"to", "point"},
            {"coneangle", "float"},
            {"conedeltaangle", "float"},
            {"beamdistribution", "float"},
            {"mindistance", "float"},
            {"maxdistance", "float"},
            {"distance", "float"},
            {"background", "color"},
            {"amplitude", "float"},
            {"quantize", "float[4]"},
            {"dither", "float"},
            {"halfbuffers", "integer"},
            {"fov", "float"},
        };
        std::map<std::string_view, Declaration> result;
        for (auto [token, declaration] : lines)
            result[token] = *parseDeclaration(declaration);
        return result;
    }();
    auto found = table.find(name);
    if (found == table.end())
        return typeOfStateParameter(name);
    return found->second;
}

} // namespace candela
