// SPDX-License-Identifier: Apache-2.0
// Writing a function anew with further values beside its own: derivatives, and whatever else is
// computed along with a value (bounds). The walk knows control flow and memory; what a plain
// operation's companions are, and which are wanted, the rules of a kind of number say.
#pragma once

#include "language/ir/core/builder.h"

#include <map>
#include <vector>

namespace candela::ir {

/// What stands beside a value, by part number (above 0). What is not there is zero.
using Companions = std::map<int, ValueId>;

/// By the old function's value: the new one, and what stands beside it.
struct WrittenValues {
    std::vector<ValueId> value;
    std::vector<Companions> beside;

    Values valuesOf(const Values &old) const;
};

/// A kind of number.
class CompanionRules {
public:
    virtual ~CompanionRules() = default;
    /// The parts of an old value that are to be written; of a loop's carried value at least those
    /// of the loop's result.
    virtual std::vector<int> wanted(ValueId) const = 0;
    /// The parts of an old array's elements that are to be kept beside them.
    virtual std::vector<int> wantedOfArray(int array) const = 0;
    /// Writes an operation without regions or memory, its results and what stands beside them.
    virtual void write(Builder &, const Instruction &old, WrittenValues &) = 0;
};

/// Writes `old` to the builder, whose function has its tables, but no code.
void writeWithCompanions(const Function &old, Builder &, CompanionRules &);

} // namespace candela::ir
