// SPDX-License-Identifier: Apache-2.0
#include "language/ir/lower/light.h"

#include "language/ir/core/builder_arithmetic.h"
#include "language/ir/core/builder_light.h"
#include "language/ir/core/builder_sources.h"
#include "language/ir/core/builder_vectors.h"
#include "language/ir/lower/color.h"
#include "language/ir/lower/cone_direction.h"
#include "language/ir/lower/control.h"
#include "language/ir/lower/expression.h"
#include "language/ir/lower/limits.h"
#include "language/ir/lower/statement.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace candela::ir {
namespace {

/// A cone of the text, angles in degrees.
struct ConeValues {
    Triple axis;
    ValueId angle, exponent, importance;
};

/// All cones given, evaluated in the order of the text; those from `coneCount` on get importance 0
/// (or vanish, if the count is a constant).
std::vector<ConeValues> evaluateCones(Lowering &lowering, const sl::LightArguments &light) {
    Builder &b = lowering.b;
    const ValueId count = evaluateFloat(lowering, *light.coneCount);
    std::vector<ConeValues> cones;
    for (const sl::Cone &cone : light.cones) {
        ConeValues values;
        values.axis = tripleOf(evaluate(lowering, *cone.axis));
        values.angle = evaluateFloat(lowering, *cone.angle);
        values.exponent = evaluateFloat(lowering, *cone.exponent);
        values.importance = luminanceOf(b, evaluate(lowering, *cone.importance));
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
    const int flags = lowering.variables.newCells({none, none});
    lowering.frames.back().loops.push_back({&statement, flags, flags + 1});
    lower(lowering, statement.body);
    lowering.frames.back().loops.pop_back();
}

/// What a light loop carries: as any loop, and the flag of its own breaks.
std::vector<int> cellsInOrder(const CarriedCells &parts, int broken) {
    std::vector<int> carried = parts.variables;
    if (parts.breaks)
        carried.push_back(broken);
    carried.insert(carried.end(), parts.flags.begin(), parts.flags.end());
    carried.insert(carried.end(), parts.results.begin(), parts.results.end());
    return carried;
}

LightRequest describe(Lowering &lowering, const sl::LightArguments &light, int line) {
    LightRequest request;
    request.kind = LightRequest::Kind::Loop;
    request.form = ConeForm(light.form);
    request.line = line;
    if (light.category) {
        const ValueId name = evaluate(lowering, *light.category)[0];
        const std::string category =
            requiredText(lowering, name, light.category->where, "a light category");
        if (!category.empty())
            request.category = categoryIndex(lowering.b, category);
    }
    return request;
}

/// The operands that say the cones, which the request counts.
Components describeCones(Lowering &lowering, const sl::LightArguments &light,
                         LightRequest &request) {
    Components operands;
    if (light.form == sl::ConeForm::Classic) {
        request.coneCount = 1;
        const Triple axis = tripleOf(evaluate(lowering, *light.axis));
        operands = componentsOf(normalize(lowering.b, axis));
        operands.push_back(evaluateFloat(lowering, *light.angle));
    } else if (light.form == sl::ConeForm::Extended) {
        for (const ConeValues &cone : evaluateCones(lowering, light)) {
            ++request.coneCount;
            operands.insert(operands.end(), cone.axis.begin(), cone.axis.end());
            operands.insert(operands.end(), {cone.angle, cone.exponent, cone.importance});
        }
    }
    return operands;
}

} // namespace

static_assert(int(ConeForm::Everywhere) == int(sl::ConeForm::Everywhere) &&
              int(ConeForm::Classic) == int(sl::ConeForm::Classic) &&
              int(ConeForm::Extended) == int(sl::ConeForm::Extended));

int addRequest(Lowering &lowering, const LightRequest &request, const sl::Place &where) {
    if (lowering.b.function().requests.size() == mostRequests) {
        lowering.messages.error(
            where, fmt::format("the shader asks for light too often; {} light loops, diffuse(), "
                               "specular(), phong() and trace() are the most, with those of each "
                               "call of a function; let one illuminance sum what several do",
                               mostRequests));
        lowering.messages.close();
    }
    return addRequest(lowering.b, request);
}

void lowerIlluminance(Lowering &lowering, const sl::Stmt &statement) {
    Builder &b = lowering.b;
    const sl::LightArguments &light = *statement.light;
    LightRequest request = describe(lowering, light, statement.where.line);
    const Triple position = tripleOf(evaluate(lowering, *light.position));
    const Components coneOperands = describeCones(lowering, light, request);
    Variables &variables = lowering.variables;
    const std::vector<ValueId> before = variables.cells;
    const ValueId none = boolean(b, false);
    const int broken = variables.newCells({none, none}), continued = broken + 1;
    const std::vector<int> carried = cellsInOrder(carriedCells(lowering, statement), broken);
    const Components initial = variables.inCells(carried);
    const auto sample = [&](const LoopLight &given, const Components &arguments) {
        variables.setCells(carried, arguments);
        variables.store(sl::PredefinedId::L, componentsOf(given.L));
        variables.store(sl::PredefinedId::Cl, given.Cl);
        const auto around = std::exchange(lowering.lightNumber, given.number);
        variables.store(sl::PredefinedId::Ol, Components(b.colors().samples, number(b, 1)));
        lowering.frames.back().loops.push_back({&statement, broken, continued});
        ++variables.openLoops;
        whereLive(lowering, [&] { lower(lowering, statement.body); });
        --variables.openLoops;
        lowering.frames.back().loops.pop_back();
        lowering.lightNumber = around;
        return variables.inCells(carried);
    };
    const Components results = lightLoop(b, addRequest(lowering, request, statement.where),
                                         position, coneOperands, initial, sample);
    variables.cells = before;
    variables.setCells(carried, results);
}

namespace {

bool isInLoop(const Lowering &lowering) {
    for (const Frame &frame : lowering.frames)
        for (const OpenLoop &loop : frame.loops)
            if (loop.statement->kind == sl::StmtKind::Loop)
                return true;
    return false;
}

ConeValues classicCone(Builder &b, const Triple &axis, ValueId halfAngle) {
    const ValueId degrees = mul(b, halfAngle, number(b, 360 / std::numbers::pi_v<float>));
    return {axis, min(b, degrees, number(b, 360)), number(b, 0), number(b, 1)};
}

/// Says for Question::Emission where light is sent.
void stateEmission(Lowering &lowering, const sl::Stmt &statement, const Triple &position,
                   const std::vector<ConeValues> &cones) {
    Builder &b = lowering.b;
    auto &emissions = b.function().emissions;
    const bool distant = statement.kind == sl::StmtKind::Solar;
    for (const ConeValues &cone : cones) {
        Components operands = componentsOf(position);
        operands.insert(operands.end(), cone.axis.begin(), cone.axis.end());
        operands.insert(operands.end(), {cone.angle, cone.exponent, cone.importance});
        b.emit(Op::EmissionCone, operands, int(emissions.size()));
        emissions.push_back({distant, isInLoop(lowering), statement.where.line});
    }
}

void openLight(Lowering &lowering, const Triple &L) {
    if (!lowering.light.direction)
        lowering.light.direction = L;
    lowering.variables.store(sl::PredefinedId::L, componentsOf(L));
}

} // namespace

void lowerIlluminate(Lowering &lowering, const sl::Stmt &statement) {
    Builder &b = lowering.b;
    lowering.light.kind = LightClass::Local;
    const sl::LightArguments &light = *statement.light;
    const Triple position = tripleOf(evaluate(lowering, *light.position));
    const Triple L = sub(b, tripleOf(lowering.variables.load(sl::PredefinedId::Ps)), position);
    ValueId lit = boolean(b, true);
    std::vector<ConeValues> cones{
        classicCone(b, triple(b, 0, 0, 1), number(b, std::numbers::pi_v<float>))};
    if (light.form == sl::ConeForm::Classic) {
        const Triple axis = normalize(b, tripleOf(evaluate(lowering, *light.axis)));
        const ValueId angle = evaluateFloat(lowering, *light.angle);
        cones = {classicCone(b, axis, angle)};
        const ValueId cosine =
            unary(b, Op::Cos, min(b, angle, number(b, std::numbers::pi_v<float>)));
        lit = lessEqual(b, cosine, dot(b, axis, normalize(b, L)));
        if (const float *known = constantFloat(b, angle);
            known && *known >= std::numbers::pi_v<float>)
            lit = boolean(b, true);
    } else if (light.form == sl::ConeForm::Extended) {
        cones = evaluateCones(lowering, light);
    }
    stateEmission(lowering, statement, position, cones);
    openLight(lowering, L);
    branch(
        lowering, lit, [&] { lowerBodyOf(lowering, statement); }, [] {});
}

namespace {

/// A direction drawn from one of several cones of solar().
struct DrawnCone {
    Triple axis;
    ValueId angle; ///< From the axis to the rim, radians.
    ValueId x;     ///< Uniform again.
    ValueId index; ///< Of the cone.
    ValueId total; ///< Of all importance.
};

ValueId shareOf(Builder &b, const ConeValues &cone) {
    return max(b, cone.importance, number(b, 0));
}

/// By importance.
DrawnCone drawCone(Builder &b, const std::vector<ConeValues> &cones, ValueId x) {
    const ValueId halfDegree = number(b, std::numbers::pi_v<float> / 360);
    ValueId total = number(b, 0);
    for (const ConeValues &cone : cones)
        total = add(b, total, shareOf(b, cone));
    const ValueId wanted = mul(b, x, total);
    DrawnCone drawn{triple(b, 0, 0, 1), number(b, std::numbers::pi_v<float>), x, number(b, 0),
                    total};
    ValueId sum = number(b, 0);
    for (size_t i = 0; i < cones.size(); ++i) {
        const ValueId share = shareOf(b, cones[i]);
        const ValueId taken = i == 0 ? boolean(b, true) : lessEqual(b, sum, wanted);
        const ValueId within = div(b, sub(b, wanted, sum), max(b, share, number(b, 1e-30f)));
        drawn.axis = select(b, taken, cones[i].axis, drawn.axis);
        drawn.angle = select(b, taken, mul(b, cones[i].angle, halfDegree), drawn.angle);
        drawn.x = select(b, taken, within, drawn.x);
        drawn.index = select(b, taken, number(b, float(i)), drawn.index);
        sum = add(b, sum, share);
    }
    return drawn;
}

/// What makes directions that were drawn so count as if those of the widest cone were drawn alike:
/// its density over theirs. Importance is in both ways of choosing, and not in the light. A cone
/// without width is a direction of its own.
ValueId worthOfDirection(Builder &b, const std::vector<ConeValues> &cones, const DrawnCone &drawn,
                         const Triple &direction) {
    const ValueId quarter = number(b, std::numbers::pi_v<float> / 720), none = number(b, 0);
    const Triple unit = normalize(b, direction);
    ValueId widest = none, density = none, alone = boolean(b, false), ownShare = none;
    for (size_t i = 0; i < cones.size(); ++i) {
        const ValueId share = shareOf(b, cones[i]);
        const ValueId angle = min(b, max(b, cones[i].angle, none), number(b, 360));
        const ValueId sine = unary(b, Op::Sin, mul(b, angle, quarter));
        const ValueId size = mul(b, sine, sine); // A quarter of the solid angle over pi.
        const ValueId isWide = less(b, none, size);
        const Triple axis = normalize(b, cones[i].axis);
        const Triple apart{sub(b, unit[0], axis[0]), sub(b, unit[1], axis[1]),
                           sub(b, unit[2], axis[2])};
        const ValueId own = equal(b, drawn.index, number(b, float(i)));
        const ValueId within = lessEqual(b, dot(b, apart, apart), mul(b, number(b, 4), size));
        const ValueId counts = both(b, isWide, either(b, own, within));
        const ValueId some = div(b, share, select(b, isWide, size, number(b, 1)));
        density = add(b, density, select(b, counts, some, none));
        widest = max(b, widest, select(b, less(b, none, share), size, none));
        alone = either(b, alone, both(b, own, negate(b, isWide)));
        ownShare = select(b, own, share, ownShare);
    }
    const ValueId spread = select(b, alone, ownShare, mul(b, widest, density));
    return select(b, less(b, none, spread), div(b, drawn.total, spread), number(b, 1));
}

} // namespace

void lowerSolar(Lowering &lowering, const sl::Stmt &statement) {
    Builder &b = lowering.b;
    if (lowering.light.kind == LightClass::Ambient)
        lowering.light.kind = LightClass::Distant;
    const sl::LightArguments &light = *statement.light;
    const ValueId x = input(b, ShaderInput::lightSample, 0);
    DrawnCone drawn{triple(b, 0, 0, 1), number(b, std::numbers::pi_v<float>), x, number(b, 0),
                    number(b, 1)};
    std::vector<ConeValues> cones;
    if (light.form == sl::ConeForm::Classic) {
        drawn.axis = tripleOf(evaluate(lowering, *light.axis));
        drawn.angle = evaluateFloat(lowering, *light.angle);
    } else if (light.form == sl::ConeForm::Extended) {
        cones = evaluateCones(lowering, light);
        drawn = drawCone(b, cones, x);
    }
    if (light.form != sl::ConeForm::Extended)
        cones = {classicCone(b, drawn.axis, drawn.angle)};
    stateEmission(lowering, statement, triple(b, 0, 0, 0), cones);
    if (!constantFloat(b, drawn.angle)) // Nothing is farther off than what lies behind.
        drawn.angle = min(b, drawn.angle, number(b, std::numbers::pi_v<float>));
    const Triple direction =
        directionInCone(b, drawn.axis, drawn.angle, drawn.x, input(b, ShaderInput::lightSample, 1),
                        ConeWeight::Uniform);
    openLight(lowering, direction);
    lowerBodyOf(lowering, statement);
    if (cones.size() < 2)
        return;
    Components Cl = lowering.variables.load(sl::PredefinedId::Cl);
    const ValueId worth = worthOfDirection(b, cones, drawn, direction);
    for (ValueId &sample : Cl)
        sample = mul(b, sample, worth);
    lowering.variables.store(sl::PredefinedId::Cl, Cl);
}

} // namespace candela::ir
