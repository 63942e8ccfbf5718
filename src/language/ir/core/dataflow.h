// SPDX-License-Identifier: Apache-2.0
// The fixed-point engine of all analyses that follow values forward: facts by value and by array,
// raised until nothing rises any more.
//
// An analysis derives from ForwardAnalysis<Fact> and says what is so of
//   Fact result(const Instruction &, std::size_t k, const Enclosing *)  the k-th result of an
//                                                                       instruction without regions
//   Fact array(const Instruction &, const Enclosing *)                  an array after a load or
//                                                                       store of it
//   Fact flow(const ValueFlow &, const Enclosing *)                          a value that control
//   flow
//                                                                       chooses or carries
//   Fact given(const Instruction &, std::size_t k)                      argument k of a light loop:
//                                                                       L, Cl, the light's number
// from the facts that are known so far. What it says of the same thing must only ever rise, in a
// lattice of finite height; the fact that holds already may be asked for and returned.
#pragma once

#include "language/ir/core/op_info.h"
#include "language/ir/core/regions.h"

#include <vector>

namespace candela::ir {

template <typename Fact_> struct ForwardAnalysis {
    using Fact = Fact_;
    /// A vector<bool> would give no references.
    struct Cell {
        Fact fact;
    };

    explicit ForwardAnalysis(const Function &function, Fact start = {})
        : function(function), values(function.values.size(), {start}),
          arrays(function.arrays.size(), {start}) {}

    const Fact &at(ValueId v) const { return values[v].fact; }
    /// Of an operand.
    const Fact &at(const Instruction &i, std::size_t k) const { return at(i.operands[k]); }
    /// Of the array that the load or store is of.
    const Fact &arrayOf(const Instruction &access) const { return arrays[access.immediate].fact; }

    const Function &function;
    std::vector<Cell> values, arrays;
};

/// Runs an analysis over a function, or over one loop of it.
template <typename Analysis> class Dataflow {
public:
    explicit Dataflow(Analysis &analysis) : analysis_(analysis) {}

    void run(const Region &body) {
        untilStable([&] { sweep(body, nullptr); });
    }
    void run(const Instruction &owner) {
        untilStable([&] { sweep(owner, nullptr); });
    }

private:
    template <typename Work> void untilStable(Work work) {
        do {
            changed_ = false;
            work();
        } while (changed_);
    }

    template <typename Cell, typename Fact> void update(Cell &cell, const Fact &fact) {
        if (!(cell.fact == fact)) {
            cell.fact = fact;
            changed_ = true;
        }
    }

    void sweep(const Region &region, const Enclosing *around) {
        for (const Instruction &i : region.body)
            if (i.regions.empty())
                sweepPlain(i, around);
            else
                sweep(i, around);
    }

    void sweepPlain(const Instruction &i, const Enclosing *around) {
        if (isArrayAccess(i.op))
            update(analysis_.arrays[i.immediate], analysis_.array(i, around));
        for (std::size_t k = 0; k < i.results.size(); ++k)
            update(analysis_.values[i.results[k]], analysis_.result(i, k, around));
    }

    void sweep(const Instruction &owner, const Enclosing *around) {
        const auto follow = [&](const ValueFlow &flow) {
            update(analysis_.values[flow.to], analysis_.flow(flow, around));
        };
        if (owner.op == Op::LightLoop)
            for (std::size_t k = 0; k < givenArguments(owner); ++k)
                update(analysis_.values[owner.regions[0].arguments[k]], analysis_.given(owner, k));
        forEachFlowIn(owner, follow);
        const Enclosing inside{&owner, around};
        for (const Region &region : owner.regions)
            sweep(region, &inside);
        forEachFlowOut(owner, follow);
    }

    Analysis &analysis_;
    bool changed_ = false;
};

/// The facts of a whole function, in the analysis.
template <typename Analysis> Analysis &solve(Analysis &analysis) {
    Dataflow<Analysis>(analysis).run(analysis.function.body);
    return analysis;
}

} // namespace candela::ir
