// SPDX-License-Identifier: Apache-2.0
// What the words ahead begin. Only control words are reserved: whether a word is a type or a name,
// and what it starts, is decided by what follows and by the names that are declared here.
#pragma once

#include <set>
#include <string>

#include "language/syntax/token_cursor.h"

namespace candela::sl {

/// Words that are never names: if, while, uniform...
bool isReserved(const Token &);

class Lookahead {
public:
    explicit Lookahead(const TokenCursor &tokens) : tokens_(tokens) {}

    bool isName(size_t ahead = 0) const;
    bool isTypeWord(size_t ahead = 0) const;
    bool startsSpecifier() const;
    bool startsDeclaration() const;
    /// A definition; it may begin with the detail of what it returns.
    bool startsFunction() const;
    /// A function's head with ';' behind it, as in C.
    bool startsPrototype() const;
    bool startsShader() const;

    /// From here on a type word of that spelling may be this variable.
    void declare(const std::string &name);

    /// Names that are declared while it lives are forgotten with it.
    class InnerScope {
    public:
        explicit InnerScope(Lookahead &ahead) : ahead_(ahead), outer_(ahead.namedAsTypes_) {}
        ~InnerScope() { ahead_.namedAsTypes_ = std::move(outer_); }
        InnerScope(const InnerScope &) = delete;
        InnerScope &operator=(const InnerScope &) = delete;

    private:
        Lookahead &ahead_;
        std::set<std::string> outer_;
    };

private:
    size_t behindDetail() const;
    size_t behindHead() const;
    size_t behindBrackets(size_t ahead) const;

    const TokenCursor &tokens_;
    std::set<std::string> namedAsTypes_; ///< Type words that are names of variables here.
};

} // namespace candela::sl
