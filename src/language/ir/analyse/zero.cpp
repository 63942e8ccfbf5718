// SPDX-License-Identifier: Apache-2.0
#include "language/ir/analyse/zero.h"

#include "language/ir/core/op_info.h"

namespace candela::ir {

namespace {

/// Optimistic: everything in loops is zero until something shows otherwise.
class ZeroSweep {
public:
    explicit ZeroSweep(const Function &function)
        : zero_(function.values.size(), true), arrayZero_(function.arrays.size(), true) {
        do {
            changed_ = false;
            sweep(function.body);
        } while (changed_);
    }
    std::vector<bool> zero_;

private:
    void clear(ValueId v) {
        if (zero_[v]) {
            zero_[v] = false;
            changed_ = true;
        }
    }
    bool zero(const Instruction &i, int operand) const { return zero_[i.operands[operand]]; }

    void sweep(const Region &region) {
        for (const Instruction &i : region.body)
            sweep(i);
    }

    void sweep(const Instruction &i) {
        switch (i.op) {
        case Op::If:
            for (const Region &region : i.regions) {
                sweep(region);
                clearFrom(region.yields, i.results);
            }
            return;
        case Op::Loop:
        case Op::LightLoop: return sweepLoop(i);
        case Op::ArrayStore:
            if (!zero(i, 1) && arrayZero_[i.immediate]) {
                arrayZero_[i.immediate] = false;
                changed_ = true;
            }
            return;
        default:
            for (ValueId v : i.results)
                if (!isZero(i))
                    clear(v);
        }
    }

    void clearFrom(const std::vector<ValueId> &from, const std::vector<ValueId> &to) {
        for (std::size_t k = 0; k < to.size(); ++k)
            if (!zero_[from[k]])
                clear(to[k]);
    }

    void sweepLoop(const Instruction &i) {
        const Region &region = i.regions[0];
        std::size_t fixed = i.operands.size() - i.results.size();
        std::size_t firstArgument = region.arguments.size() - i.results.size();
        for (std::size_t k = 0; k < firstArgument; ++k)
            clear(region.arguments[k]);
        for (std::size_t k = 0; k < i.results.size(); ++k)
            if (!zero_[i.operands[fixed + k]] || !zero_[region.yields[k]]) {
                clear(region.arguments[firstArgument + k]);
                clear(i.results[k]);
            }
        sweep(region);
    }

    bool isZero(const Instruction &i) const {
        switch (i.op) {
        case Op::ConstFloat: return i.number == 0;
        case Op::Mul: return zero(i, 0) || zero(i, 1);
        case Op::Div: return zero(i, 0);
        case Op::Add:
        case Op::Sub:
        case Op::Min:
        case Op::Max: return zero(i, 0) && zero(i, 1);
        case Op::Select: return zero(i, 1) && zero(i, 2);
        case Op::Neg:
        case Op::Abs:
        case Op::Floor:
        case Op::Ceil:
        case Op::Round:
        case Op::Sqrt:
        case Op::Sin:
        case Op::Tan:
        case Op::Asin:
        case Op::Atan: return zero(i, 0);
        case Op::ArrayLoad: return arrayZero_[i.immediate];
        default: return false;
        }
    }

    std::vector<bool> arrayZero_;
    bool changed_ = false;
};

} // namespace

std::vector<bool> provablyZero(const Function &function) { return ZeroSweep(function).zero_; }

} // namespace candela::ir
