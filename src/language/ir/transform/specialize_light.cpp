// SPDX-License-Identifier: Apache-2.0
// Where the text asks for light.
#include "foundation/units/color.h"
#include "language/ir/analyse/dependence.h"
#include "language/ir/core/builder_arithmetic.h"
#include "language/ir/core/builder_control.h"
#include "language/ir/core/builder_effects.h"
#include "language/ir/core/builder_light.h"
#include "language/ir/core/builder_sources.h"
#include "language/ir/core/builder_vectors.h"
#include "language/ir/core/regions.h"
#include "language/ir/transform/cone_values.h"
#include "language/ir/transform/specialization.h"

namespace candela::ir {

/// The integral of a power n of
/// the cosine, over pi, 2 / (n + 1). So the share of directions that a highlight gets goes by its
/// energy and not by its brightness; narrow ones would have too many.
ValueId energyOf(Specialization &s, int h, const Cone &cone) {
    if (cone.kind != Cone::Kind::Lobe || !cone.exponent)
        return number(s.b, 1);
    const ValueId scale = number(s.b, cone.exponentScale);
    const ValueId exponent = mul(s.b, s.mapping.value(h, *cone.exponent), scale);
    const ValueId one = number(s.b, 1);
    return div(s.b, number(s.b, 2), add(s.b, max(s.b, exponent, number(s.b, 0)), one));
}

namespace {

int requestFor(Specialization &s, int request) {
    return s.options.renumbers ? addRequest(s.b, s.text.requests[request]) : request;
}

void stateCones(Specialization &s, const Instruction &i) {
    for (std::size_t n = 0; n < s.options.cones->size(); ++n) {
        const Cone &cone = (*s.options.cones)[n];
        if (cone.request != i.immediate)
            continue;
        StatedCone stated = stateCone(s.mapping, s.b, i, cone);
        const auto state = [&](OutputKind kind, int component, ValueId v) {
            output(s.b, {kind, int(n)}, component, v);
        };
        for (int k = 0; k < 3; ++k)
            state(OutputKind::ConeAxis, k, stated.axis[k]);
        state(OutputKind::ConeAngle, 0, stated.angle);
        state(OutputKind::ConeExponent, 0, stated.exponent);
        if (stated.importance)
            state(OutputKind::ConeImportance, 0, *stated.importance);
    }
}

/// What a light loop carries at first.
Values initialOf(Specialization &s, int h, const Instruction &i) {
    return s.mapping.values(h, {i.operands.end() - i.results.size(), i.operands.end()});
}

Values givenLoop(Specialization &s, int h, const Instruction &i) {
    const Region &region = i.regions[0];
    std::size_t fixed = i.operands.size() - i.results.size();
    Triple position = s.mapping.triple(h, {i.operands[0], i.operands[1], i.operands[2]});
    Values cones = s.mapping.values(h, {i.operands.begin() + 3, i.operands.begin() + fixed});
    Values initial = initialOf(s, h, i);
    auto body = [&](const LoopLight &light, const Values &carried) {
        Values now(light.L.begin(), light.L.end());
        now.insert(now.end(), light.Cl.begin(), light.Cl.end());
        now.push_back(light.number);
        now.insert(now.end(), carried.begin(), carried.end());
        for (std::size_t k = 0; k < now.size(); ++k)
            s.mapping.assign(h, region.arguments[k], now[k]);
        s.under({h}, [&] { walk(s, region, {s.options.first, BindingTime::Response}); });
        return s.mapping.values(h, region.yields);
    };
    return lightLoop(s.b, requestFor(s, i.immediate), position, cones, initial, body);
}

ValueId sampleReaches(Specialization &s, int h, const Instruction &i) {
    const LightRequest &request = s.text.requests[i.immediate];
    ValueId finite = s.b.emit(Op::AnsweredRequest, {}, finiteRequests)[0];
    if (request.category >= 0)
        finite = both(s.b, finite, s.b.emit(Op::CategoryAccepts, {}, request.category)[0]);
    if (request.form == ConeForm::Extended && request.coneCount > 0) {
        ValueId isDelta = lessEqual(s.b, s.mapping.value(h, i.operands[6]), number(s.b, 0));
        return select(s.b, isDelta, s.b.emit(Op::AnsweredRequest, {}, i.immediate)[0], finite);
    }
    if (request.form != ConeForm::Classic)
        return finite;
    const ConeTest &test = (*s.options.coneTests)[i.immediate];
    Triple direction = normalize(s.b, input3(s.b, ShaderInput::sampleL));
    ValueId cosine = dot(s.b, direction, s.mapping.triple(h, test.axis));
    return both(s.b, finite, lessEqual(s.b, s.mapping.value(h, test.cosine), cosine));
}

/// One turn of the loop's body, with unit light from Input sampleL where it reaches.
Values sampledLoop(Specialization &s, int h, const Instruction &i) {
    const Region &region = i.regions[0];
    Values initial = initialOf(s, h, i);
    Triple L = input3(s.b, ShaderInput::sampleL);
    for (int k = 0; k < 3; ++k)
        s.mapping.assign(h, region.arguments[k], L[k]);
    for (int k = 0; k < s.text.colors.samples; ++k)
        s.mapping.assign(h, region.arguments[3 + k], number(s.b, 1));
    s.mapping.assign(h, region.arguments[3 + s.text.colors.samples], sampleLight(s.b));
    for (std::size_t k = 0; k < initial.size(); ++k)
        s.mapping.assign(h, argumentOf(i, k), initial[k]);
    auto body = [&] {
        BindingTime first = s.options.framed ? BindingTime::Response : s.options.first;
        s.under({h}, [&] { walk(s, region, {first, BindingTime::Response}); });
        return s.mapping.values(h, region.yields);
    };
    return ifElse(s.b, sampleReaches(s, h, i), body, [&] { return initial; });
}

/// The loop's results as if the probed cone had brought a unit of light.
Values probedLoop(Specialization &s, int h, const Instruction &i) {
    Values results = initialOf(s, h, i);
    const Cone &probe = *s.assumptions[h].probe;
    if (probe.request != i.immediate)
        return results;
    const ValueId energy = energyOf(s, h, probe);
    for (const Cone::Weight &weight : probe.weights) {
        ValueId contribution = energy;
        for (ValueId factor : weight.factors)
            contribution = mul(s.b, contribution, s.mapping.value(h, factor));
        results[weight.result] = add(s.b, results[weight.result], contribution);
    }
    return results;
}

Values lightLoopUnder(Specialization &s, int h, const Instruction &i) {
    switch (s.assumptions[h].light) {
    case Assumption::Light::Given: return givenLoop(s, h, i);
    case Assumption::Light::Sampled: return sampledLoop(s, h, i);
    case Assumption::Light::Probed: return probedLoop(s, h, i);
    case Assumption::Light::Field: return fieldLoop(s, h, i);
    default: return initialOf(s, h, i);
    }
}

} // namespace

void walkAnswer(Specialization &s, const Instruction &i, BindingTimes range) {
    if (range.last < BindingTime::Response)
        return;
    if (i.op == Op::Answer && s.options.cones && s.active[0] == 0)
        stateCones(s, i);
    for (int h : s.active) {
        const Assumption &assumption = s.assumptions[h];
        bool isAnswer = i.op == Op::Answer;
        bool given = isAnswer ? assumption.light == Assumption::Light::Given : assumption.ambient;
        if (given) {
            Values results = s.b.emit(i.op, s.mapping.values(h, i.operands),
                                      isAnswer ? requestFor(s, i.immediate) : i.immediate);
            for (std::size_t k = 0; k < i.results.size(); ++k)
                s.mapping.assign(h, i.results[k], results[k]);
            continue;
        }
        ValueId light = number(s.b, 0);
        if (isAnswer && assumption.light == Assumption::Light::Sampled)
            light =
                unary(s.b, Op::FloatFromBool, s.b.emit(Op::AnsweredRequest, {}, i.immediate)[0]);
        if (isAnswer && assumption.light == Assumption::Light::Field)
            light = number(s.b, 1);
        if (isAnswer && assumption.probe && assumption.probe->request == i.immediate)
            light = number(s.b, 1);
        for (ValueId v : i.results)
            s.mapping.assign(h, v, light);
    }
}

void walkLightLoop(Specialization &s, const Instruction &i, BindingTimes range) {
    // What the body computes without looking at the light is computed once, before.
    if (s.options.framed && s.loopDepth == 0 && range.first < BindingTime::Response)
        walkAhead(s, i.regions[0], {range.first, std::min(range.last, BindingTime::View)});
    if (range.last < BindingTime::Response)
        return;
    if (s.options.cones && s.active[0] == 0)
        stateCones(s, i);
    for (int h : s.active) {
        Values results = lightLoopUnder(s, h, i);
        for (std::size_t k = 0; k < i.results.size(); ++k)
            s.mapping.assign(h, i.results[k], results[k]);
    }
}

} // namespace candela::ir
