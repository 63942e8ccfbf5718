// SPDX-License-Identifier: Apache-2.0
#include "language/ir/core/rates.h"

#include "language/ir/core/op_info.h"

namespace candela::ir {

namespace {

/// Rates only ever rise, so sweeping until nothing rises ends.
class RateInference {
public:
    explicit RateInference(Function &function) : function_(function) {}

    void run() {
        for (Value &v : function_.values)
            v.rate = Rate::Uniform;
        for (Array &a : function_.arrays)
            a.rate = Rate::Uniform;
        do {
            changed_ = false;
            sweep(function_.body, false);
        } while (changed_);
    }

private:
    bool varies(ValueId v) const { return function_.values[v].rate == Rate::Varying; }
    void raise(Rate &rate, bool varying) {
        if (varying && rate == Rate::Uniform) {
            rate = Rate::Varying;
            changed_ = true;
        }
    }
    void raise(ValueId v, bool varying) { raise(function_.values[v].rate, varying); }

    void sweep(Region &region, bool divergent) {
        for (Instruction &i : region.body)
            sweep(i, divergent);
    }

    void sweep(Instruction &i, bool divergent) {
        switch (i.op) {
        case Op::If: return sweepIf(i, divergent);
        case Op::Loop: return sweepLoop(i, divergent);
        case Op::LightLoop:
            for (ValueId v : i.regions[0].arguments)
                raise(v, true);
            for (ValueId v : i.results)
                raise(v, true);
            return sweep(i.regions[0], true);
        case Op::ArrayStore:
            return raise(function_.arrays[i.immediate].rate,
                         divergent || varies(i.operands[0]) || varies(i.operands[1]));
        default: break;
        }
        bool varying = info(i.op).varying;
        if (i.op == Op::ArrayLoad)
            varying |= function_.arrays[i.immediate].rate == Rate::Varying;
        for (ValueId v : i.operands)
            varying |= varies(v);
        for (ValueId v : i.results)
            raise(v, varying);
    }

    void sweepIf(Instruction &i, bool divergent) {
        bool varying = varies(i.operands[0]);
        for (Region &region : i.regions) {
            sweep(region, divergent || varying);
            for (std::size_t k = 0; k < i.results.size(); ++k)
                raise(i.results[k], varying || varies(region.yields[k]));
        }
    }

    void sweepLoop(Instruction &i, bool divergent) {
        Region &region = i.regions[0];
        for (std::size_t k = 0; k < i.results.size(); ++k) {
            bool varying = varies(i.operands[k]) || varies(region.arguments[0]) ||
                           (!region.yields.empty() && varies(region.yields[k]));
            raise(region.arguments[k], varying);
            raise(i.results[k], varying);
        }
        sweep(region, divergent || varies(region.arguments[0]));
    }

    Function &function_;
    bool changed_ = false;
};

} // namespace

void inferRates(Function &function) { RateInference(function).run(); }

} // namespace candela::ir
