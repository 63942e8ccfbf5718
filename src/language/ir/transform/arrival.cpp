// SPDX-License-Identifier: Apache-2.0
#include "language/ir/transform/arrival.h"

#include "language/ir/analyse/affine.h"
#include "language/ir/core/builder_arithmetic.h"
#include "language/ir/core/builder_effects.h"
#include "language/ir/core/builder_sources.h"
#include "language/ir/core/op_info.h"
#include "language/ir/transform/companions.h"
#include "language/ir/transform/dead_code.h"

#include <optional>

namespace candela::ir {

namespace {

/// What stands beside values: how they grow with Ci, and with Oi, at the segment's end.
enum Factor : int { byCi = 1, byOi = 2 };

using MaybeValue = std::optional<ValueId>; ///< Nothing is zero.

std::vector<int> partsOf(ArrivalProof::Changes changes) {
    std::vector<int> parts;
    if (changes.withCi)
        parts.push_back(byCi);
    if (changes.withOi)
        parts.push_back(byOi);
    return parts;
}

class ArrivalRules : public CompanionRules {
public:
    explicit ArrivalRules(const Function &whole)
        : whole_(whole), proof_(proveAffineInArrival(whole)) {}

    std::vector<int> wanted(ValueId v) const override { return partsOf(proof_.ofValue[v]); }
    std::vector<int> wantedOfArray(int array) const override {
        return partsOf(proof_.ofArray[std::size_t(array)]);
    }

    void write(Builder &b, const Instruction &old, WrittenValues &written) override {
        if (old.op == Op::Output)
            return writeOutput(b, old, written);
        if (old.op == Op::Input)
            if (const auto channel = arrivalChannel(whole_, old.immediate))
                return writeArrival(b, old.results[0], *channel < b.colors().samples ? byCi : byOi,
                                    written);
        const Values now =
            b.emit(old.op, written.valuesOf(old.operands), old.immediate, old.number);
        for (std::size_t k = 0; k < old.results.size(); ++k) {
            written.value[old.results[k]] = now[k];
            for (int part : wanted(old.results[k]))
                if (const MaybeValue beside = factorOf(b, old, part, written))
                    written.beside[old.results[k]][part] = *beside;
        }
    }

private:
    /// Nothing is there, and what there is would be one unit more.
    static void writeArrival(Builder &b, ValueId result, Factor part, WrittenValues &written) {
        written.value[result] = number(b, 0);
        written.beside[result][part] = number(b, 1);
    }

    void writeOutput(Builder &b, const Instruction &old, WrittenValues &written) {
        const OutputSlot &slot = whole_.outputs[std::size_t(old.immediate)];
        const ValueId v = old.operands[0];
        b.emit(Op::Output, {written.value[v]}, old.immediate);
        const auto add = [&](OutputKind kind, Factor part) {
            output(b, kind, slot.component, beside(written, v, part).value_or(number(b, 0)));
        };
        if (slot.name == OutputKind::Ci)
            add(OutputKind::CiOfCi, byCi), add(OutputKind::CiOfOi, byOi);
        if (slot.name == OutputKind::Oi)
            add(OutputKind::OiOfOi, byOi);
    }

    static MaybeValue beside(const WrittenValues &written, ValueId v, int part) {
        const auto found = written.beside[v].find(part);
        return found == written.beside[v].end() ? std::nullopt : MaybeValue(found->second);
    }

    /// The rules of what is affine; one factor of a product, and the divisor, are the same for
    /// whatever arrives.
    MaybeValue factorOf(Builder &b, const Instruction &old, int part,
                        const WrittenValues &written) const {
        const auto value = [&](std::size_t k) { return written.value[old.operands[k]]; };
        const auto grows = [&](std::size_t k) { return beside(written, old.operands[k], part); };
        const auto or0 = [&](MaybeValue v) { return v.value_or(number(b, 0)); };
        switch (info(old.op).slope) {
        case SlopeRule::Sum:
            return grows(0) && grows(1) ? add(b, *grows(0), *grows(1))
                   : grows(0)           ? grows(0)
                                        : grows(1);
        case SlopeRule::Difference:
            return grows(0) && grows(1) ? sub(b, *grows(0), *grows(1))
                   : grows(1)           ? MaybeValue(neg(b, *grows(1)))
                                        : grows(0);
        case SlopeRule::Negation: return grows(0) ? MaybeValue(neg(b, *grows(0))) : std::nullopt;
        case SlopeRule::Product:
            return grows(0)   ? MaybeValue(mul(b, *grows(0), value(1)))
                   : grows(1) ? MaybeValue(mul(b, value(0), *grows(1)))
                              : std::nullopt;
        case SlopeRule::Quotient:
            return grows(0) ? MaybeValue(div(b, *grows(0), value(1))) : std::nullopt;
        case SlopeRule::Choice: return select(b, value(0), or0(grows(1)), or0(grows(2)));
        default: return std::nullopt;
        }
    }

    const Function &whole_;
    const ArrivalProof proof_;
};

} // namespace

Function affineParts(const Function &whole) {
    ArrivalRules rules(whole);
    Function parts = whole;
    parts.body = {};
    parts.values.clear();
    Builder b(parts);
    writeWithCompanions(whole, b, rules);
    b.finish();
    removeDeadCode(parts);
    return parts;
}

} // namespace candela::ir
