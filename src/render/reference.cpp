// SPDX-License-Identifier: Apache-2.0
#include "render/reference.h"

#include "interface/ri/request_meanings.h"
#include "interface/ri/state_parameters.h"
#include "language/semantics/builtins.h"
#include "render/shader_library_reference.h"

#include <fmt/format.h>

namespace candela {

namespace {

using Rule = StateParameter::Rule;

std::string placesOf(unsigned scopes) {
    std::string places;
    const auto add = [&](unsigned bit, const char *place) {
        if (scopes & bit)
            places += (places.empty() ? "" : ", ") + std::string(place);
    };
    add(scope::Outside, "before the world");
    add(scope::InWorld, "in the world");
    add(scope::InObject, "in objects");
    add(scope::InMotion, "in motion blocks");
    return places;
}

std::string entryOf(RequestId id) {
    const RequestDescription &request = describe(id);
    std::string text = "request " + std::string(request.name);
    for (const std::string_view argument : request.argumentNames)
        text += argument == "parameters" ? " ..." : " " + std::string(argument);
    const std::string_view meaning = meaningOf(id);
    text += fmt::format("\n    {}", meaning.empty() ? "Of other renderers: it is left out, with a "
                                                      "warning."
                                                    : meaning);
    return text + "\n    Stands " + placesOf(request.legalScopes) + ".";
}

std::string entryOf(const StateParameter &row) {
    std::string text = fmt::format("{} \"{}\" \"{} {}\"", row.request, row.category, row.type,
                                   row.name == "*" ? "NAME" : row.name);
    if (row.rule == Rule::Foreign)
        return text + "\n    Of other renderers: it is taken, and changes nothing.";
    text += fmt::format("\n    {}", row.meaning);
    if (row.rule == Rule::Choice)
        text += fmt::format("\n    One of {}; at first {}.", row.values, row.initial);
    if (row.rule == Rule::Number)
        text += fmt::format("\n    From {:.10g} to {:.10g}; at first {}.", row.least, row.most,
                            row.initial);
    return text;
}

struct Statement {
    std::string_view word, forms, meaning;
};
constexpr Statement statements[] = {
#define STATEMENT(word, forms, meaning) {#word, forms, meaning},
#include "render/statements.def"
#undef STATEMENT
};

std::string entryOf(const Statement &statement) {
    return fmt::format("statement {}\n    {}\n    {}", statement.word, statement.forms,
                       statement.meaning);
}

std::string entryOf(const sl::Builtin &function) {
    std::string text = fmt::format("function {}", function.name);
    for (const sl::BuiltinOverload &overload : function.overloads)
        text += "\n    " + overload.signature();
    return text + "\n    " + function.doc;
}

bool isOf(const StateParameter &row, const std::string &word) {
    return row.category == word || row.name == word ||
           (word == "options" && row.request == "Option") ||
           (word == "attributes" && row.request == "Attribute");
}

} // namespace

std::vector<std::string> referenceOf(const std::string &word) {
    std::vector<std::string> entries;
    const auto requests = requestTable();
    for (std::size_t k = 0; k < requests.size(); ++k)
        if (word == "requests" || requests[k].name == word)
            entries.push_back(entryOf(RequestId(k)));
    for (const StateParameter &row : stateParameters())
        if (isOf(row, word))
            entries.push_back(entryOf(row));
    for (const Statement &statement : statements)
        if (word == "statements" || statement.word == word)
            entries.push_back(entryOf(statement));
    for (const sl::Builtin &function : sl::builtins())
        if (word == "functions" || function.name == word)
            entries.push_back(entryOf(function));
    for (const std::string &shader : libraryShaderEntries(word))
        entries.push_back(shader);
    return entries;
}

std::vector<std::string> referenceWords() {
    std::vector<std::string> words;
    for (const RequestDescription &request : requestTable())
        words.emplace_back(request.name);
    for (const StateParameter &row : stateParameters()) {
        words.emplace_back(row.category);
        if (row.name != "*")
            words.emplace_back(row.name);
    }
    for (const Statement &statement : statements)
        words.emplace_back(statement.word);
    for (const sl::Builtin &function : sl::builtins())
        words.emplace_back(function.name);
    for (const std::string &shader : libraryShaderNames())
        words.push_back(shader);
    return words;
}

} // namespace candela
