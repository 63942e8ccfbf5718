// SPDX-License-Identifier: Apache-2.0
// Values of the interpreter: those of one lane.
#pragma once

#include "foundation/units/color.h"
#include "language/ir/core/ir.h"

#include <array>
#include <cstdint>
#include <vector>

namespace candela::ir {

/// A value of any type; bools are integers 0 and 1, strings indices into Function::strings.
union Cell {
    float number;
    std::int32_t integer;
};

using Vector = std::array<float, 3>;

/// As many samples as the function's colours have; zero beyond.
using Color = std::array<float, maximumColorSamples>;

/// The values of a lane, by ValueId.
class Cells {
public:
    explicit Cells(std::size_t count) : cells_(count) {}

    Cell &operator[](ValueId v) { return cells_[v]; }
    float number(ValueId v) const { return cells_[v].number; }
    int integer(ValueId v) const { return cells_[v].integer; }
    bool truth(ValueId v) const { return cells_[v].integer != 0; }
    /// Of three operands in a row.
    Vector vector(const Instruction &i, int first) const {
        return {number(i.operands[first]), number(i.operands[first + 1]),
                number(i.operands[first + 2])};
    }

    void set(const Instruction &i, float x) { cells_[i.results[0]].number = x; }
    void setInteger(const Instruction &i, int x) { cells_[i.results[0]].integer = x; }
    /// All results, as many as there are.
    void setAll(const Instruction &i, const float *x) {
        for (ValueId v : i.results)
            cells_[v].number = *x++;
    }
    /// Copies as one step: no target is read after it was written.
    void copy(const std::vector<ValueId> &from, const std::vector<ValueId> &to) {
        std::vector<Cell> kept;
        for (std::size_t k = 0; k < to.size(); ++k)
            kept.push_back(cells_[from[k]]);
        for (std::size_t k = 0; k < to.size(); ++k)
            cells_[to[k]] = kept[k];
    }

private:
    std::vector<Cell> cells_;
};

} // namespace candela::ir
