// SPDX-License-Identifier: Apache-2.0
#include "language/ir/transform/fold.h"

#include "language/ir/core/builder_effects.h"
#include "language/ir/core/regions.h"
#include "language/ir/transform/dead_code.h"
#include "language/ir/transform/specialize.h"

#include <map>

namespace candela::ir {

namespace {

void replaceParameters(Function &text, const std::map<int, float> &values) {
    forEachInstruction(text.body, [&](Instruction &i) {
        if (i.op != Op::Parameter)
            return;
        if (auto it = values.find(i.immediate); it != values.end()) {
            i.op = Op::ConstFloat;
            i.immediate = 0;
            i.number = it->second;
        }
    });
}

} // namespace

Function fold(const Function &whole, const std::vector<FoldedValue> &values) {
    std::map<int, float> bySlot;
    for (const FoldedValue &value : values)
        bySlot[value.slot] = value.value;
    Function text = whole;
    replaceParameters(text, bySlot);
    removeDeadCode(text);
    Dependence dependence = analyzeDependence(text);
    Function result = emptyLike(text);
    result.outputs = text.outputs;
    result.requests.clear();
    Builder b(result);
    SpecializationOptions options;
    options.prints = options.unrolls = options.renumbers = true;
    SpecializedText specialized =
        specialize(text, dependence, b, {{Assumption::Light::Given, true, nullptr}}, options);
    for (const OutputSlot &slot : text.outputs)
        if (auto v = specialized.output(0, slot.name, slot.component))
            output(b, slot.name, slot.component, *v);
    b.finish();
    removeDeadCode(result);
    return result;
}

} // namespace candela::ir
