// SPDX-License-Identifier: Apache-2.0
#include "language/ir/transform/fold.h"

#include "language/ir/core/regions.h"
#include "language/ir/transform/dead_code.h"
#include "language/ir/transform/specialize.h"

#include <map>
#include <optional>

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

/// Nothing if it becomes too large, which it does not unless loops are unrolled.
std::optional<Function> rewrite(const Function &text, const Dependence &dependence, bool unrolls) {
    Function result = emptyLike(text);
    result.outputs = text.outputs;
    result.requests.clear();
    Builder b(result, unrolls ? Budget(mostInstructions) : Budget());
    SpecializationOptions options;
    options.prints = options.renumbers = true;
    options.unrolls = unrolls;
    SpecializedText specialized =
        specialize(text, dependence, b, {{Assumption::Light::Given, true, nullptr}}, options);
    writeOutputs(specialized, text, b);
    b.finish();
    if (b.budget().exceeded())
        return {};
    removeDeadCode(result);
    return result;
}

} // namespace

Function fold(const Function &whole, const std::vector<FoldedValue> &values) {
    const bool loops =
        anyInstruction(whole.body, [](const Instruction &i) { return i.op == Op::Loop; });
    if (values.empty() && !loops)
        return whole;
    std::map<int, float> bySlot;
    for (const FoldedValue &value : values)
        bySlot[value.slot] = value.value;
    Function text = whole;
    replaceParameters(text, bySlot);
    removeDeadCode(text);
    Dependence dependence = analyzeDependence(text);
    if (auto unrolled = rewrite(text, dependence, true))
        return std::move(*unrolled);
    return *rewrite(text, dependence, false);
}

Function foldAll(const Function &whole, const std::vector<float> &block) {
    std::vector<FoldedValue> values;
    for (int slot = 0; slot < int(block.size()); ++slot)
        values.push_back({slot, block[std::size_t(slot)]});
    return fold(whole, values);
}

} // namespace candela::ir
