// SPDX-License-Identifier: Apache-2.0
#include "language/ir/transform/light_rule.h"

#include "foundation/units/color.h"
#include "language/ir/core/builder.h"
#include "language/ir/core/builder_arithmetic.h"
#include "language/ir/core/builder_light.h"
#include "language/ir/core/builder_sources.h"
#include "language/ir/core/builder_vectors.h"
#include "language/ir/core/regions.h"

#include <iterator>
#include <numbers>

namespace candela::ir {

namespace {

struct Asks {
    bool loops = false, ambient = false, irradiance = false;
};

Asks asksOf(const Function &function) {
    Asks asks;
    forEachInstruction(function.body, [&](const Instruction &i) {
        asks.loops |= i.op == Op::LightLoop;
        asks.ambient |= i.op == Op::Ambient;
        asks.irradiance |= i.op == Op::Irradiance;
    });
    return asks;
}

/// The sum over all light of Cl (N.L), on the side that is seen.
Values gatheredLight(Builder &b) {
    LightRequest request;
    request.form = ConeForm::Classic;
    request.coneCount = 1;
    Triple N = normalize(b, input3(b, ShaderInput::N));
    N = faceforward(b, N, input3(b, ShaderInput::I), N);
    Values cone(N.begin(), N.end());
    cone.push_back(number(b, std::numbers::pi_v<float> / 2));
    return lightLoop(b, addRequest(b, request), input3(b, ShaderInput::P), cone,
                     Values(b.colors().samples, number(b, 0)),
                     [&](const LoopLight &light, const Values &carried) {
                         ValueId cosine = dot(b, N, normalize(b, light.L));
                         Values sum;
                         for (int k = 0; k < b.colors().samples; ++k)
                             sum.push_back(add(b, carried[k], mul(b, light.Cl[k], cosine)));
                         return sum;
                     });
}

/// After each `op`, adds `more` to what it gives.
void addTo(Op op, const Values &more, Function &function, Region &region) {
    std::vector<Instruction> body;
    for (Instruction &i : region.body) {
        for (Region &inner : i.regions)
            addTo(op, more, function, inner);
        std::vector<Instruction> sums;
        if (i.op == op)
            for (int k = 0; k < function.colors.samples; ++k) {
                ValueId own = function.addValue(Type::Float, Uniformity::Varying);
                sums.push_back({Op::Add, {own, more[k]}, {i.results[k]}, {}, 0, 0, i.line});
                i.results[k] = own;
            }
        body.push_back(std::move(i));
        std::move(sums.begin(), sums.end(), std::back_inserter(body));
    }
    region.body = std::move(body);
}

} // namespace

Function applyLightRule(const Function &whole, LightRule rule) {
    const Asks asks = asksOf(whole);
    if (rule == LightRule::Classic || asks.loops || (!asks.ambient && !asks.irradiance))
        return whole;
    Function result = whole;
    Region text = std::move(result.body);
    result.body = {};
    Builder b(result);
    Values light = gatheredLight(b);
    if (asks.irradiance)
        for (ValueId &v : light)
            v = mul(b, v, number(b, std::numbers::pi_v<float>));
    addTo(asks.irradiance ? Op::Irradiance : Op::Ambient, light, result, text);
    std::move(text.body.begin(), text.body.end(), std::back_inserter(result.body.body));
    b.finish();
    return result;
}

} // namespace candela::ir
