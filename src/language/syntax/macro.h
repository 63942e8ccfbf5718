// SPDX-License-Identifier: Apache-2.0
// Macros and their expansion.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "language/syntax/reporter.h"
#include "language/syntax/token.h"

namespace candela::sl {

struct Macro {
    bool takesArguments = false;
    std::vector<std::string> parameters;
    std::vector<Token> body;
};

/// Tokens to read, with room to put expansions back in front.
class TokenStream {
public:
    explicit TokenStream(std::vector<Token> tokens) : tokens_(std::move(tokens)) {}

    /// The next token without taking it; End for ever at the end.
    const Token &peek() const;
    Token take();
    void putBack(const std::vector<Token> &);
    /// Whether the next token comes from the file itself, not out of a macro.
    bool inFile() const { return front_.empty(); }

private:
    std::vector<Token> tokens_; ///< Ends with End, or is empty.
    size_t at_ = 0;
    std::vector<Token> front_; ///< Put back, last first.
    Token end_;
};

/// All macros of a compilation.
class MacroTable {
public:
    explicit MacroTable(Reporter &reporter) : reporter_(reporter) {}

    void define(const std::string &name, Macro macro) { macros_[name] = std::move(macro); }
    void undefine(const std::string &name) { macros_.erase(name); }
    bool isDefined(const std::string &name) const {
        return isOfPlace(name) || macros_.contains(name);
    }
    /// __LINE__ and __FILE__, which tell where they stand and are not for users to define.
    static bool isOfPlace(const std::string &name) {
        return name == "__LINE__" || name == "__FILE__";
    }

    /// If the token (just taken from the stream) calls a macro, its expansion is put back on the
    /// stream and the answer is true.
    bool expand(const Token &, TokenStream &);
    /// All of a list, expanded to the end.
    std::vector<Token> expandAll(std::vector<Token> tokens);

private:
    using Arguments = std::vector<std::vector<Token>>;
    std::optional<Arguments> collectArguments(const Token &name, const Macro &, TokenStream &);
    std::vector<Token> substitute(const Token &name, const Macro &, const Arguments &);
    void paste(std::vector<Token> &left, const std::vector<Token> &right, const Place &);
    bool overBudget(const Place &, size_t more);

    Reporter &reporter_;
    std::map<std::string, Macro> macros_;
    size_t produced_ = 0;
    int depth_ = 0;
};

} // namespace candela::sl
