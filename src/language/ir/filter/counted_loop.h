// SPDX-License-Identifier: Apache-2.0
// Loops that count: for (x = first; x < end; x += 1).
#pragma once

#include "language/ir/filter/value_facts.h"

#include <optional>

namespace candela::ir {

struct CountedLoop {
    const Instruction *loop = nullptr;
    std::size_t counter = 0; ///< Which of its carried values.
    ValueId first = 0, end = 0;
    bool isClosed = false; ///< x <= end.

    ValueId variable() const { return loop->regions[0].arguments[counter]; }
    const Region &body() const { return loop->regions[0]; }
};

/// The loop, if it counts up by 1 from and to what does not change within.
std::optional<CountedLoop> countedLoop(const Instruction &, const ValueFacts &);

} // namespace candela::ir
