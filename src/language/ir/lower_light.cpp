// SPDX-License-Identifier: Apache-2.0
// illuminance, illuminate and solar (RI 3.2 section 12.5; the paper's sections 5.2 and 5.4).
#include "foundation/units/color.h"
#include "language/ir/builder_arithmetic.h"
#include "language/ir/builder_light.h"
#include "language/ir/builder_sources.h"
#include "language/ir/builder_vectors.h"
#include "language/ir/lower_internal.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace candela::ir {
namespace {

/// Of a float or a color, as the importance of a cone.
ValueId luminanceOf(Builder &b, const Components &value) {
    if (value.size() == 1)
        return value[0];
    ValueId sum = mul(b, value[0], number(b, luminanceWeights[0]));
    for (int c = 1; c < colorSamples; ++c)
        sum = add(b, sum, mul(b, value[c], number(b, luminanceWeights[c])));
    return sum;
}

struct ConeValues {
    Triple axis;
    ValueId angle, exponent, importance;
};

/// All cones given, evaluated in the order of the text; those from `coneCount` on get importance 0
/// (or vanish, if the count is a constant).
std::vector<ConeValues> evaluateCones(Lowering &lowering, const sl::LightArguments &light) {
    Builder &b = lowering.b;
    const ValueId count = lowering.evaluateFloat(*light.coneCount);
    std::vector<ConeValues> cones;
    for (const sl::Cone &cone : light.cones) {
        ConeValues values;
        values.axis = tripleOf(lowering.evaluate(*cone.axis));
        values.angle = lowering.evaluateFloat(*cone.angle);
        values.exponent = lowering.evaluateFloat(*cone.exponent);
        values.importance = luminanceOf(b, lowering.evaluate(*cone.importance));
        const ValueId index = number(b, float(cones.size()));
        values.importance = select(b, less(b, index, count), values.importance, number(b, 0));
        cones.push_back(values);
    }
    if (const float *known = constantFloat(b, count)) {
        const float wanted = std::clamp(*known, 0.0f, float(cones.size()));
        cones.resize(wanted > 0 ? size_t(std::ceil(wanted)) : 0);
    }
    return cones;
}

/// Lowers a light statement's body once, with its own jumps.
void lowerBodyOf(Lowering &lowering, const sl::Stmt &statement) {
    const ValueId none = boolean(lowering.b, false);
    const int flags = lowering.newCells({none, none});
    lowering.frames.back().loops.push_back({&statement, flags, flags + 1});
    lowering.lower(statement.body);
    lowering.frames.back().loops.pop_back();
}

/// The cells that a light loop carries: what its body assigns, and the flags of its jumps.
std::vector<int> carriedCells(Lowering &lowering, const sl::Stmt &statement, int brokenCell) {
    const LoopEffects effects = loopEffects(statement);
    std::vector<int> carried;
    for (const sl::Symbol *symbol : effects.assigned)
        lowering.appendCells(*symbol, carried);
    const auto names = [](const std::vector<const sl::Stmt *> &list, const sl::Stmt *target) {
        return std::find(list.begin(), list.end(), target) != list.end();
    };
    if (names(effects.breaks, &statement))
        carried.push_back(brokenCell);
    const Frame &frame = lowering.frames.back();
    for (const OpenLoop &outer : frame.loops) {
        if (names(effects.breaks, outer.statement))
            carried.push_back(outer.broken);
        if (names(effects.continues, outer.statement))
            carried.push_back(outer.continued);
    }
    if (effects.returns) {
        carried.push_back(frame.returned);
        const int count = frame.function ? componentCount(frame.function->result.base) : 0;
        for (int i = 0; i < count; ++i)
            carried.push_back(frame.result + i);
    }
    return carried;
}

LightRequest describe(Lowering &lowering, const sl::LightArguments &light, int line) {
    LightRequest request;
    request.kind = LightRequest::Kind::Loop;
    request.form = ConeForm(light.form);
    request.line = line;
    if (light.category) {
        const ValueId name = lowering.evaluate(*light.category)[0];
        const std::string category =
            lowering.requiredText(name, light.category->where, "a light category");
        if (!category.empty())
            request.category = categoryIndex(lowering.b, category);
    }
    return request;
}

} // namespace

static_assert(int(ConeForm::Everywhere) == int(sl::ConeForm::Everywhere) &&
              int(ConeForm::Classic) == int(sl::ConeForm::Classic) &&
              int(ConeForm::Extended) == int(sl::ConeForm::Extended));

void Lowering::lowerIlluminance(const sl::Stmt &statement) {
    const sl::LightArguments &light = *statement.light;
    LightRequest request = describe(*this, light, statement.where.line);
    const Triple position = tripleOf(evaluate(*light.position));
    Components coneOperands;
    if (light.form == sl::ConeForm::Classic) {
        request.coneCount = 1;
        coneOperands = evaluate(*light.axis);
        coneOperands.push_back(evaluateFloat(*light.angle));
    } else if (light.form == sl::ConeForm::Extended) {
        for (const ConeValues &cone : evaluateCones(*this, light)) {
            ++request.coneCount;
            coneOperands.insert(coneOperands.end(), cone.axis.begin(), cone.axis.end());
            coneOperands.insert(coneOperands.end(), {cone.angle, cone.exponent, cone.importance});
        }
    }

    const std::vector<ValueId> before = cells;
    const int flags = newCells({boolean(b, false), boolean(b, false)});
    const int broken = flags, continued = flags + 1;
    const std::vector<int> carried = carriedCells(*this, statement, broken);
    Components initial;
    for (int cell : carried)
        initial.push_back(cells[cell]);
    const auto sample = [&](const Triple &L, const Components &Cl, const Components &arguments) {
        for (size_t i = 0; i < carried.size(); ++i)
            cells[carried[i]] = arguments[i];
        setPredefined(sl::PredefinedId::L, componentsOf(L));
        setPredefined(sl::PredefinedId::Cl, Cl);
        setPredefined(sl::PredefinedId::Ol, Components(colorSamples, number(b, 1)));
        frames.back().loops.push_back({&statement, broken, continued});
        whereLive([&] { lower(statement.body); });
        frames.back().loops.pop_back();
        Components yields;
        for (int cell : carried)
            yields.push_back(cells[cell]);
        return yields;
    };
    const Components results =
        lightLoop(b, addRequest(b, request), position, coneOperands, initial, sample);
    cells = before;
    for (size_t i = 0; i < carried.size(); ++i)
        if (carried[i] < int(cells.size()))
            cells[carried[i]] = results[i];
}

namespace {

/// Two directions that complete a unit vector to an orthonormal frame (Duff et al. 2017).
std::pair<Triple, Triple> frameAbout(Builder &b, const Triple &n) {
    const ValueId one = number(b, 1);
    const ValueId sign = select(b, less(b, n[2], number(b, 0)), number(b, -1), one);
    const ValueId a = div(b, number(b, -1), add(b, sign, n[2]));
    const ValueId c = mul(b, mul(b, n[0], n[1]), a);
    const Triple x{add(b, one, mul(b, mul(b, sign, mul(b, n[0], n[0])), a)), mul(b, sign, c),
                   neg(b, mul(b, sign, n[0]))};
    const Triple y{c, add(b, sign, mul(b, mul(b, n[1], n[1]), a)), neg(b, n[1])};
    return {x, y};
}

/// A direction of unit length, uniform within `angle` (radians) of the axis, by `xi` in [0,1) and
/// the second number of the input lightSample.
Triple directionInCone(Builder &b, const Triple &axis, ValueId angle, ValueId xi) {
    const Triple centre = normalize(b, axis);
    if (const float *known = constantFloat(b, angle); known && *known <= 0)
        return centre;
    const ValueId one = number(b, 1);
    const ValueId turn =
        mul(b, number(b, 2 * std::numbers::pi_v<float>), input(b, ShaderInput::lightSample, 1));
    const ValueId cosine =
        sub(b, one, mul(b, xi, sub(b, one, unary(b, Op::Cos, max(b, angle, number(b, 0))))));
    const ValueId sine = sqrt(b, sub(b, one, mul(b, cosine, cosine)));
    const auto [x, y] = frameAbout(b, centre);
    return add(b, scale(b, centre, cosine),
               add(b, scale(b, x, mul(b, sine, unary(b, Op::Cos, turn))),
                   scale(b, y, mul(b, sine, unary(b, Op::Sin, turn)))));
}

void openLight(Lowering &lowering, const Triple &L) {
    if (!lowering.lightDirection)
        lowering.lightDirection = L;
    lowering.setPredefined(sl::PredefinedId::L, componentsOf(L));
}

} // namespace

/// A local emitter: L runs from the light to Ps. Light leaves within the cone of the classic form
/// alone; the cones of the extended form say where to send it, and cull nothing.
void Lowering::lowerIlluminate(const sl::Stmt &statement) {
    lightClass = LightClass::Local;
    const sl::LightArguments &light = *statement.light;
    const Triple position = tripleOf(evaluate(*light.position));
    const Triple L = sub(b, tripleOf(predefined(sl::PredefinedId::Ps)), position);
    ValueId lit = boolean(b, true);
    if (light.form == sl::ConeForm::Classic) {
        const Triple axis = normalize(b, tripleOf(evaluate(*light.axis)));
        const ValueId angle = evaluateFloat(*light.angle);
        const ValueId cosine =
            unary(b, Op::Cos, min(b, angle, number(b, std::numbers::pi_v<float>)));
        lit = lessEqual(b, cosine, dot(b, axis, normalize(b, L)));
        if (const float *known = constantFloat(b, angle);
            known && *known >= std::numbers::pi_v<float>)
            lit = boolean(b, true);
    } else if (light.form == sl::ConeForm::Extended) {
        evaluateCones(*this, light);
    }
    openLight(*this, L);
    branch(
        lit, [&] { lowerBodyOf(*this, statement); }, [] {});
}

/// A distant emitter: the direction of its light is the axis, or one of the cone about it by
/// lightSample; without any arguments one of the sphere. Of several cones of the extended form
/// lightSample takes one, by importance.
void Lowering::lowerSolar(const sl::Stmt &statement) {
    if (lightClass == LightClass::Ambient)
        lightClass = LightClass::Distant;
    const sl::LightArguments &light = *statement.light;
    Triple axis = triple(b, 0, 0, 1);
    ValueId angle = number(b, std::numbers::pi_v<float>);
    ValueId xi = input(b, ShaderInput::lightSample, 0);
    if (light.form == sl::ConeForm::Classic) {
        axis = tripleOf(evaluate(*light.axis));
        angle = evaluateFloat(*light.angle);
    } else if (light.form == sl::ConeForm::Extended) {
        const std::vector<ConeValues> cones = evaluateCones(*this, light);
        const ValueId halfDegree = number(b, std::numbers::pi_v<float> / 360);
        ValueId total = number(b, 0);
        for (const ConeValues &cone : cones)
            total = add(b, total, cone.importance);
        const ValueId wanted = mul(b, xi, total);
        ValueId sum = number(b, 0);
        for (size_t i = 0; i < cones.size(); ++i) {
            const ValueId taken = i == 0 ? boolean(b, true) : lessEqual(b, sum, wanted);
            axis = select(b, taken, cones[i].axis, axis);
            angle = select(b, taken, mul(b, cones[i].angle, halfDegree), angle);
            xi = select(b, taken, div(b, sub(b, wanted, sum), cones[i].importance), xi);
            sum = add(b, sum, cones[i].importance);
        }
    }
    openLight(*this, directionInCone(b, axis, angle, xi));
    lowerBodyOf(*this, statement);
}

} // namespace candela::ir
