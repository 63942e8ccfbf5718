// SPDX-License-Identifier: Apache-2.0
#include "foundation/base/diagnostic_limit.h"

#include <algorithm>
#include <cctype>

namespace candela {

namespace {

bool isWordCharacter(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }
bool isDigit(char c) { return std::isdigit(static_cast<unsigned char>(c)); }

/// One past the closing quote if a quoted name starts there, else `start`. An apostrophe inside a
/// word opens nothing, and one before a letter closes nothing.
std::size_t endOfQuoted(const std::string &text, std::size_t start) {
    const char quote = text[start];
    const bool apostrophe = quote == '\'';
    if (quote != '"' && !(apostrophe && (start == 0 || !isWordCharacter(text[start - 1]))))
        return start;
    for (std::size_t end = start + 1; end < text.size(); ++end)
        if (text[end] == quote &&
            !(apostrophe && end + 1 < text.size() && isWordCharacter(text[end + 1])))
            return end + 1;
    return start;
}

/// The same for a number: digits with sign, point and exponent. Digits of a word belong to it.
std::size_t endOfNumber(const std::string &text, std::size_t start) {
    if (start > 0 && isWordCharacter(text[start - 1]))
        return start;
    std::size_t end = start;
    if (text[end] == '-' || text[end] == '+')
        ++end;
    if (end < text.size() && text[end] == '.')
        ++end;
    if (end >= text.size() || !isDigit(text[end]))
        return start;
    while (end < text.size() && (isWordCharacter(text[end]) || text[end] == '.' ||
                                 ((text[end] == '-' || text[end] == '+') && text[end - 1] == 'e')))
        ++end;
    return text[end - 1] == '.' ? end - 1 : end; // The end of the sentence.
}

} // namespace

std::string kindOf(const Diagnostic &diagnostic) {
    const std::string &text = diagnostic.message;
    std::string kind = std::to_string(int(diagnostic.severity)) + " ";
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::max(endOfQuoted(text, at), endOfNumber(text, at));
        if (end > at)
            kind += '#';
        else
            kind += text[at];
        at = std::max(end, at + 1);
    }
    return kind;
}

bool DiagnosticLimit::admits(const Diagnostic &diagnostic) {
    if (toldBytes_ > mostBytes)
        return ++untold_, false;
    auto [place, isNew] = kinds_.try_emplace(kindOf(diagnostic), Kind{int(kinds_.size()), 0, {}});
    Kind &kind = place->second;
    if (++kind.count == most + 1)
        kind.example = diagnostic.message;
    if (kind.count > most)
        return false;
    toldBytes_ += format(diagnostic).size();
    return true;
}

std::vector<Diagnostic> DiagnosticLimit::rest() {
    std::vector<const Kind *> more;
    for (const auto &[text, kind] : kinds_)
        if (kind.count > most)
            more.push_back(&kind);
    std::ranges::sort(more, {}, &Kind::number);
    std::vector<Diagnostic> notes;
    for (const Kind *kind : more)
        notes.push_back({Severity::Note,
                         {},
                         std::to_string(kind->count - most) + " more like this: " + kind->example,
                         {},
                         1});
    if (untold_ > 0)
        notes.push_back({Severity::Note, {}, std::to_string(untold_) + " more messages", {}, 1});
    kinds_.clear();
    toldBytes_ = untold_ = 0;
    return notes;
}

} // namespace candela
