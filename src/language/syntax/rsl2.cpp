// SPDX-License-Identifier: Apache-2.0
#include "language/syntax/rsl2.h"

namespace candela::sl {

std::string rsl2Construct(const TokenCursor &tokens) {
    const Token &word = tokens.peek(), &next = tokens.peek(1);
    if (!word.isIdentifier() || !next.isIdentifier())
        return {};
    const std::string both = word.spelling + " " + next.spelling;
    if (word.is("class") && (tokens.at("(", 2) || tokens.at("{", 2) || tokens.at(":", 2)))
        return both;
    if (word.is("struct") && tokens.at("{", 2))
        return both;
    if (word.is("public") || word.is("private"))
        return "'" + word.spelling + "'";
    if (word.is("shader") && tokens.atAny({";", "=", ",", "[", ")"}, 2))
        return "the type shader";
    return {};
}

std::string rsl2Message(const std::string &construct) {
    return construct + " is of RSL 2.0 (shader classes, structures, shader objects, arrays that "
                       "grow), which Candela does not support; a shader of RenderMan's first "
                       "Shading Language can say the same";
}

} // namespace candela::sl
