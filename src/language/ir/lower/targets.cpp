// SPDX-License-Identifier: Apache-2.0
#include "language/ir/lower/targets.h"

#include "language/ir/core/builder_arithmetic.h"
#include "language/ir/core/builder_effects.h"
#include "language/ir/core/builder_sources.h"
#include "language/ir/lower/expression.h"
#include "language/ir/lower/place_scope.h"

namespace candela::ir {

Target resolve(Lowering &lowering, const sl::Expr &expr) {
    if (expr.kind == sl::ExprKind::Variable)
        return {
            .storage = lowering.variables.storageOf(*expr.symbol), .element = {}, .component = {}};
    Target target = resolve(lowering, *expr.operands[0]);
    const ValueId index = evaluateFloat(lowering, *expr.operands[1]);
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
        lowering.messages.error(where, "the index " + std::to_string(int(wanted)) +
                                           " is outside the array, which has " +
                                           std::to_string(storage.length) +
                                           " elements, counted from 0");
        return 0;
    }
    return int(wanted);
}

/// A computed index as an integer. NaN is outside every array.
ValueId computedIndex(Builder &b, ValueId index) {
    return select(b, equal(b, index, index), unary(b, Op::IntegerFromFloat, index), integer(b, -1));
}

} // namespace

Components load(Lowering &lowering, const Target &target, const sl::Place &where) {
    Builder &b = lowering.b;
    const Storage &storage = target.storage;
    const int width = storage.width;
    Components value;
    const bool isKnown =
        storage.cell >= 0 && target.element && constantFloat(b, *target.element) != nullptr;
    if (!target.element) {
        value = lowering.variables.load(storage);
    } else if (storage.memory >= 0 && !isKnown) {
        const ValueId index = computedIndex(b, *target.element);
        const PlaceScope place(b, where);
        for (int c = 0; c < width; ++c)
            value.push_back(arrayLoad(b, storage.memory + c, index));
    } else {
        const int element = elementIndex(lowering, storage, *target.element, where);
        value = lowering.variables.inCells(storage.cell + element * width, width);
    }
    if (target.component)
        return {component(b, value, *target.component)};
    return value;
}

void store(Lowering &lowering, const Target &target, const Components &value,
           const sl::Place &where) {
    Builder &b = lowering.b;
    if (target.component) {
        Target whole = target;
        whole.component.reset();
        const Components old = load(lowering, whole, where);
        store(lowering, whole, replaceComponent(b, old, *target.component, value[0]), where);
        return;
    }
    const Storage &storage = target.storage;
    const int width = storage.width;
    if (!target.element) {
        lowering.variables.store(storage, value);
    } else if (storage.memory >= 0) {
        const ValueId index = computedIndex(b, *target.element);
        const PlaceScope place(b, where);
        for (int c = 0; c < width; ++c)
            arrayStore(b, storage.memory + c, index, value[c]);
    } else {
        const int element = elementIndex(lowering, storage, *target.element, where);
        lowering.variables.setCells(storage.cell + element * width, value);
    }
}

} // namespace candela::ir
