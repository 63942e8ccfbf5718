// SPDX-License-Identifier: Apache-2.0
#include "language/syntax/flaws.h"

namespace candela::sl {

void reportFlaw(const Token &token, Reporter &reporter) {
    if (token.flaw)
        reporter.error(token.flaw->where, token.flaw->message);
}

std::vector<Token> withoutFlaws(std::vector<Token> tokens, Reporter &reporter) {
    for (const Token &token : tokens)
        reportFlaw(token, reporter);
    std::erase_if(tokens, [](const Token &token) { return token.kind == TokenKind::Stray; });
    return tokens;
}

} // namespace candela::sl
