// SPDX-License-Identifier: Apache-2.0
#include "language/ir/lower/variables.h"

#include "language/ir/core/builder_arithmetic.h"
#include "language/ir/core/builder_control.h"
#include "language/ir/core/builder_effects.h"
#include "language/ir/core/builder_sources.h"

#include <cmath>

namespace candela::ir {

Variables::Variables(Builder &b, std::set<const sl::Symbol *> inMemory,
                     std::set<const sl::Symbol *> fixed)
    : b_(b), inMemory_(std::move(inMemory)), fixed_(std::move(fixed)) {}

int Variables::newCells(const Components &values) {
    const int first = int(cells.size());
    cells.insert(cells.end(), values.begin(), values.end());
    return first;
}

Components Variables::inCells(int first, int count) const {
    return {cells.begin() + first, cells.begin() + first + count};
}

void Variables::setCells(int first, const Components &values) {
    std::copy(values.begin(), values.end(), cells.begin() + first);
}

Components Variables::inCells(const std::vector<int> &list) const {
    Components values;
    for (int cell : list)
        values.push_back(cells[cell]);
    return values;
}

void Variables::setCells(const std::vector<int> &list, const Components &values) {
    for (size_t i = 0; i < list.size(); ++i)
        if (list[i] < int(cells.size()))
            cells[list[i]] = values[i];
}

const Storage &Variables::declare(const sl::Symbol &symbol, const Components &initial) {
    Storage storage{.base = symbol.type.base,
                    .length = symbol.type.length,
                    .width = componentCount(b_, symbol.type.base)};
    if (storage.length == 0 || !inMemory_.contains(&symbol)) {
        storage.cell = newCells(initial);
    } else {
        const Type type = storage.base == sl::BaseType::String ? Type::String : Type::Float;
        for (int c = 0; c < storage.width; ++c) {
            const int array = addArray(b_, type, storage.length);
            b_.function().arrays[size_t(array)].loopDepth = openLoops;
            storage.memory = c == 0 ? array : storage.memory;
        }
        fill(storage, initial);
        if (fixed_.contains(&symbol))
            storage.cell = newCells(initial);
    }
    return storage_[&symbol] = storage;
}

/// Memory is zero at first. In a loop it has to be made so, which is a loop where it is long.
void Variables::fill(const Storage &storage, const Components &initial) {
    constexpr int mostStores = 16; // Of what is equal at the array's end.
    const int width = storage.width, length = storage.length;
    const auto at = [&](int element, int c) { return initial[size_t(element * width + c)]; };
    const auto isZero = [&](ValueId v) {
        const float *known = constantFloat(b_, v);
        return openLoops == 0 && known && *known == 0 && !std::signbit(*known);
    };
    const auto store = [&](int from, ValueId index) {
        for (int c = 0; c < width; ++c)
            if (!isZero(at(from, c)))
                arrayStore(b_, storage.memory + c, index, at(from, c));
    };
    int rest = length; // Elements from here on are as the last one.
    const auto last = initial.begin() + (length - 1) * width;
    while (rest > 0 && std::equal(last, last + width, initial.begin() + (rest - 1) * width))
        --rest;
    const bool clear = std::all_of(last, last + width, isZero);
    const bool loops = !clear && length - rest > mostStores;
    for (int element = 0; element < (loops || clear ? rest : length); ++element)
        store(element, integer(b_, element));
    if (!loops)
        return;
    loop(b_, {boolean(b_, true), number(b_, float(rest))}, [&](const Values &carried) {
        store(length - 1, unary(b_, Op::IntegerFromFloat, carried[1]));
        const ValueId next = add(b_, carried[1], number(b_, 1));
        return Values{less(b_, next, number(b_, float(length))), next};
    });
}

const Storage &Variables::storageOf(const sl::Symbol &symbol) {
    const auto found = storage_.find(&symbol);
    return found != storage_.end()
               ? found->second
               : declare(symbol, zero(b_, symbol.type.base, symbol.type.length));
}

Components Variables::load(const Storage &storage) {
    if (storage.memory < 0)
        return inCells(storage.cell, storage.size());
    const int width = storage.width;
    Components result;
    for (int i = 0; i < storage.size(); ++i)
        result.push_back(arrayLoad(b_, storage.memory + i % width, integer(b_, i / width)));
    return result;
}

void Variables::store(const Storage &storage, const Components &value) {
    if (storage.memory < 0)
        return setCells(storage.cell, value);
    const int width = storage.width;
    for (int i = 0; i < int(value.size()); ++i)
        arrayStore(b_, storage.memory + i % width, integer(b_, i / width), value[i]);
}

void Variables::declarePredefined(sl::PredefinedId id, sl::BaseType base,
                                  const Components &initial) {
    predefined_[id] = {.base = base, .cell = newCells(initial), .width = componentCount(b_, base)};
}

void Variables::appendCells(const sl::Symbol &symbol, std::vector<int> &carried) const {
    const auto found = storage_.find(&symbol);
    if (found == storage_.end() || found->second.cell < 0)
        return;
    const Storage &storage = found->second;
    for (int cell = storage.cell; cell < storage.cell + storage.size(); ++cell)
        if (cell < int(cells.size()) &&
            std::find(carried.begin(), carried.end(), cell) == carried.end())
            carried.push_back(cell);
}

} // namespace candela::ir
