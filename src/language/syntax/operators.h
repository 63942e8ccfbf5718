// SPDX-License-Identifier: Apache-2.0
// The precedence of the infix operators: the parser's table.
#pragma once

#include <string_view>

#include "language/syntax/base_type.h"

namespace candela::sl {

/// How tightly things bind, loosest first (RI 3.2 section 13).
enum class Precedence {
    None,
    Assignment, ///< = += -= *= /=, from the right
    Choice,     ///< ?:, from the right
    Or,
    And,
    Equality,
    Relation,
    Sum,
    Cross, ///< ^ binds looser than * and /, as RI has it
    Product,
    Dot,
    Unary ///< - ! and type casts
};

enum class InfixKind { Binary, Assign, Choice };

struct Infix {
    std::string_view spelling;
    Precedence precedence;
    InfixKind kind;
    BinaryOp op = BinaryOp::Add; ///< Binary; and Assign if compound.
    bool compound = false;
};

/// The infix operator of that spelling, or null.
const Infix *infixNamed(std::string_view spelling);

} // namespace candela::sl
