// SPDX-License-Identifier: Apache-2.0
// Diagnostics are data: whoever finds something wrong describes it, and the sink it was given
// decides what becomes of it. No room throws across its walls, and none calls exit().
#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace candela {

enum class Severity { Note, Warning, Error, Fatal };

/// Where in the user's files something stands. Lines and columns count from 1; 0 = unknown.
struct SourceLocation {
    std::shared_ptr<const std::string> file;
    int line = 0;
    int column = 0;

    /// "file:line:column", as far as it is known; empty if nothing is.
    std::string text() const;
};

struct Diagnostic {
    Severity severity = Severity::Error;
    SourceLocation where;
    std::string message;    ///< One sentence: what is wrong, what was expected, what to do.
    std::string sourceLine; ///< The line it is about, for a caret; may be empty.
    int caretLength = 1;    ///< How many columns the caret underlines.
};

/// The diagnostic as a compiler prints it: location, severity, message, source line and caret.
std::string format(const Diagnostic &);

class DiagnosticSink {
public:
    virtual ~DiagnosticSink() = default;
    /// May be called from any thread.
    virtual void report(const Diagnostic &) = 0;

    void error(SourceLocation where, std::string message);
    void warning(SourceLocation where, std::string message);
};

/// Keeps what was reported, for tests and for callers that print later.
class DiagnosticList : public DiagnosticSink {
public:
    void report(const Diagnostic &) override;
    std::vector<Diagnostic> all() const;
    int count(Severity) const;
    /// All messages, a line each, in the order of their coming.
    std::string text() const;

private:
    mutable std::mutex mutex_;
    std::vector<Diagnostic> diagnostics_;
};

} // namespace candela
