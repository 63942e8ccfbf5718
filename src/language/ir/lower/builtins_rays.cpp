// SPDX-License-Identifier: Apache-2.0
// Built-in functions that ask for rays: the renderer follows them (services).
#include "language/ir/core/builder_arithmetic.h"
#include "language/ir/core/builder_light.h"
#include "language/ir/core/builder_services.h"
#include "language/ir/core/builder_sources.h"
#include "language/ir/core/builder_vectors.h"
#include "language/ir/lower/builtins.h"
#include "language/ir/lower/cone_direction.h"
#include "language/ir/lower/light.h"
#include "language/ir/lower/place_scope.h"
#include "language/runtime/hit_fields.h"
#include "language/semantics/named_arguments.h"

#include <numbers>
#include <string_view>

namespace candela::ir {
namespace {

constexpr float pi = std::numbers::pi_v<float>;
constexpr float farAway = 1e30f;

/// The operand behind a name among the optional arguments, which begin at `first`; 0 if it is not
/// there.
size_t named(const BuiltinCall &call, size_t first, std::string_view name) {
    for (size_t i = first; i + 1 < call.count(); i += 2)
        if (call.isText(i) && call.expr.operands[i]->text == name)
            return i + 1;
    return 0;
}

ValueId numberNamed(const BuiltinCall &call, size_t first, std::string_view name, float otherwise) {
    const size_t at = named(call, first, name);
    return at > 0 && !call.isText(at) ? call.number(at) : number(call.b, otherwise);
}

ValueId randomNumber(BuiltinCall &call) {
    return random(call.b, call.lowering.variables.cells[call.lowering.turn]);
}

void append(Values &to, const Triple &triple) { to.insert(to.end(), triple.begin(), triple.end()); }

/// The surface that rays leave: its normal and the zone in which they would meet it again. Lights
/// are not told the normal of what they light.
void appendStart(BuiltinCall &call, Values &operands) {
    Builder &b = call.b;
    const bool isLight = call.lowering.shader.kind == sl::ShaderKind::Light;
    append(operands, isLight ? triple(b, 0, 0, 0) : input3(b, ShaderInput::Ng));
    operands.push_back(input(b, ShaderInput::rayOffset));
}

Components occlusion(BuiltinCall &call) {
    Builder &b = call.b;
    const size_t point = call.isText(0) ? 1 : 0, more = point + 2;
    const size_t optional = call.firstText(more);
    const size_t distribution = named(call, optional, "distribution");
    const bool uniform = distribution > 0 && call.text(distribution, "a distribution") == "uniform";
    Values operands;
    append(operands, call.triple(point));
    append(operands, normalize(b, call.triple(point + 1)));
    appendStart(call, operands);
    operands.push_back(optional > more ? call.number(more)
                                       : numberNamed(call, optional, "samples", 64));
    operands.push_back(numberNamed(call, optional, "coneangle", pi / 2));
    operands.push_back(numberNamed(call, optional, "bias", 0));
    operands.push_back(numberNamed(call, optional, "maxdist", farAway));
    operands.push_back(number(b, uniform ? 0 : 1));
    operands.push_back(input(b, ShaderInput::time));
    operands.push_back(randomNumber(call));
    operands.push_back(randomNumber(call));
    const PlaceScope place(b, call.expr.where);
    const Values answer = query(b, info(Service::occlusion), {}, operands, 4);
    if (const size_t direction = named(call, optional, "environmentdir"))
        call.assign(direction, {answer[1], answer[2], answer[3]});
    return {answer[0]};
}

Components transmission(BuiltinCall &call) {
    Builder &b = call.b;
    Values operands;
    append(operands, call.triple(0));
    append(operands, call.triple(1));
    appendStart(call, operands);
    operands.push_back(numberNamed(call, 2, "samples", 1));
    operands.push_back(numberNamed(call, 2, "samplecone", 0));
    operands.push_back(numberNamed(call, 2, "bias", 0));
    operands.push_back(input(b, ShaderInput::time));
    operands.push_back(randomNumber(call));
    operands.push_back(randomNumber(call));
    const PlaceScope place(b, call.expr.where);
    return query(b, info(Service::transmission), {}, operands, b.colors().samples);
}

Values nearestHit(BuiltinCall &call, const Triple &origin, const Triple &direction, ValueId least,
                  ValueId greatest) {
    Builder &b = call.b;
    Values operands;
    append(operands, origin);
    append(operands, direction);
    appendStart(call, operands);
    operands.insert(operands.end(), {least, greatest, input(b, ShaderInput::time)});
    const PlaceScope place(b, call.expr.where);
    return query(b, info(Service::nearestHit), {}, operands, HitField::count(b.colors().samples));
}

Components tripleAt(const Values &hit, int field) {
    return {hit[size_t(field)], hit[size_t(field) + 1], hit[size_t(field) + 2]};
}

Values hitOf(BuiltinCall &call) {
    return nearestHit(call, call.triple(0), normalize(call.b, call.triple(1)), number(call.b, 0),
                      number(call.b, farAway));
}

/// The distance, or far away.
ValueId distanceOf(Builder &b, const Values &hit) {
    return select(b, notEqual(b, hit[HitField::hit], number(b, 0)), hit[HitField::distance],
                  number(b, farAway));
}

Components rayhittest(BuiltinCall &call) {
    const Values hit = hitOf(call);
    if (call.count() > 2) {
        call.assign(2, tripleAt(hit, HitField::P));
        call.assign(3, tripleAt(hit, HitField::N));
    }
    return {distanceOf(call.b, hit)};
}

/// The radiance that arrives from a direction, as trace() has it.
Components traced(BuiltinCall &call, const Triple &origin, const Triple &direction) {
    LightRequest request;
    request.kind = LightRequest::Kind::Trace;
    request.line = call.b.line();
    return trace(call.b, addRequest(call.lowering, request, call.expr.where), origin, direction);
}

Components fulltrace(BuiltinCall &call) {
    const Values hit = hitOf(call);
    call.assign(2, {distanceOf(call.b, hit)});
    call.assign(3, tripleAt(hit, HitField::P));
    call.assign(4, tripleAt(hit, HitField::N));
    call.assign(5, call.arguments[0]);
    call.assign(6, call.arguments[1]);
    return traced(call, call.triple(0), call.triple(1));
}

/// Where the named answers of gather stand among the results of the service.
struct GatherAnswer {
    std::string_view name;
    int field, numbers;
};
constexpr GatherAnswer gatherAnswers[] = {
    {"ray:length", HitField::distance, 1}, {"primitive:P", HitField::P, 3},
    {"surface:P", HitField::P, 3},         {"primitive:N", HitField::N, 3},
    {"surface:N", HitField::N, 3},         {"primitive:Ng", HitField::Ng, 3},
    {"surface:Ng", HitField::Ng, 3},       {"primitive:s", HitField::s, 1},
    {"surface:s", HitField::s, 1},         {"primitive:t", HitField::t, 1},
    {"surface:t", HitField::t, 1},         {"primitive:u", HitField::u, 1},
    {"surface:u", HitField::u, 1},         {"primitive:v", HitField::v, 1},
    {"surface:v", HitField::v, 1}};

/// What gather tells by a name; empty if it cannot.
Components gathered(BuiltinCall &call, std::string_view name, const Triple &direction,
                    const Values &hit) {
    Builder &b = call.b;
    if (name == "ray:direction")
        return componentsOf(direction);
    if (name == "ray:origin")
        return call.arguments[0];
    if (name == "surface:Ci")
        return traced(call, call.triple(0), direction);
    const auto samples = b.colors().samples;
    const auto colorAt = [&](int field) {
        return Components(hit.begin() + field, hit.begin() + field + samples);
    };
    if (name == "primitive:Cs" || name == "surface:Cs")
        return colorAt(HitField::Cs);
    if (name == "primitive:Os" || name == "surface:Os")
        return colorAt(HitField::Os(samples));
    for (const GatherAnswer &answer : gatherAnswers)
        if (answer.name == name)
            return answer.numbers == 1 ? Components{hit[size_t(answer.field)]}
                                       : tripleAt(hit, answer.field);
    return {};
}

/// What a ray that meets nothing does not tell stays as it is.
Components whereHit(BuiltinCall &call, const Values &hit, const Components &told, size_t variable) {
    Builder &b = call.b;
    const ValueId isHit = notEqual(b, hit[HitField::hit], number(b, 0));
    Components value;
    for (size_t c = 0; c < told.size(); ++c)
        value.push_back(select(b, isHit, told[c], call.arguments[variable][c]));
    return value;
}

/// A turn of a gather statement: (p, axis, angle, turn, samples, x, y, name, value...). The
/// directions of all turns fill the cone evenly (Roberts' sequence, shifted by x and y).
Components gather(BuiltinCall &call) {
    constexpr size_t optional = 7;
    constexpr float alongX = 0.7548776662f, alongY = 0.5698402910f;
    Builder &b = call.b;
    const auto shifted = [&](size_t shift, float step) {
        const ValueId sum = add(b, call.number(shift), mul(b, call.number(3), number(b, step)));
        return sub(b, sum, unary(b, Op::Floor, sum));
    };
    const size_t distribution = named(call, optional, "distribution");
    const bool cosine = distribution > 0 && call.text(distribution, "a distribution") == "cosine";
    const Triple direction =
        directionInCone(b, call.triple(1), call.number(2), shifted(5, alongX), shifted(6, alongY),
                        cosine ? ConeWeight::Cosine : ConeWeight::Uniform);
    const Values hit =
        nearestHit(call, call.triple(0), direction, numberNamed(call, optional, "bias", 0),
                   numberNamed(call, optional, "maxdist", farAway));
    for (size_t i = optional; i + 1 < call.count(); i += 2) {
        if (!sl::setsOperand(call.expr, i + 1))
            continue;
        const std::string &name = call.expr.operands[i]->text;
        const Components value = gathered(call, name, direction, hit);
        if (value.size() == call.arguments[i + 1].size())
            call.assign(i + 1,
                        name.starts_with("ray:") ? value : whereHit(call, hit, value, i + 1));
        else
            call.lowering.messages.warning(call.expr.operands[i]->where,
                                           "gather does not tell \"" + name +
                                               "\": the variable stays as it is");
    }
    return {hit[HitField::hit]};
}

} // namespace

BuiltinLowering rayBuiltin(sl::BuiltinId id) {
    switch (id) {
    case sl::BuiltinId::occlusion: return occlusion;
    case sl::BuiltinId::transmission:
    case sl::BuiltinId::visibility: return transmission;
    case sl::BuiltinId::rayhittest: return rayhittest;
    case sl::BuiltinId::fulltrace: return fulltrace;
    case sl::BuiltinId::gather: return gather;
    default: return nullptr;
    }
}

} // namespace candela::ir
