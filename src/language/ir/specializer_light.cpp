// SPDX-License-Identifier: Apache-2.0
// The specializer where the text asks for light.
#include "foundation/units/color.h"
#include "language/ir/builder_arithmetic.h"
#include "language/ir/builder_control.h"
#include "language/ir/builder_effects.h"
#include "language/ir/builder_light.h"
#include "language/ir/builder_sources.h"
#include "language/ir/builder_vectors.h"
#include "language/ir/specializer.h"

namespace candela::ir {

void Specializer::walkAnswer(const Instruction &i, Range range) {
    if (range.last < Stage::Response)
        return;
    if (i.op == Op::Answer && telling_.cones && active_[0] == 0)
        stateCones(i);
    for (int h : active_) {
        const Hypothesis &hypothesis = hypotheses_[h];
        bool isAnswer = i.op == Op::Answer;
        bool given = isAnswer ? hypothesis.light == Hypothesis::Light::Given : hypothesis.ambient;
        if (given) {
            Values results = b_.emit(i.op, valuesOf(h, i.operands),
                                     isAnswer ? requestFor(i.immediate) : i.immediate);
            for (std::size_t k = 0; k < i.results.size(); ++k)
                assign(h, i.results[k], results[k]);
            continue;
        }
        ValueId light = number(b_, 0);
        if (isAnswer && hypothesis.light == Hypothesis::Light::Sampled)
            light = unary(b_, Op::FloatFromBool, b_.emit(Op::AnsweredRequest, {}, i.immediate)[0]);
        if (isAnswer && hypothesis.probe && hypothesis.probe->request == i.immediate)
            light = number(b_, 1);
        for (ValueId v : i.results)
            assign(h, v, light);
    }
}

int Specializer::requestFor(int request) {
    return telling_.renumbers ? addRequest(b_, text_.requests[request]) : request;
}

void Specializer::walkLightLoop(const Instruction &i, Range range) {
    // What the body computes without looking at the light is computed once, before.
    if (telling_.framed && loopDepth_ == 0 && range.first < Stage::Response)
        walk(i.regions[0], {range.first, std::min(range.last, Stage::View)});
    if (range.last < Stage::Response)
        return;
    if (telling_.cones && active_[0] == 0)
        stateCones(i);
    for (int h : active_) {
        Values results = lightLoopUnder(h, i);
        for (std::size_t k = 0; k < i.results.size(); ++k)
            assign(h, i.results[k], results[k]);
    }
}

Values Specializer::lightLoopUnder(int h, const Instruction &i) {
    switch (hypotheses_[h].light) {
    case Hypothesis::Light::Given: return givenLoop(h, i);
    case Hypothesis::Light::Sampled: return sampledLoop(h, i);
    case Hypothesis::Light::Probed: return probedLoop(h, i);
    default: break;
    }
    std::size_t fixed = i.operands.size() - i.results.size();
    return valuesOf(h, {i.operands.begin() + fixed, i.operands.end()});
}

Values Specializer::givenLoop(int h, const Instruction &i) {
    const Region &region = i.regions[0];
    std::size_t fixed = i.operands.size() - i.results.size();
    Triple position = triple(h, {i.operands[0], i.operands[1], i.operands[2]});
    Values cones = valuesOf(h, {i.operands.begin() + 3, i.operands.begin() + fixed});
    Values initial = valuesOf(h, {i.operands.begin() + fixed, i.operands.end()});
    auto all = active_;
    Values results = lightLoop(b_, requestFor(i.immediate), position, cones, initial,
                               [&](const Triple &L, const Values &Cl, const Values &carried) {
                                   Values now(L.begin(), L.end());
                                   now.insert(now.end(), Cl.begin(), Cl.end());
                                   now.insert(now.end(), carried.begin(), carried.end());
                                   for (std::size_t k = 0; k < now.size(); ++k)
                                       assign(h, region.arguments[k], now[k]);
                                   active_ = {h};
                                   walk(region, {telling_.first, Stage::Response});
                                   return valuesOf(h, region.yields);
                               });
    active_ = all;
    return results;
}

/// One turn of the loop's body, with unit light from Input sampleL where it reaches.
Values Specializer::sampledLoop(int h, const Instruction &i) {
    const Region &region = i.regions[0];
    std::size_t fixed = i.operands.size() - i.results.size();
    Values initial = valuesOf(h, {i.operands.begin() + fixed, i.operands.end()});
    Triple L = input3(b_, ShaderInput::sampleL);
    for (int k = 0; k < 3; ++k)
        assign(h, region.arguments[k], L[k]);
    for (int k = 0; k < colorSamples; ++k)
        assign(h, region.arguments[3 + k], number(b_, 1));
    for (std::size_t k = 0; k < initial.size(); ++k)
        assign(h, region.arguments[3 + colorSamples + k], initial[k]);
    auto all = active_;
    active_ = {h};
    Values results = ifElse(
        b_, sampleReaches(h, i),
        [&] {
            walk(region, {telling_.framed ? Stage::Response : telling_.first, Stage::Response});
            return valuesOf(h, region.yields);
        },
        [&] { return initial; });
    active_ = all;
    return results;
}

ValueId Specializer::sampleReaches(int h, const Instruction &i) {
    const LightRequest &request = text_.requests[i.immediate];
    ValueId finite = b_.emit(Op::AnsweredRequest, {}, finiteRequests)[0];
    if (request.category >= 0)
        finite = both(b_, finite, b_.emit(Op::CategoryAccepts, {}, request.category)[0]);
    if (request.form == ConeForm::Extended && request.coneCount > 0) {
        ValueId isDelta = lessEqual(b_, value(h, i.operands[6]), number(b_, 0));
        return select(b_, isDelta, b_.emit(Op::AnsweredRequest, {}, i.immediate)[0], finite);
    }
    if (request.form != ConeForm::Classic)
        return finite;
    const Cull &cull = (*telling_.culls)[i.immediate];
    Triple direction = normalize(b_, input3(b_, ShaderInput::sampleL));
    ValueId cosine = dot(b_, direction, triple(h, cull.axis));
    return both(b_, finite, lessEqual(b_, value(h, cull.cosine), cosine));
}

/// The loop's results as if the probed cone had brought a unit of light.
Values Specializer::probedLoop(int h, const Instruction &i) {
    std::size_t fixed = i.operands.size() - i.results.size();
    Values results = valuesOf(h, {i.operands.begin() + fixed, i.operands.end()});
    const Cone &probe = *hypotheses_[h].probe;
    if (probe.request != i.immediate)
        return results;
    for (const Cone::Weight &weight : probe.weights) {
        ValueId contribution = number(b_, 1);
        for (ValueId factor : weight.factors)
            contribution = mul(b_, contribution, value(h, factor));
        results[weight.result] = add(b_, results[weight.result], contribution);
    }
    return results;
}

void Specializer::stateCones(const Instruction &i) {
    for (std::size_t n = 0; n < telling_.cones->size(); ++n) {
        const Cone &cone = (*telling_.cones)[n];
        if (cone.request != i.immediate)
            continue;
        StatedCone stated = stateCone(*this, b_, i, cone);
        std::string name = "cone " + std::to_string(n);
        for (int k = 0; k < 3; ++k)
            ir::output(b_, name + " axis", k, stated.axis[k]);
        ir::output(b_, name + " angle", 0, stated.angle);
        ir::output(b_, name + " exponent", 0, stated.exponent);
        if (stated.importance)
            ir::output(b_, name + " importance", 0, *stated.importance);
    }
}

} // namespace candela::ir
