// SPDX-License-Identifier: Apache-2.0
#include "language/ir/analyse/affine.h"
#include "language/ir/analyse/opacity.h"
#include "language/ir/core/builder_fold.h"
#include "language/ir/core/op_info.h"
#include "language/ir/core/regions.h"
#include "language/ir/questions/answers.h"
#include "language/ir/questions/emission.h"
#include "language/ir/questions/questions.h"
#include "language/ir/transform/arrival.h"
#include "language/ir/transform/dead_code.h"
#include "language/ir/transform/late_loads.h"
#include "language/ir/transform/light_services.h"
#include "language/ir/transform/short_loops.h"

#include <algorithm>

namespace candela::ir {

namespace {

enum class Products : std::uint8_t { Fused, Apart };

/// A row of questions.def.
struct QuestionRow {
    const char *text;
    sl::ShaderKind kind;
    FrameUse reads, writes;
    Products products;
    Function (*ofText)(const Function &);
    Function (*ofPlan)(const Plan &);
};

constexpr QuestionRow row(const char *text, sl::ShaderKind kind, FrameUse reads, FrameUse writes,
                          Products products, Function (*answer)(const Function &)) {
    return {text, kind, reads, writes, products, answer, nullptr};
}
constexpr QuestionRow row(const char *text, sl::ShaderKind kind, FrameUse reads, FrameUse writes,
                          Products products, Function (*answer)(const Plan &)) {
    return {text, kind, reads, writes, products, nullptr, answer};
}

constexpr QuestionRow rows[] = {
#define QUESTION(name, text, kind, of, reads, writes, products, meaning)                           \
    row(text, sl::ShaderKind::kind, FrameUse::reads, FrameUse::writes, Products::products,         \
        answer##name),
#include "language/ir/questions/questions.def"
#undef QUESTION
};

const QuestionRow &rowOf(Question question) { return rows[int(question)]; }

} // namespace

const char *nameOf(Question question) { return rowOf(question).text; }
FrameUse framesReadBy(Question question) { return rowOf(question).reads; }
FrameUse framesWrittenBy(Question question) { return rowOf(question).writes; }
bool mayFuse(Question question) { return rowOf(question).products == Products::Fused; }

BindingTime lanesOf(Question question) {
    const FrameUse read = framesReadBy(question);
    return uses(read, BindingTime::View)      ? BindingTime::Response
           : uses(read, BindingTime::Surface) ? BindingTime::View
                                              : BindingTime::Surface;
}

std::vector<Question> questionsOf(sl::ShaderKind kind) {
    std::vector<Question> questions;
    for (int q = 0; q < questionCount; ++q)
        if (rows[q].kind == kind)
            questions.push_back(Question(q));
    return questions;
}

bool isPlanned(sl::ShaderKind kind) {
    return std::ranges::any_of(rows,
                               [&](const QuestionRow &r) { return r.kind == kind && r.ofPlan; });
}

static Function answerWhole(const Function &whole) {
    Function result = whole;
    removeAll(Op::EmissionCone, result.body);
    removeDeadCode(result);
    return result;
}

Function answerShade(const Function &whole) { return answerWhole(withoutDisplacement(whole)); }

/// Whoever asks what a shader leaves behind has heard what it says already.
Function answerOutputs(const Function &whole) {
    Function result = whole;
    keepOutputs(result, [](const OutputName &name) { return name.kind == OutputKind::Parameter; });
    removeAll(Op::Command, result.body);
    return answerWhole(result);
}

bool asksForLight(const Function &function) {
    return anyInstruction(function.body, [](const Instruction &i) {
        return i.op == Op::LightLoop || info(i.op).kind == OpClass::Light;
    });
}

Function answerLight(const Function &whole) { return answerWhole(whole); }

Function answerImager(const Function &whole) { return answerWhole(whole); }

Function answerVolume(const Function &whole) {
    Function result = answerWhole(whole);
    askServicesForLight(result);
    return result;
}

Function answerSegment(const Function &whole) { return affineParts(answerVolume(whole)); }

Function answerTransmission(const Function &whole) {
    Function parts = affineParts(answerVolume(silenced(whole)));
    keepOutputs(parts, [](const OutputName &name) { return name.kind == OutputKind::CiOfCi; });
    removeDeadCode(parts);
    return parts;
}

/// A filter gives nothing but its maps: output parameters have nowhere to go.
Function answerFilter(const Function &whole) {
    Function result = whole;
    removeAll(Op::Output, result.body);
    result.outputs.clear();
    return answerWhole(result);
}

Function answerEmit(const Plan &plan) {
    return specializeUnder(plan, {}, OutputKind::Ci, OutputKind::Ce);
}

Function answerOpacity(const Plan &plan) {
    return specializeUnder(plan, {}, OutputKind::Oi, OutputKind::Oi);
}

namespace {

std::vector<ConeSlot> coneSlots(const Plan &plan) {
    const std::vector<OutputSlot> outputs = prepareOutputs(plan);
    std::vector<ConeSlot> slots;
    for (int n = 0; n < int(plan.cones.size()); ++n) {
        slots.push_back(coneSlot(outputs, n, plan.cones[n].request));
        slots.back().exact = plan.cones[n].exact;
    }
    return slots;
}

/// The box that is asked about: where none is, the region that is sampled stands for it.
void takeSampledRegion(Function &function) {
    forEachInstruction(function.body, [](Instruction &i) {
        if (i.op != Op::Input)
            return;
        if (i.immediate == int(ShaderInput::Du))
            i.immediate = int(ShaderInput::du);
        else if (i.immediate == int(ShaderInput::Dv))
            i.immediate = int(ShaderInput::dv);
        else if (i.immediate == int(ShaderInput::Dw))
            i.op = Op::ConstFloat, i.immediate = 0;
    });
    markInputsRead(function);
}

Function named(Function function, const Function &whole, Question question) {
    if (question != Question::Bounds && question != Question::Furnace &&
        question != Question::LightBounds)
        takeSampledRegion(function);
    function.name = whole.name + "." + nameOf(question);
    function.lanes = lanesOf(question);
    loadLate(function);
    markShortLoops(function);
    return function;
}

/// Light decides about what a command says, or whether it stands in what is run.
bool dependsOnLight(const Plan &plan, const Instruction &command, const Enclosing *around) {
    const auto responds = [&](ValueId v) { return plan.dependence.responds(v); };
    if (std::ranges::any_of(command.operands, responds))
        return true;
    for (; around; around = around->outer)
        if (around->owner->op == Op::LightLoop ||
            std::ranges::any_of(around->owner->operands, responds))
            return true;
    return false;
}

int printsLightLine(const Plan &plan) {
    int line = 0;
    forEachEnclosed(plan.text.body, [&](const Instruction &i, const Enclosing *around) {
        if (line == 0 && i.op == Op::Command && dependsOnLight(plan, i, around))
            line = i.line;
    });
    return line;
}

bool hasLoops(const Plan &plan) {
    for (const Instruction *i : plan.dependence.request)
        if (i && i->op == Op::LightLoop)
            return true;
    return false;
}

} // namespace

Function silenced(Function function) {
    removeAll(Op::Command, function.body);
    removeDeadCode(function);
    return function;
}

Function slice(const Plan &plan, Question question) {
    const QuestionRow &asked = rowOf(question);
    return named(asked.ofPlan ? asked.ofPlan(plan) : asked.ofText(plan.whole), plan.whole,
                 question);
}

Function slice(const Function &whole, Question question) {
    const QuestionRow &asked = rowOf(question);
    return asked.ofText ? named(asked.ofText(whole), whole, question)
                        : slice(*makePlan(whole), question);
}

SurfaceFacts surfaceFacts(const Plan &plan) {
    SurfaceFacts facts;
    facts.cones = coneSlots(plan);
    facts.hasLoops = hasLoops(plan);
    facts.readsAmbient = plan.readsAmbient;
    facts.readsIrradiance = plan.readsIrradiance;
    for (bool emits : plan.emits)
        facts.emits |= emits;
    facts.opaqueIfOsIs1 = opaqueIfOsIs1(slice(plan, Question::Opacity));
    AffineProof proof = proveAffine(plan.whole);
    facts.affine = proof.affine;
    facts.notAffineLine = proof.line;
    facts.staticRequests = plan.dependence.staticRequests;
    facts.notStaticLine = plan.dependence.notStaticLine;
    facts.printsLightLine = printsLightLine(plan);
    return facts;
}

VolumeFacts volumeFacts(const Function &whole) {
    const Function text = answerVolume(whole);
    VolumeFacts facts;
    const ArrivalProof proof = proveAffineInArrival(text);
    facts.affine = proof.affine, facts.notAffineLine = proof.line;
    facts.asksForLight = std::ranges::any_of(text.services, [](const ServiceUse &use) {
        return use.info->service == Service::gatherlight;
    });
    const auto has = [&](Op op) {
        return anyInstruction(text.body, [op](const Instruction &i) { return i.op == op; });
    };
    facts.readsAmbient = has(Op::Ambient), facts.speaks = has(Op::Command);
    return facts;
}

SurfaceFacts surfaceFacts(const Function &whole) { return surfaceFacts(*makePlan(whole)); }

} // namespace candela::ir
