// SPDX-License-Identifier: Apache-2.0
#include "language/ir/questions/emission.h"

#include "language/ir/transform/dead_code.h"

namespace candela::ir {

namespace {

/// The planes that one emission's nine numbers go to, in the order of its operands.
std::vector<OutputSlot> emissionOutputs(int emission, int colorSamples) {
    std::vector<OutputSlot> slots;
    for (const OutputKind kind :
         {OutputKind::ConePosition, OutputKind::ConeAxis, OutputKind::ConeAngle,
          OutputKind::ConeExponent, OutputKind::ConeImportance})
        for (int c = 0; c < componentsOf(kind, colorSamples); ++c)
            slots.push_back({{kind, emission}, c});
    return slots;
}

std::vector<OutputSlot> emissionOutputs(const Function &whole) {
    std::vector<OutputSlot> slots;
    for (int n = 0; n < int(whole.emissions.size()); ++n)
        for (const OutputSlot &slot : emissionOutputs(n, whole.colors.samples))
            slots.push_back(slot);
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

Function sliceEmission(const Function &whole) {
    Function result = whole;
    removeAll(Op::Print, result.body);
    removeAll(Op::Output, result.body);
    result.outputs = emissionOutputs(whole);
    writeEmissions(result.body, result.outputs);
    removeDeadCode(result);
    return result;
}

LightFacts lightFacts(const Function &whole) {
    LightFacts facts;
    const Function emission = sliceEmission(whole);
    for (int n = 0; n < int(whole.emissions.size()); ++n) {
        const auto plane = [&](OutputKind kind) { return slotOf(emission.outputs, {kind, n}); };
        facts.cones.push_back({.request = n,
                               .axis = plane(OutputKind::ConeAxis),
                               .position = plane(OutputKind::ConePosition),
                               .angle = plane(OutputKind::ConeAngle),
                               .exponent = plane(OutputKind::ConeExponent),
                               .importance = plane(OutputKind::ConeImportance)});
    }
    for (int c = 0; c < 3; ++c)
        facts.conesAreTheLights &= !emission.inputsRead[size_t(ShaderInput::Ps) + size_t(c)];
    return facts;
}

} // namespace candela::ir
