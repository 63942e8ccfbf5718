// SPDX-License-Identifier: Apache-2.0
// Variables are cells: every scalar component of a variable is a number in `cells`, whose entry is
// its present value. A branch lowers both sides from the same cells and yields those that differ;
// a loop carries those that its text assigns. Only arrays that are indexed by computed indices are
// memory.
#pragma once

#include "language/ir/lower/components.h"
#include "language/semantics/predefined.h"

#include <algorithm>
#include <map>
#include <set>
#include <vector>

namespace candela::ir {

/// Where a variable lives.
struct Storage {
    sl::BaseType base = sl::BaseType::Float;
    int length = 0;  ///< 0 = a single value.
    int cell = -1;   ///< Its first cell; -1 if it is memory alone.
    int memory = -1; ///< First of Function::arrays, one a component.
    int width = 1;   ///< Scalars of one element.

    /// Scalars of all elements.
    int size() const { return width * std::max(1, length); }
};

class Variables {
public:
    /// Emits loads and stores of what is in memory. Arrays that are `fixed` have cells beside it.
    Variables(Builder &b, std::set<const sl::Symbol *> inMemory,
              std::set<const sl::Symbol *> fixed);

    /// The present values.
    std::vector<ValueId> cells;
    /// Gives the first of the cells that get the values.
    int newCells(const Components &values);
    /// What stands in a row of cells.
    Components inCells(int first, int count) const;
    void setCells(int first, const Components &values);
    Components inCells(const std::vector<int> &list) const;
    /// Passes over cells that are gone.
    void setCells(const std::vector<int> &list, const Components &values);

    /// How many loops are open: what they declare begins anew in each turn.
    int openLoops = 0;
    const Storage &declare(const sl::Symbol &, const Components &initial);
    /// What no text has declared yet (a default may name a later parameter) is zero.
    const Storage &storageOf(const sl::Symbol &);
    /// The symbol is another name of what is stored there.
    void bind(const sl::Symbol &symbol, const Storage &storage) { storage_[&symbol] = storage; }
    Components load(const Storage &);
    void store(const Storage &, const Components &);

    void declarePredefined(sl::PredefinedId, sl::BaseType, const Components &initial);
    const Storage &predefined(sl::PredefinedId id) const { return predefined_.at(id); }
    Components load(sl::PredefinedId id) { return load(predefined(id)); }
    void store(sl::PredefinedId id, const Components &value) { store(predefined(id), value); }

    /// Adds the cells of a variable that a loop carries to those that it carries already.
    void appendCells(const sl::Symbol &, std::vector<int> &carried) const;

private:
    void fill(const Storage &, const Components &initial);

    Builder &b_;
    std::map<const sl::Symbol *, Storage> storage_;
    std::map<sl::PredefinedId, Storage> predefined_;
    std::set<const sl::Symbol *> inMemory_, fixed_;
};

} // namespace candela::ir
