// SPDX-License-Identifier: Apache-2.0
// Writes IR functions: infers types and uniformity, pools constants, folds what can be folded
// without changing a bit of any result, and reuses values that stand already.
//
// The builder itself knows only instructions and regions; what one writes with it are functions
// by subject: builder_sources.h (constants, inputs), builder_arithmetic.h, builder_vectors.h,
// builder_control.h, builder_light.h, builder_effects.h (arrays, outputs),
// builder_services.h.
//
//     Builder b(function);
//     Values lit = lightLoop(b, request, position, cones, {number(b, 0)},
//                            [&](const Triple &L, const Values &Cl, const Values &carried) {
//         return Values{add(b, carried[0], mul(b, Cl[0], dot(b, N, L)))};
//     });
//     output(b, "Ci", 0, lit[0]);
//     b.finish();
#pragma once

#include "language/ir/core/budget.h"
#include "language/ir/core/constant_pool.h"
#include "language/ir/core/ir.h"
#include "language/ir/core/unit_vectors.h"

#include <array>
#include <functional>
#include <string>
#include <unordered_map>
#include <vector>

namespace candela::ir {

using Values = std::vector<ValueId>;
/// A point, vector, normal or color, component by component.
using Triple = std::array<ValueId, 3>;
/// Row-major as the RI has it: a row vector times the matrix; element [4 * row + column].
using Matrix = std::array<ValueId, 16>;

/// The index of a string in one of the function's tables, which gets it if it has it not.
int intern(std::vector<std::string> &table, const std::string &);

class Builder {
public:
    /// Appends to the function's body. finish() must be called before the function is used.
    explicit Builder(Function &, Budget = Budget());
    Builder(const Builder &) = delete;
    Builder &operator=(const Builder &) = delete;

    /// Puts the constants at the body's head and infers uniformity once more (a loop may have made
    /// its carried values varying after they were used). Nothing may be added after it.
    void finish();

    Function &function() { return function_; }
    const ColorBasis &colors() const { return function_.colors; }
    Type type(ValueId v) const { return function_.values[v].type; }
    /// What is known so far; a loop's carried values may turn out varying later.
    Uniformity uniformity(ValueId v) const { return function_.values[v].uniformity; }
    /// The instruction that defines a constant value, null for others: for callers that decide at
    /// compile time. Valid until the next constant is made.
    const Instruction *constant(ValueId v) const { return constants_.find(v); }

    /// What may still be written. Once it is exceeded nothing is: the function is of no use.
    const Budget &budget() const { return budget_; }

    /// The source line that following instructions belong to.
    void setLine(int line) { place_.line = line; }
    int line() const { return place_.line; }
    /// The source file (into Function::files) of array accesses and loops, for messages at run
    /// time.
    void setFile(int file) { place_.file = file; }
    int file() const { return place_.file; }

    /// The results of any operation but those with regions: folds, reuses, infers.
    Values emit(Op, const Values &operands, int immediate = 0, float number = 0);
    /// Adds an instruction as it is (its regions built elsewhere); gives nothing new.
    void append(Instruction);
    /// Builds a region apart, to be given to append(). Values made in it are visible only there.
    Region region(const Values &arguments, const std::function<Values()> &body);
    ValueId newValue(Type t, Uniformity r) { return function_.addValue(t, r); }
    /// The number of the next call site of random numbers.
    int nextRandom() { return randoms_++; }

    /// What is known of lengths; emit() takes note of what it makes.
    UnitVectors unitVectors;

private:
    /// A pure operation.
    struct Key {
        Op op;
        int immediate;
        std::uint32_t number; ///< Its bits.
        Values operands;
        bool operator==(const Key &) const = default;
    };
    struct KeyHash {
        std::size_t operator()(const Key &) const;
    };
    struct Scope {
        Region *region;
        std::vector<Key> known; ///< What was first computed in it.
    };

    struct Place {
        int line = 0, file = 0;
    };

    Function &function_;
    std::vector<Scope> scopes_;                      ///< The open regions, outermost first.
    std::unordered_map<Key, Values, KeyHash> known_; ///< Visible results, by what they are.
    ConstantPool constants_;
    Budget budget_;
    Place place_;
    int randoms_ = 0;
};

} // namespace candela::ir
