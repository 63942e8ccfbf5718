// SPDX-License-Identifier: Apache-2.0
#include "language/syntax/macro_definition.h"

#include <algorithm>

#include "language/syntax/flaws.h"

namespace candela::sl {

/// The names from the '(' at `at` to the ')', behind which `at` is left; nothing if it is wrong.
static std::optional<std::vector<std::string>> readParameters(const std::vector<Token> &line,
                                                              size_t &at, Reporter &reporter) {
    std::vector<std::string> result;
    for (++at; at < line.size() && !line[at].is(")"); ++at) {
        if (line[at].is(",") && !result.empty())
            ++at;
        if (at >= line.size() || !line[at].isIdentifier())
            break;
        result.push_back(line[at].spelling);
    }
    if (at < line.size() && line[at].is(")")) {
        ++at;
        return result;
    }
    reporter.error(line[std::min(at, line.size() - 1)].where,
                   "expected names and ')' in the parameter list of macro " + line[0].spelling);
    return std::nullopt;
}

std::optional<MacroDefinition> readDefinition(const std::vector<Token> &line,
                                              const Token &directive, Reporter &reporter) {
    if (line.empty() || !line[0].isIdentifier()) {
        reporter.error(directive.where, "expected a name after #define");
        return std::nullopt;
    }
    MacroDefinition result;
    result.name = line[0].spelling;
    size_t body = 1;
    if (line.size() > 1 && line[1].is("(") && !line[1].spaceBefore) {
        auto parameters = readParameters(line, body, reporter);
        if (!parameters)
            return std::nullopt;
        result.macro.takesArguments = true;
        result.macro.parameters = std::move(*parameters);
    }
    result.macro.body = withoutFlaws({line.begin() + long(body), line.end()}, reporter);
    return result;
}

} // namespace candela::sl
