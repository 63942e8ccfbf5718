// SPDX-License-Identifier: Apache-2.0
#include "language/ir/core/builder_effects.h"

#include "language/ir/core/builder_sources.h"

namespace candela::ir {

int addArray(Builder &b, Type type, int size) {
    auto &arrays = b.function().arrays;
    arrays.push_back({type, Rate::Uniform, size});
    return int(arrays.size()) - 1;
}
ValueId arrayLoad(Builder &b, int array, ValueId index) {
    return b.emit(Op::ArrayLoad, {index}, array)[0];
}
void arrayStore(Builder &b, int array, ValueId index, ValueId value) {
    b.emit(Op::ArrayStore, {index, value}, array);
}

void output(Builder &b, const std::string &slot, int component, ValueId value) {
    auto &slots = b.function().outputs;
    std::size_t index = 0;
    while (index < slots.size() &&
           (slots[index].name != slot || slots[index].component != component))
        ++index;
    if (index == slots.size())
        slots.push_back({slot, component});
    b.emit(Op::Output, {value}, int(index));
}

void printValues(Builder &b, const std::string &format, const Values &values) {
    Values operands{text(b, format)};
    operands.insert(operands.end(), values.begin(), values.end());
    b.emit(Op::Print, operands);
}

} // namespace candela::ir
