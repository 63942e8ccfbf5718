// SPDX-License-Identifier: Apache-2.0
// Walks over regions, and what control flow does with values: which go into a region and which
// come out of it.
#pragma once

#include "language/ir/core/ir.h"

#include <optional>
#include <span>

namespace candela::ir {

/// Visits the instructions in program order, an owner of regions before what stands in them.
/// `Body` is Region, const or not; whoever visits may change anything but the bodies' lengths.
template <typename Body, typename Visit> void forEachInstruction(Body &region, Visit &&visit) {
    for (auto &i : region.body) {
        visit(i);
        for (auto &inner : i.regions)
            forEachInstruction(inner, visit);
    }
}

/// Removes the instructions of which the test holds, which must have no results that are used.
template <typename Test> void removeInstructions(Region &region, Test &&test) {
    std::erase_if(region.body, test);
    for (Instruction &i : region.body)
        for (Region &inner : i.regions)
            removeInstructions(inner, test);
}

/// Whether the test holds of any instruction in the region.
template <typename Test> bool anyInstruction(const Region &region, Test &&test) {
    for (const Instruction &i : region.body) {
        if (test(i))
            return true;
        for (const Region &inner : i.regions)
            if (anyInstruction(inner, test))
                return true;
    }
    return false;
}

/// Instructions in the region and in all within it.
inline std::size_t instructionCount(const Region &region) {
    std::size_t count = 0;
    forEachInstruction(region, [&](const Instruction &) { ++count; });
    return count;
}

/// The instructions whose regions something stands in, from the innermost outward.
struct Enclosing {
    const Instruction *owner;
    const Enclosing *outer; ///< Null at the top level.
};

/// As forEachInstruction(), with what each instruction stands in.
template <typename Visit>
void forEachEnclosed(const Region &region, Visit &&visit, const Enclosing *around = nullptr) {
    for (const Instruction &i : region.body) {
        visit(i, around);
        const Enclosing inside{&i, around};
        for (const Region &inner : i.regions)
            forEachEnclosed(inner, visit, &inside);
    }
}

/// Operands before the values that a loop carries at first: a light loop's position and cones.
inline std::size_t fixedOperands(const Instruction &loop) {
    return loop.operands.size() - loop.results.size();
}
/// Arguments before the carried values: a light loop's L, Cl and number of the light.
inline std::size_t givenArguments(const Instruction &loop) {
    return loop.regions[0].arguments.size() - loop.results.size();
}
/// Of a light loop: which sample of Cl its k-th argument is; nothing if it is L or a number.
inline std::optional<int> sampleOfCl(const Function &function, std::size_t k) {
    const int sample = int(k) - 3;
    return sample >= 0 && sample < function.colors.samples ? std::optional(sample) : std::nullopt;
}
/// The k-th value that a Loop or LightLoop carries: at first, and in each turn.
inline ValueId initialOf(const Instruction &loop, std::size_t k) {
    return loop.operands[fixedOperands(loop) + k];
}
inline ValueId argumentOf(const Instruction &loop, std::size_t k) {
    return loop.regions[0].arguments[givenArguments(loop) + k];
}
/// What decides which region of an If runs, or whether a Loop goes on; nothing for a LightLoop.
inline std::optional<ValueId> conditionOf(const Instruction &owner) {
    switch (owner.op) {
    case Op::If: return owner.operands[0];
    case Op::Loop: return owner.regions[0].arguments[0];
    default: return std::nullopt;
    }
}

/// A value that is one of several others, by what control flow does.
struct ValueFlow {
    const Instruction &owner;
    std::size_t index; ///< Among the owner's results.
    ValueId to;
    std::span<const ValueId> from;
};

/// Into the regions: what a Loop or LightLoop carries is what it starts from or what it yields.
template <typename Visit> void forEachFlowIn(const Instruction &owner, Visit &&visit) {
    if (owner.op == Op::If)
        return;
    const std::vector<ValueId> &yields = owner.regions[0].yields;
    for (std::size_t k = 0; k < owner.results.size(); ++k) {
        const ValueId from[] = {initialOf(owner, k), k < yields.size() ? yields[k] : 0};
        visit(ValueFlow{owner, k, argumentOf(owner, k), {from, k < yields.size() ? 2u : 1u}});
    }
}

/// Out of the regions: an If gives what one of its regions yields, a Loop what it carried when it
/// ended, a LightLoop what it started from or what it yields.
template <typename Visit> void forEachFlowOut(const Instruction &owner, Visit &&visit) {
    for (std::size_t k = 0; k < owner.results.size(); ++k) {
        const ValueId result = owner.results[k];
        if (owner.op == Op::Loop) {
            const ValueId from[] = {argumentOf(owner, k)};
            visit(ValueFlow{owner, k, result, from});
        } else {
            const ValueId first =
                owner.op == Op::If ? owner.regions[0].yields[k] : initialOf(owner, k);
            const ValueId from[] = {first, owner.regions.back().yields[k]};
            visit(ValueFlow{owner, k, result, from});
        }
    }
}

} // namespace candela::ir
