// SPDX-License-Identifier: Apache-2.0
#include "foundation/base/diagnostics.h"

#include <algorithm>

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

std::string format(const Diagnostic &d) {
    std::string result = d.where.text();
    if (!result.empty())
        result += ": ";
    result += std::string(nameOf(d.severity)) + ": " + d.message;
    if (d.sourceLine.empty())
        return result;
    // The caret's margin repeats the line's tabs, so that it stays below its place.
    std::string margin;
    for (int i = 0; i + 1 < d.where.column && i < int(d.sourceLine.size()); ++i)
        margin += d.sourceLine[i] == '\t' ? '\t' : ' ';
    return result + "\n    " + d.sourceLine + "\n    " + margin + "^" +
           std::string(std::max(0, d.caretLength - 1), '~');
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
