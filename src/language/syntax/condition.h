// SPDX-License-Identifier: Apache-2.0
// The expressions of #if and #elif.
#pragma once

#include <optional>
#include <vector>

#include "language/syntax/reporter.h"
#include "language/syntax/token.h"

namespace candela::sl {

/// The value of a condition, macros already expanded and `defined` already answered; words that
/// are left count as 0. Knows C's operators; numbers may have fractions. Nothing, and an error
/// reported, if the tokens are no expression.
std::optional<double> evaluateCondition(const std::vector<Token> &, const Place &directive,
                                        Reporter &);

} // namespace candela::sl
