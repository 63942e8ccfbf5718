// SPDX-License-Identifier: Apache-2.0
// The syntax of POSIX extended regular expressions.
#pragma once

#include "language/ir/lower/regular_expression.h"

namespace candela::ir {

struct RegularExpressionNode {
    enum class Kind { Bytes, AtStart, AtEnd, Sequence, Choice, Repeat };
    static constexpr int unbounded = -1;

    Kind kind = Kind::Sequence;
    RegularExpression::Bytes bytes;
    std::vector<RegularExpressionNode> parts;
    int least = 0, most = unbounded; ///< Repeat
};

/// Nothing if the pattern is malformed. What POSIX leaves undefined counts as that, but for a
/// backslash before any letter, which stands for the letter, and for empty alternatives.
std::optional<RegularExpressionNode> parseRegularExpression(const std::string &pattern);

} // namespace candela::ir
