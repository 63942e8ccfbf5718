// SPDX-License-Identifier: Apache-2.0
// Variables: where they live, how parts of them are read and assigned.
#include "foundation/units/color.h"
#include "language/ir/builder_arithmetic.h"
#include "language/ir/builder_effects.h"
#include "language/ir/builder_sources.h"
#include "language/ir/lower_internal.h"

#include <algorithm>

namespace candela::ir {

int componentCount(sl::BaseType base) {
    switch (base) {
    case sl::BaseType::Void: return 0;
    case sl::BaseType::Float:
    case sl::BaseType::String: return 1;
    case sl::BaseType::Color: return colorSamples;
    case sl::BaseType::Matrix: return 16;
    default: return 3;
    }
}

Triple tripleOf(const Components &c) { return {c[0], c[1], c[2]}; }

Matrix matrixOf(const Components &c) {
    Matrix result;
    std::copy_n(c.begin(), 16, result.begin());
    return result;
}

Components componentsOf(const Triple &t) { return {t.begin(), t.end()}; }
Components componentsOf(const Matrix &m) { return {m.begin(), m.end()}; }

int Lowering::newCells(const Components &values) {
    const int first = int(cells.size());
    cells.insert(cells.end(), values.begin(), values.end());
    return first;
}

Components Lowering::zero(sl::BaseType base, int length) {
    const int count = componentCount(base) * std::max(1, length);
    return Components(count, base == sl::BaseType::String ? text(b, "") : number(b, 0));
}

Storage Lowering::declare(const sl::Symbol &symbol, const Components &initial) {
    Storage storage{.base = symbol.type.base, .length = symbol.type.length};
    if (storage.length == 0 || !inMemory_.contains(&symbol)) {
        storage.cell = newCells(initial);
    } else {
        const int count = componentCount(storage.base);
        const Type type = storage.base == sl::BaseType::String ? Type::String : Type::Float;
        for (int c = 0; c < count; ++c) {
            const int array = addArray(b, type, storage.length);
            storage.memory = c == 0 ? array : storage.memory;
        }
        for (int i = 0; i < storage.length * count; ++i)
            arrayStore(b, storage.memory + i % count, integer(b, i / count), initial[i]);
    }
    bind(symbol, storage);
    return storage;
}

const Storage &Lowering::storageOf(const sl::Symbol &symbol) {
    if (!storage_.contains(&symbol))
        declare(symbol, zero(symbol.type.base, symbol.type.length));
    return storage_[&symbol];
}

Components Lowering::load(const Storage &storage) {
    const int count = componentCount(storage.base);
    const int total = count * std::max(1, storage.length);
    if (storage.memory < 0)
        return {cells.begin() + storage.cell, cells.begin() + storage.cell + total};
    Components result;
    for (int i = 0; i < total; ++i)
        result.push_back(arrayLoad(b, storage.memory + i % count, integer(b, i / count)));
    return result;
}

ValueId Lowering::component(const Components &value, ValueId index) {
    const int last = int(value.size()) - 1;
    if (const float *known = constantFloat(b, index))
        return value[*known >= 0 ? int(std::min(*known, float(last))) : 0];
    ValueId result = value[last];
    for (int i = last - 1; i >= 0; --i)
        result = select(b, less(b, index, number(b, float(i + 1))), value[i], result);
    return result;
}

Components Lowering::replaceComponent(Components value, ValueId index, ValueId replacement) {
    const int last = int(value.size()) - 1;
    if (const float *known = constantFloat(b, index)) {
        value[*known >= 0 ? int(std::min(*known, float(last))) : 0] = replacement;
        return value;
    }
    for (int i = 0; i <= last; ++i) {
        const ValueId notBelow =
            i == 0 ? boolean(b, true) : lessEqual(b, number(b, float(i)), index);
        const ValueId notAbove =
            i == last ? boolean(b, true) : less(b, index, number(b, float(i + 1)));
        value[i] = select(b, both(b, notBelow, notAbove), replacement, value[i]);
    }
    return value;
}

Target Lowering::resolve(const sl::Expr &expr) {
    if (expr.kind == sl::ExprKind::Variable)
        return {.storage = storageOf(*expr.symbol), .element = {}, .component = {}};
    Target target = resolve(*expr.operands[0]);
    const ValueId index = evaluateFloat(*expr.operands[1]);
    (expr.kind == sl::ExprKind::Element ? target.element : target.component) = index;
    return target;
}

namespace {

/// A constant index into an array of cells.
int elementIndex(Lowering &lowering, const Storage &storage, ValueId index,
                 const sl::Place &where) {
    const float *known = constantFloat(lowering.b, index);
    const float wanted = known ? *known : 0;
    if (!(wanted > -1 && wanted < float(storage.length))) {
        lowering.error(where, "the index " + std::to_string(int(wanted)) +
                                  " is outside the array, which has " +
                                  std::to_string(storage.length) + " elements, counted from 0");
        return 0;
    }
    return int(wanted);
}

/// A computed index as an integer. NaN is outside every array.
ValueId computedIndex(Builder &b, ValueId index) {
    return select(b, equal(b, index, index), unary(b, Op::IntegerFromFloat, index), integer(b, -1));
}

/// While it lives, what is emitted stands at the place: messages at run time name it.
class PlaceScope {
public:
    PlaceScope(Builder &b, const sl::Place &where) : b_(b), line_(b.line()) {
        b_.setLine(where.line);
        if (where.file)
            b_.setFile(intern(b_.function().files, where.file->name()));
    }
    ~PlaceScope() {
        b_.setLine(line_);
        b_.setFile(0);
    }
    PlaceScope(const PlaceScope &) = delete;
    PlaceScope &operator=(const PlaceScope &) = delete;

private:
    Builder &b_;
    int line_;
};

} // namespace

Components Lowering::load(const Target &target, const sl::Place &where) {
    const Storage &storage = target.storage;
    const int count = componentCount(storage.base);
    Components value;
    if (!target.element) {
        value = load(storage);
    } else if (storage.memory >= 0) {
        const ValueId index = computedIndex(b, *target.element);
        const PlaceScope place(b, where);
        for (int c = 0; c < count; ++c)
            value.push_back(arrayLoad(b, storage.memory + c, index));
    } else {
        const int element = elementIndex(*this, storage, *target.element, where);
        const auto first = cells.begin() + storage.cell + element * count;
        value.assign(first, first + count);
    }
    if (target.component)
        return {component(value, *target.component)};
    return value;
}

void Lowering::store(const Target &target, const Components &value, const sl::Place &where) {
    if (target.component) {
        Target whole = target;
        whole.component.reset();
        store(whole, replaceComponent(load(whole, where), *target.component, value[0]), where);
        return;
    }
    const Storage &storage = target.storage;
    const int count = componentCount(storage.base);
    if (target.element && storage.memory >= 0) {
        const ValueId index = computedIndex(b, *target.element);
        const PlaceScope place(b, where);
        for (int c = 0; c < count; ++c)
            arrayStore(b, storage.memory + c, index, value[c]);
    } else if (storage.memory >= 0) {
        for (int i = 0; i < int(value.size()); ++i)
            arrayStore(b, storage.memory + i % count, integer(b, i / count), value[i]);
    } else {
        const int element =
            target.element ? elementIndex(*this, storage, *target.element, where) : 0;
        std::copy(value.begin(), value.end(), cells.begin() + storage.cell + element * count);
    }
}

void Lowering::appendCells(const sl::Symbol &symbol, std::vector<int> &list) {
    const auto found = storage_.find(&symbol);
    if (found == storage_.end() || found->second.cell < 0)
        return;
    const Storage &storage = found->second;
    const int total = componentCount(storage.base) * std::max(1, storage.length);
    for (int cell = storage.cell; cell < storage.cell + total; ++cell)
        if (cell < int(cells.size()) && std::find(list.begin(), list.end(), cell) == list.end())
            list.push_back(cell);
}

void Lowering::setPredefined(sl::PredefinedId id, const Components &value) {
    store({.storage = predefined_.at(id), .element = {}, .component = {}}, value, shader.where);
}

} // namespace candela::ir
