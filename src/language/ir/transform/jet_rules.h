// SPDX-License-Identifier: Apache-2.0
// The chain rule, operation by operation.
#pragma once

#include "language/ir/transform/companions.h"
#include "language/ir/transform/jet.h"
#include "language/ir/transform/jet_order.h"

#include <optional>
#include <string>
#include <vector>

namespace candela::ir {

/// What is known of the derivatives of an operation's results.
enum class SlopeKind : std::uint8_t {
    Zero,   ///< They are zero (of steps: almost everywhere).
    Rule,   ///< They follow from those of the operands, or stand in inputs.
    Held,   ///< Unknown, and taken to be zero; users are told.
    Refused ///< Unknown: an error.
};
SlopeKind slopeKind(const Function &, const Instruction &);
/// What a user is told of a Held or Refused source.
std::string slopeNote(const Function &, const Instruction &);
/// A note about an instruction; only Slopes know their file.
SlopeNote noteAt(const Instruction &, const std::string &text);
/// Derivatives of this order and beyond of the results are Held though lower ones have a rule.
int firstHeldOrder(const Instruction &);
/// Derivatives of this order and beyond of a result are Refused.
int firstRefusedOrder(const Instruction &, size_t result);

/// Whether a result may change with the direction though no operand does.
bool changesWith(const Function &, const Instruction &, Direction);
/// The operands that the derivatives of a plain operation's results depend on.
std::vector<ValueId> differentiableOperands(const Function &, const Instruction &);

/// Writes the wanted derivatives, as Taylor coefficients by partOf(), beside plain operations.
class JetRules : public CompanionRules {
public:
    /// The parts that are wanted, by old value and array, and how many values the written function
    /// may have.
    JetRules(std::vector<Parts> ofValue, std::vector<Parts> ofArray, int mostValues);

    std::vector<int> wanted(ValueId) const override;
    std::vector<int> wantedOfArray(int array) const override;
    void write(Builder &, const Instruction &old, WrittenValues &) override;
    const std::optional<SlopeNote> &fault() const { return fault_; }

private:
    void writeSlope(Builder &, const Instruction &, WrittenValues &);
    void writePlain(Builder &, const Instruction &, WrittenValues &);

    const std::vector<Parts> ofValue_, ofArray_;
    const int mostValues_;
    std::optional<SlopeNote> fault_;
};

} // namespace candela::ir
