// SPDX-License-Identifier: Apache-2.0
#include "interface/ri/state_parameters.h"

#include "foundation/base/letters.h"
#include "foundation/base/suggestion.h"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <vector>

namespace candela {

namespace {

using Rule = StateParameter::Rule;

constexpr StateParameter table[] = {
#define CHOICE(request, category, name, initial, values, meaning)                                  \
    {Rule::Choice, #request, category, name, "string", initial, values, 0, 0, meaning},
#define NUMBER(request, category, name, type, initial, least, most, meaning)                       \
    {Rule::Number, #request, category, name, type, initial, "", least, most, meaning},
#define FREE(request, category, name, type, meaning)                                               \
    {Rule::Free, #request, category, name, type, "", "", 0, 0, meaning},
#define FOREIGN(request, category, name, type)                                                     \
    {Rule::Foreign, #request, category, name, type, "", "", 0, 0, ""},
#include "interface/ri/state_parameters.def"
};

/// Null if the table does not have it.
const StateParameter *find(std::string_view request, std::string_view category,
                           std::string_view name) {
    const auto found = std::ranges::find_if(table, [&](const StateParameter &row) {
        return row.request == request && row.category == category &&
               (row.name == name || row.name == "*");
    });
    return found == std::end(table) ? nullptr : found;
}

std::vector<std::string> words(std::string_view values) {
    std::vector<std::string> result;
    while (!values.empty()) {
        const std::size_t end = std::min(values.find('|'), values.size());
        result.emplace_back(values.substr(0, end));
        values.remove_prefix(std::min(end + 1, values.size()));
    }
    return result;
}

std::string named(const StateParameter &row) {
    return fmt::format("\"{}\" \"{}\"", row.category, row.name);
}

/// Empty if the value is one of the row's; it is then spelt as there.
std::string flawOfChoice(const StateParameter &row, Parameter &parameter) {
    const std::vector<std::string> known = words(row.values);
    const std::string given = parameter.strings.empty() ? "" : parameter.strings.front();
    for (const std::string &word : known)
        if (inSmallLetters(word) == inSmallLetters(given)) {
            parameter.strings.front() = word;
            return {};
        }
    return fmt::format("{} is {}: one of \"{}\", and not \"{}\"{}", named(row), row.meaning,
                       fmt::join(known, "\", \""), given, suggestion(given, known));
}

std::string flawOfNumber(const StateParameter &row, const Parameter &parameter) {
    const bool isGiven = !parameter.floats.empty();
    // Rows are written in double; floats of the same digits are within them.
    const auto least = float(row.least), most = float(row.most);
    if (isGiven && parameter.floats.front() >= least && parameter.floats.front() <= most)
        return {};
    return fmt::format("{} is {}: a number from {:.10g} to {:.10g}{}", named(row), row.meaning,
                       row.least, row.most,
                       isGiven ? fmt::format(", and not {:.6g}", parameter.floats.front()) : "");
}

/// What the name may have been meant to be; empty if nothing is near.
std::string likelySlip(std::string_view request, const std::string &category,
                       const std::string &name) {
    std::vector<std::string> names, categories;
    bool isKnown = false, allOurs = true;
    for (const StateParameter &row : table) {
        if (row.name == "*") {
            isKnown |= row.category == category;
            continue;
        }
        if (row.category == category && row.request == request) {
            isKnown = true;
            allOurs &= row.rule != Rule::Foreign;
            names.emplace_back(row.name);
        } else if (row.category == category && row.name == name) {
            return fmt::format("; it belongs to {}", row.request);
        } else if (row.rule != Rule::Foreign && row.request == request) {
            categories.emplace_back(row.category);
        }
    }
    if (!isKnown)
        return suggestion(category, categories);
    const std::string slip = suggestion(name, names);
    return !slip.empty() || !allOurs ? slip : fmt::format("; it has: {}", fmt::join(names, ", "));
}

} // namespace

std::span<const StateParameter> stateParameters() { return table; }

std::optional<Declaration> typeOfStateParameter(const std::string &qualifiedName) {
    static const auto types = [] {
        std::map<std::string, Declaration, std::less<>> result;
        for (const StateParameter &row : table)
            if (const auto type = parseDeclaration(row.type))
                result.try_emplace(fmt::format("{}:{}", row.category, row.name), *type);
        return result;
    }();
    const auto found = types.find(qualifiedName);
    return found == types.end() ? std::nullopt : std::optional(found->second);
}

bool checkStateParameter(RequestDiagnostics &diagnostics, const SourceLocation &where,
                         const char *request, const std::string &category, Parameter &parameter) {
    const StateParameter *row = find(request, category, parameter.name);
    if (!row) {
        // Files give the same ones for each primitive: what they may have meant is asked once.
        if (!diagnostics.isNew(fmt::format("{}:{}:{}", request, category, parameter.name)))
            return true;
        const std::string slip = likelySlip(request, category, parameter.name);
        if (!slip.empty())
            diagnostics.warning(
                where, request,
                fmt::format("there is no \"{}\" \"{}\"{}", category, parameter.name, slip));
        return true;
    }
    const std::string flaw = row->rule == Rule::Choice   ? flawOfChoice(*row, parameter)
                             : row->rule == Rule::Number ? flawOfNumber(*row, parameter)
                                                         : std::string();
    if (!flaw.empty())
        diagnostics.error(where, request, flaw + "; it stays as it was");
    return flaw.empty();
}

} // namespace candela
