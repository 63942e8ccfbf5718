// SPDX-License-Identifier: Apache-2.0
#include "language/ir/core/builder_effects.h"

namespace candela::ir {

int addArray(Builder &b, Type type, int size) {
    auto &arrays = b.function().arrays;
    arrays.push_back({type, Uniformity::Uniform, size});
    return int(arrays.size()) - 1;
}
ValueId arrayLoad(Builder &b, int array, ValueId index) {
    return b.emit(Op::ArrayLoad, {index}, array)[0];
}
void arrayStore(Builder &b, int array, ValueId index, ValueId value) {
    b.emit(Op::ArrayStore, {index, value}, array);
}

std::size_t arrayNumbers(const Function &function) {
    std::size_t numbers = 0;
    for (const Array &array : function.arrays)
        numbers += std::size_t(array.size);
    return numbers;
}

void addOutputSlots(std::vector<OutputSlot> &slots, const OutputName &name, int colorSamples) {
    for (int k = 0; k < componentsOf(name.kind, colorSamples); ++k)
        slots.push_back(outputSlot(name, k));
}

OutputSlot outputSlot(const OutputName &name, int component) {
    return {name, component, valueWhenEnded(name.kind)};
}

void output(Builder &b, const OutputName &name, int component, ValueId value) {
    auto &slots = b.function().outputs;
    int slot = slotOf(slots, name, component);
    if (slot < 0) {
        slot = int(slots.size());
        slots.push_back(outputSlot(name, component));
    }
    b.emit(Op::Output, {value}, slot);
}

} // namespace candela::ir
