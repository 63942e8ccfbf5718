// SPDX-License-Identifier: Apache-2.0
// Where texts move points to.
#include "language/ir/core/regions.h"
#include "language/ir/questions/answers.h"
#include "language/ir/transform/dead_code.h"
#include "language/ir/transform/jet.h"

#include <algorithm>
#include <array>
#include <span>

namespace candela::ir {

namespace {

/// The function with those outputs alone of which the test holds.
template <class Keeps> Function reduced(Function function, Keeps keeps) {
    keepOutputs(function, [&](const OutputName &name) { return keeps(name.kind); });
    removeDeadCode(function);
    return function;
}

bool isOfDisplacement(OutputKind kind) { return kind == OutputKind::P || kind == OutputKind::N; }

/// The function writes the input back as it was given.
bool returns(const Function &function, OutputKind kind, ShaderInput input) {
    std::vector<const Instruction *> source(function.values.size());
    bool same = true;
    forEachInstruction(function.body, [&](const Instruction &i) {
        for (ValueId v : i.results)
            source[v] = &i;
        if (i.op != Op::Output || function.outputs[size_t(i.immediate)].name.kind != kind)
            return;
        const Instruction *from = source[i.operands[0]];
        const int plane = int(input) + function.outputs[size_t(i.immediate)].component;
        same &= from && from->op == Op::Input && from->immediate == plane;
    });
    return same;
}

bool readsOtherSpaces(const Function &displace) {
    const std::span parameters(displace.parameters);
    for (const Op op : {Op::Space, Op::SpaceInverse})
        if (anyInstruction(displace.body, [&](const Instruction &i) { return i.op == op; }))
            return true;
    // "shader" is a hidden parameter, its matrices.
    if (anyInstruction(displace.body, [&](const Instruction &i) {
            return i.op == Op::Parameter && parameters[size_t(i.immediate)].name == "shader";
        }))
        return true;
    for (int plane = int(ShaderInput::I); plane <= int(ShaderInput::ELast_); ++plane)
        if (displace.inputsRead[size_t(plane)])
            return true;
    return false;
}

/// With the derivatives of P, if they are to be had. A surface shader's N is for its own eyes: the
/// moved surface has the normal that follows from P.
Function displaced(const Function &whole, SlopeReport &report) {
    const bool ofSurface = slotOf(whole.outputs, OutputKind::Ci) >= 0;
    Function result = silenced(reduced(whole, [ofSurface](OutputKind kind) {
        return kind == OutputKind::P || (kind == OutputKind::N && !ofSurface);
    }));
    report = addOutputSlopes(result, {Direction::U, Direction::V}, mostSlopeValues,
                             [](const OutputName &name) { return name.kind == OutputKind::P; });
    return result;
}

} // namespace

Function answerDisplace(const Function &whole) {
    return reduced(whole, [](OutputKind kind) { return kind == OutputKind::P; });
}

Function answerTransform(const Function &whole) { return reduced(whole, isOfDisplacement); }

Function answerDisplaced(const Function &whole) {
    SlopeReport report;
    return displaced(whole, report);
}

Function withoutDisplacement(Function whole) {
    return reduced(std::move(whole), [](OutputKind kind) { return !isOfDisplacement(kind); });
}

DisplacementFacts displacementFacts(const Function &whole) {
    DisplacementFacts facts;
    const Function text = reduced(whole, isOfDisplacement);
    facts.movesP = !returns(text, OutputKind::P, ShaderInput::P);
    facts.setsN = !returns(text, OutputKind::N, ShaderInput::N);
    if (!facts.movesP && !facts.setsN)
        return facts;
    SlopeReport report;
    facts.readsOtherSpaces = readsOtherSpaces(displaced(whole, report));
    facts.slopesKnown = !report.fault && report.held.empty();
    return facts;
}

} // namespace candela::ir
