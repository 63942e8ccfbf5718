// SPDX-License-Identifier: Apache-2.0
// #if, #ifdef, #ifndef, #elif, #else and #endif: which lines of a file count.
#pragma once

#include <vector>

#include "language/syntax/macro.h"
#include "language/syntax/reporter.h"
#include "language/syntax/token.h"

namespace candela::sl {

/// The conditionals of one file; they are closed in the file that opens them.
class Conditionals {
public:
    Conditionals(MacroTable &macros, Reporter &reporter) : macros_(macros), reporter_(reporter) {}

    /// Whether the lines here count.
    bool active() const { return open_.empty() || open_.back().active; }
    /// Obeys the directive with that name and rest of its line; false if it is none of these.
    bool obey(const Token &name, const std::vector<Token> &line);
    /// At the end of the file: reports what is still open.
    void end();

private:
    struct Conditional {
        Place where;
        bool active;      ///< The lines of its branch count.
        bool taken;       ///< This or an earlier branch was active.
        bool outerActive; ///< The #if itself stands in lines that count.
        bool sawElse = false;
    };

    void otherBranch(const Token &name, const std::vector<Token> &line);
    bool opens(const Token &name, const std::vector<Token> &line);
    bool holds(const std::vector<Token> &line, const Token &directive);

    MacroTable &macros_;
    Reporter &reporter_;
    std::vector<Conditional> open_; ///< One inside the other.
};

} // namespace candela::sl
