// SPDX-License-Identifier: Apache-2.0
#include "language/ir/questions/emission.h"

#include "language/ir/core/builder_effects.h"
#include "language/ir/questions/answers.h"
#include "language/ir/transform/dead_code.h"

namespace candela::ir {

namespace {

/// The planes that emissions' numbers go to, of each in the order of its operands.
std::vector<OutputSlot> emissionOutputs(const Function &whole) {
    std::vector<OutputSlot> slots;
    for (int n = 0; n < int(whole.emissions.size()); ++n)
        for (const OutputKind kind :
             {OutputKind::ConePosition, OutputKind::ConeAxis, OutputKind::ConeAngle,
              OutputKind::ConeExponent, OutputKind::ConeImportance})
            addOutputSlots(slots, {kind, n}, whole.colors.samples);
    return slots;
}

/// Puts outputs where the region states emissions.
void writeEmissions(Region &region, const std::vector<OutputSlot> &slots) {
    std::vector<Instruction> body;
    for (Instruction &i : region.body) {
        for (Region &inner : i.regions)
            writeEmissions(inner, slots);
        if (i.op != Op::EmissionCone) {
            body.push_back(std::move(i));
            continue;
        }
        const int first = slotOf(slots, {OutputKind::ConePosition, i.immediate});
        for (int k = 0; k < int(i.operands.size()); ++k)
            body.push_back({.op = Op::Output,
                            .operands = {i.operands[size_t(k)]},
                            .results = {},
                            .regions = {},
                            .immediate = first + k,
                            .line = i.line});
    }
    region.body = std::move(body);
}

} // namespace

ConeSlot coneSlot(const std::vector<OutputSlot> &outputs, int cone, int request) {
    const auto plane = [&](OutputKind kind) { return slotOf(outputs, {kind, cone}); };
    return {.request = request,
            .axis = plane(OutputKind::ConeAxis),
            .position = plane(OutputKind::ConePosition),
            .angle = plane(OutputKind::ConeAngle),
            .exponent = plane(OutputKind::ConeExponent),
            .importance = plane(OutputKind::ConeImportance)};
}

Function answerEmission(const Function &whole) {
    Function result = whole;
    removeAll(Op::Command, result.body);
    removeAll(Op::Output, result.body);
    result.outputs = emissionOutputs(whole);
    writeEmissions(result.body, result.outputs);
    removeDeadCode(result);
    return result;
}

LightFacts lightFacts(const Function &whole) {
    LightFacts facts;
    const Function emission = answerEmission(whole);
    for (int n = 0; n < int(whole.emissions.size()); ++n)
        facts.cones.push_back(coneSlot(emission.outputs, n, n));
    for (int plane = int(ShaderInput::Ps); plane <= int(ShaderInput::IsLast_); ++plane)
        facts.conesAreTheLights &= !emission.inputsRead[size_t(plane)];
    return facts;
}

} // namespace candela::ir
