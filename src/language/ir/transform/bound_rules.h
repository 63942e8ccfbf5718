// SPDX-License-Identifier: Apache-2.0
// Over a box: plain operations, by their rule in core/ops.def.
#pragma once

#include "language/ir/transform/bound_values.h"

#include <string>
#include <vector>

namespace candela::ir {

/// Something of which nothing is known.
struct BoundlessNote {
    int line = 0;
    std::string what; ///< "texture()"
    bool operator==(const BoundlessNote &) const = default;
};

/// Writes the operations of an old function anew, with what is known of their results.
class BoundRules {
public:
    BoundRules(const Function &old, Builder &);

    /// Writes an operation without regions or memory; its results' entries are set.
    void write(const Instruction &, std::vector<BoundedValue> &written);
    /// What is not known, in the order of the text.
    const std::vector<BoundlessNote> &notes() const { return notes_; }

private:
    using Operands = std::vector<BoundedValue>;
    BoundedValue bound(const Instruction &, const Operands &, ValueId middle);
    /// A vector and its length.
    struct Scaled {
        std::array<ValueId, 3> vector;
        ValueId length;
    };
    std::optional<Scaled> scaledBy(ValueId reciprocal) const;
    FormParts product(const Instruction &, const Operands &, ValueId middle);
    /// from (1 - share) + to share; nothing stands for 1.
    struct Mix {
        std::optional<ValueId> from, to;
        ValueId share;
    };
    std::optional<Mix> mixOf(const Instruction &sum) const;
    /// The two vectors of a dot product, which ends with the sum.
    std::optional<std::array<std::array<ValueId, 3>, 2>> dotOf(const Instruction &sum) const;
    std::optional<ValueId> isUnit(const std::array<ValueId, 3> &, int depth);
    FormParts cutAsDot(const Instruction &sum, const FormParts &);
    FormParts sum(const Instruction &, const Operands &, ValueId middle);
    std::optional<ValueId> summandBeside(ValueId sum, ValueId one) const;
    std::optional<ValueId> shareOf(ValueId part, ValueId whole) const;
    FormParts difference(const Instruction &, const Operands &);
    FormParts monotone(const Instruction &, const BoundedValue &x, ValueId middle);
    BoundedValue selected(const Instruction &, const Operands &, ValueId middle);
    /// The t of a smoothstep() that the Select is; nothing if it is none.
    const ValueId *smoothStepOf(const Instruction &) const;
    const Instruction *definition(ValueId v, Op) const;
    bool isNumber(ValueId v, float) const;
    FormParts boundless(const Instruction &);

    const Function &old_;
    Builder &b_;
    std::vector<const Instruction *> definitions_; ///< By old value.
    const std::vector<BoundedValue> *written_ = nullptr;
    std::vector<BoundlessNote> notes_;
};

} // namespace candela::ir
