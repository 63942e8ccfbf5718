// SPDX-License-Identifier: Apache-2.0
// What ops.def says, as data.
#pragma once

#include "language/ir/core/ir.h"

#include <string_view>

namespace candela::ir {

struct OpInfo {
    const char *name;
    std::string_view operands; ///< Letters of ops.def, without blanks.
    std::string_view results;
    bool varying; ///< The results vary whatever the operands.
};

const OpInfo &info(Op);
/// What a letter of ops.def stands for: f, b, i or s.
Type typeOf(char letter);
inline constexpr int opCount = int(Op::CategoryAccepts) + 1;

/// ConstFloat, ConstBool, ConstInteger, ConstString.
bool isConstant(Op);
/// Same operands, same results, nothing else: may be shared, moved and left out. Not so are
/// memory, light, control and effects.
bool isPure(Op);
/// Must stay even if nobody uses its results.
bool hasEffect(Op);
/// Float to float, one or two operands.
bool isFloatArithmetic(Op);

/// The one definition of scalar arithmetic, for the interpreter and for folding.
float evaluateFloat(Op, float a, float b);
bool evaluateCompare(Op, float a, float b);
/// Truncated; saturating; NaN gives 0.
int integerFromFloat(float);

} // namespace candela::ir
