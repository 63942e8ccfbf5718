// SPDX-License-Identifier: Apache-2.0
// What the lowering refuses because later passes would take too long for it
// (docs/compiler-limits.md; core/budget.h has the limits that passes share).
#pragma once

#include <cstddef>

namespace candela::ir {

/// Requests for light: light loops, diffuse() and its like, trace(), with those of each call of a
/// function. What is asked of a surface without one of its lobes is written for each of them.
inline constexpr std::size_t mostRequests = 320;
/// Rounds of a loop that are written out because its strings have to be known.
inline constexpr int mostWrittenRounds = 64;
/// Numbers that one printf() prints.
inline constexpr std::size_t mostPrinted = 256;

} // namespace candela::ir
