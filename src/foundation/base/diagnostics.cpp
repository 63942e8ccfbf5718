// SPDX-License-Identifier: Apache-2.0
#include "foundation/base/diagnostics.h"

#include "foundation/base/visible_text.h"

#include <algorithm>
#include <utility>

namespace candela {

std::string SourceLocation::text() const {
    std::string result;
    if (file)
        result = *file;
    if (line > 0)
        result += ":" + std::to_string(line);
    if (line > 0 && column > 0)
        result += ":" + std::to_string(column);
    return result;
}

static const char *nameOf(Severity severity) {
    switch (severity) {
    case Severity::Note: return "note";
    case Severity::Warning: return "warning";
    case Severity::Error: return "error";
    case Severity::Fatal: return "fatal error";
    }
    return "error";
}

/// So many bytes of a source line, around the column, are printed at most: files that programs
/// write may be a single line of megabytes.
static constexpr int quotedLength = 120;

/// What is shown of the source line, with dots where the rest is left out, and the column in it,
/// from 0, that the caret points to.
static std::pair<std::string, int> quoteOf(const Diagnostic &d) {
    const std::string &line = d.sourceLine;
    const int size = int(line.size());
    const int column = std::clamp(d.where.column - 1, 0, size);
    int begin = std::clamp(column - quotedLength / 2, 0, std::max(0, size - quotedLength));
    int end = std::min(size, begin + quotedLength);
    while (begin > 0 && begin < column && continuesCharacter(line[begin]))
        ++begin;
    while (end < size && end > column && continuesCharacter(line[end]))
        --end;
    const std::string before = begin > 0 ? "..." : "", after = end < size ? "..." : "";
    return {before + line.substr(begin, end - begin) + after, int(before.size()) + column - begin};
}

std::string format(const Diagnostic &d) {
    std::string result = visible(d.where.text());
    if (!result.empty())
        result += ": ";
    result += std::string(nameOf(d.severity)) + ": " + visible(shortened(d.message));
    if (d.sourceLine.empty())
        return result;
    const auto [line, column] = quoteOf(d);
    std::vector<std::size_t> places;
    const std::string shown = visible(line, "\t", &places);
    // The caret's margin repeats the line's tabs, so that it stays below its place.
    std::string margin = shown.substr(0, places[column]);
    for (char &c : margin)
        c = c == '\t' ? '\t' : ' ';
    const int last = std::min(int(line.size()), column + std::max(1, d.caretLength));
    const int length = int(places[last]) - int(places[column]);
    return result + "\n    " + shown + "\n    " + margin + "^" +
           std::string(std::max(0, length - 1), '~');
}

void DiagnosticSink::error(SourceLocation where, std::string message) {
    report({Severity::Error, std::move(where), std::move(message), {}, 1});
}

void DiagnosticSink::warning(SourceLocation where, std::string message) {
    report({Severity::Warning, std::move(where), std::move(message), {}, 1});
}

void DiagnosticList::report(const Diagnostic &diagnostic) {
    std::lock_guard lock(mutex_);
    diagnostics_.push_back(diagnostic);
}

std::vector<Diagnostic> DiagnosticList::all() const {
    std::lock_guard lock(mutex_);
    return diagnostics_;
}

int DiagnosticList::count(Severity severity) const {
    std::lock_guard lock(mutex_);
    return int(std::ranges::count(diagnostics_, severity, &Diagnostic::severity));
}

std::string DiagnosticList::text() const {
    std::string result;
    for (const Diagnostic &d : all())
        result += format(d) + "\n";
    return result;
}

} // namespace candela
