// SPDX-License-Identifier: Apache-2.0
// Over a box: plain operations, by their rule in core/ops.def.
#pragma once

#include "language/ir/transform/bound_values.h"
#include "language/ir/transform/idioms.h"

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
    FormParts product(const Instruction &, const Operands &, ValueId middle);
    std::optional<ValueId> isUnit(const std::array<ValueId, 3> &, int depth);
    FormParts cutAsDot(const Instruction &sum, const FormParts &);
    FormParts sum(const Instruction &, const Operands &, ValueId middle);
    std::optional<ValueId> shareOf(ValueId part, ValueId whole) const;
    FormParts difference(const Instruction &, const Operands &);
    FormParts monotone(const Instruction &, const BoundedValue &x, ValueId middle);
    BoundedValue selected(const Instruction &, const Operands &, ValueId middle);
    FormParts boundless(const Instruction &);

    const Function &old_;
    Builder &b_;
    Idioms idioms_; ///< Of the old function.
    const std::vector<BoundedValue> *written_ = nullptr;
    std::vector<BoundlessNote> notes_;
};

} // namespace candela::ir
