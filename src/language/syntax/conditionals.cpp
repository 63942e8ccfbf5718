// SPDX-License-Identifier: Apache-2.0
#include "language/syntax/conditionals.h"

#include <optional>

#include "language/syntax/condition.h"
#include "language/syntax/flaws.h"

namespace candela::sl {

bool Conditionals::obey(const Token &name, const std::vector<Token> &line) {
    if (name.is("if") || name.is("ifdef") || name.is("ifndef")) {
        bool value = active() && opens(name, line);
        open_.push_back({name.where, value, value, active()});
        return true;
    }
    if (!name.is("elif") && !name.is("else") && !name.is("endif"))
        return false;
    if (open_.empty())
        reporter_.error(name.where, "#" + name.spelling + " without an #if before it");
    else if (name.is("endif"))
        open_.pop_back();
    else
        otherBranch(name, line);
    return true;
}

void Conditionals::otherBranch(const Token &name, const std::vector<Token> &line) {
    Conditional &conditional = open_.back();
    if (conditional.sawElse)
        reporter_.error(name.where, "#" + name.spelling + " after #else");
    conditional.sawElse = name.is("else");
    bool candidate = conditional.outerActive && !conditional.taken;
    conditional.active = candidate && (name.is("else") || holds(line, name));
    conditional.taken |= conditional.active;
}

bool Conditionals::opens(const Token &name, const std::vector<Token> &line) {
    if (name.is("if"))
        return holds(line, name);
    if (line.empty() || !line[0].isIdentifier()) {
        reporter_.error(name.where, "expected a macro's name after #" + name.spelling);
        return false;
    }
    return macros_.isDefined(line[0].spelling) == name.is("ifdef");
}

/// The line with "defined X" and "defined(X)" replaced by 1 or 0; nothing if X is missing, which is
/// reported.
static std::optional<std::vector<Token>>
withDefinedAnswered(const std::vector<Token> &line, const MacroTable &macros, Reporter &reporter) {
    std::vector<Token> result;
    for (size_t i = 0; i < line.size(); ++i) {
        if (!line[i].is("defined")) {
            result.push_back(line[i]);
            continue;
        }
        bool brackets = i + 3 < line.size() && line[i + 1].is("(") && line[i + 3].is(")");
        size_t word = i + (brackets ? 2 : 1);
        if (word >= line.size() || !line[word].isIdentifier()) {
            reporter.error(line[i].where, "expected a macro's name after 'defined'");
            return std::nullopt;
        }
        bool defined = macros.isDefined(line[word].spelling);
        Token answer = line[i];
        answer.kind = TokenKind::Number;
        answer.number = defined;
        answer.spelling = std::to_string(int(defined));
        result.push_back(answer);
        i = word + (brackets ? 1 : 0);
    }
    return result;
}

bool Conditionals::holds(const std::vector<Token> &line, const Token &directive) {
    auto answered = withDefinedAnswered(withoutFlaws(line, reporter_), macros_, reporter_);
    if (!answered)
        return false;
    auto value = evaluateCondition(macros_.expandAll(*answered), directive.where, reporter_);
    return value && *value != 0;
}

void Conditionals::end() {
    for (; !open_.empty(); open_.pop_back())
        reporter_.error(open_.back().where,
                        "conditional is not closed; expected #endif before the end of file");
}

} // namespace candela::sl
