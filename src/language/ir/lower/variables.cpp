// SPDX-License-Identifier: Apache-2.0
#include "language/ir/lower/variables.h"

#include "language/ir/core/builder_effects.h"
#include "language/ir/core/builder_sources.h"

namespace candela::ir {

Variables::Variables(Builder &b, std::set<const sl::Symbol *> inMemory)
    : b_(b), inMemory_(std::move(inMemory)) {}

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
            storage.memory = c == 0 ? array : storage.memory;
        }
        store(storage, {initial.begin(), initial.begin() + storage.size()});
    }
    return storage_[&symbol] = storage;
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
