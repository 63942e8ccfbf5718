// SPDX-License-Identifier: Apache-2.0
// Source files as the compiler holds them, and places in them.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "foundation/base/diagnostics.h"

namespace candela::sl {

/// A comment of the source, kept for the documentation of shader parameters.
struct Comment {
    int firstLine = 0;
    int lastLine = 0;
    std::string text; ///< Without its delimiters, trimmed.
};

/// One file. Line ends are normalised to '\n' when it is made (CRLF and lone CR are accepted); a
/// byte order mark before and Ctrl-Z behind the text are dropped.
class SourceFile {
public:
    SourceFile(std::string name, std::string_view text, bool mayBeQuoted = true);

    const std::string &name() const { return *name_; }
    const std::shared_ptr<const std::string> &sharedName() const { return name_; }
    const std::string &text() const { return text_; }
    /// Whether diagnostics may show its lines.
    bool mayBeQuoted() const { return mayBeQuoted_; }
    /// Line n, counted from 1, without its line end; empty beyond the file.
    std::string_view line(int n) const;

    std::vector<Comment> comments; ///< In the order of the file; the lexer fills it.

private:
    std::shared_ptr<const std::string> name_;
    bool mayBeQuoted_;
    std::string text_;
    std::vector<size_t> lineStarts_;
};

/// A stretch of one line of a file. Lines and columns count from 1. The file is owned by the
/// SourceSet of the compilation, which the compiled shaders keep alive.
struct Place {
    const SourceFile *file = nullptr;
    int line = 0;
    int column = 0;
    int length = 1;

    SourceLocation location() const;
};

/// All files that one compilation has read.
using SourceSet = std::vector<std::unique_ptr<SourceFile>>;

/// A diagnostic about a place, with its source line and a caret below all of it.
Diagnostic diagnosticAt(Severity, const Place &, std::string message);

} // namespace candela::sl
