// SPDX-License-Identifier: Apache-2.0
// Message passing (RI 3.2 section 15.9): what shaders ask of the other shaders of their primitive,
// and of the light that an illuminance loop is at.
#include "language/ir/core/builder_arithmetic.h"
#include "language/ir/core/builder_services.h"
#include "language/ir/core/builder_sources.h"
#include "language/ir/core/builder_vectors.h"
#include "language/ir/lower/builtins.h"
#include "language/ir/lower/place_scope.h"
#include "language/ir/lower/scan.h"
#include "language/ir/lower/told_values.h"

#include <algorithm>

namespace candela::ir {
namespace {

/// What a light's string is where it is none of those that the shader has.
constexpr const char *anotherString = "(another string)";

/// Those that stand in the text, and those of its parameters. What is left to run time is compared
/// with none of them, or else it is not left.
std::vector<std::string> stringsOf(const Lowering &lowering) {
    std::vector<std::string> strings = textsOf(lowering.shader);
    for (const StringValue &parameter : lowering.strings)
        for (size_t k = 0; k < parameter.value.size(); ++k)
            if (!parameter.isLeft(k) && std::ranges::count(strings, parameter.value[k]) == 0)
                strings.push_back(parameter.value[k]);
    return strings;
}

/// A string that a light tells. Strings are known when a shader is compiled, so what the light has
/// is compared with those that the shader has: there is nothing else that a text could do with it
/// than compare it with them, or print it.
ValueId lightString(BuiltinCall &call, const std::string &name) {
    Builder &b = call.b;
    const std::vector<std::string> texts = stringsOf(call.lowering);
    Values operands{*call.lowering.lightNumber};
    for (const std::string &candidate : texts)
        operands.push_back(text(b, candidate));
    const PlaceScope place(b, call.expr.where);
    const Values answer = query(b, info(Service::lightsource), {name, "string"}, operands, 2);
    ValueId told = text(b, anotherString);
    for (size_t k = 0; k < texts.size(); ++k)
        told = select(b, equal(b, answer[1], number(b, float(k + 1))), operands[k + 1], told);
    const ValueId isThere = notEqual(b, answer[0], number(b, 0));
    call.assign(1, {select(b, isThere, told, call.arguments[1][0])});
    return answer[0];
}

Components lightsource(BuiltinCall &call) {
    Builder &b = call.b;
    const std::string name = call.text(0, "the name of a parameter");
    const sl::Type &type = call.expr.operands[1]->type;
    if (!call.lowering.lightNumber) // No light speaks outside of illuminance.
        return {number(b, 0)};
    if (type.base == sl::BaseType::String)
        return {type.isArray() ? number(b, 0) : lightString(call, name)};
    const PlaceScope place(b, call.expr.where);
    const Values answer = query(b, info(Service::lightsource), {name, sl::shapeOf(type)},
                                {*call.lowering.lightNumber}, 1 + numbersTold(type));
    return {takeTold(call, 1, answer)};
}

/// Strings of other shaders are known when the shader is compiled, or left to run time.
ValueId toldString(BuiltinCall &call, const std::string &hidden) {
    Builder &b = call.b;
    const auto &strings = call.lowering.strings;
    const auto given = std::ranges::find(strings, hidden, &StringValue::name);
    const sl::Type &type = call.expr.operands[1]->type;
    if (given == strings.end() || int(given->value.size()) != std::max(1, type.length))
        return number(b, 0);
    call.assign(1, call.lowering.stringsAtRunTime.read(b, *given));
    return number(b, 1);
}

/// Asks the shader that `whose` calls: hidden parameters of the one that asks.
Components ask(BuiltinCall &call, const std::string &whose) {
    const sl::ShaderKind kind = call.lowering.shader.kind;
    if (kind == sl::ShaderKind::Light || kind == sl::ShaderKind::Imager)
        call.lowering.messages.warning(
            call.expr.where, std::string(call.expr.overload->function->name) +
                                 "() asks another shader of the same primitive, which " +
                                 (kind == sl::ShaderKind::Light ? "a light" : "an imager") +
                                 " does not have: it gives 0");
    const std::string name = call.text(0, "the name of a parameter");
    const sl::Type &type = call.expr.operands[1]->type;
    if (type.base == sl::BaseType::String)
        return {toldString(call, toldName(whose, "string", name))};
    const std::string hidden = toldName(whose, sl::shapeOf(type), name);
    return {takeTold(call, 1, toldSlots(call.b, hidden, 1 + numbersTold(type)))};
}

Components surface(BuiltinCall &call) { return ask(call, "surface"); }
Components displacement(BuiltinCall &call) { return ask(call, "displacement"); }
Components atmosphere(BuiltinCall &call) { return ask(call, "atmosphere"); }

/// The volume on the side that the ray comes from is the exterior, seen from outside.
Components sideOfRay(BuiltinCall &call, const char *seenFromOutside, const char *seenFromInside) {
    Builder &b = call.b;
    if (call.lowering.shader.kind != sl::ShaderKind::Surface)
        return ask(call, seenFromOutside);
    const ValueId isOutside =
        lessEqual(b, dot(b, input3(b, ShaderInput::I), input3(b, ShaderInput::Ng)), number(b, 0));
    const sl::Type &type = call.expr.operands[1]->type;
    if (type.base == sl::BaseType::String)
        return ask(call, seenFromOutside);
    const std::string name = call.text(0, "the name of a parameter");
    const int numbers = 1 + numbersTold(type);
    const Values outside =
        toldSlots(b, toldName(seenFromOutside, sl::shapeOf(type), name), numbers);
    const Values inside = toldSlots(b, toldName(seenFromInside, sl::shapeOf(type), name), numbers);
    Values told;
    for (size_t k = 0; k < outside.size(); ++k)
        told.push_back(select(b, isOutside, outside[k], inside[k]));
    return {takeTold(call, 1, told)};
}

Components incident(BuiltinCall &call) { return sideOfRay(call, "exterior", "interior"); }
Components opposite(BuiltinCall &call) { return sideOfRay(call, "interior", "exterior"); }

} // namespace

std::string toldName(const std::string &whose, const std::string &shape, const std::string &name) {
    return whose + ":" + shape + " " + name;
}

BuiltinLowering messageBuiltin(sl::BuiltinId id) {
    switch (id) {
    case sl::BuiltinId::lightsource: return lightsource;
    case sl::BuiltinId::surface: return surface;
    case sl::BuiltinId::displacement: return displacement;
    case sl::BuiltinId::atmosphere: return atmosphere;
    case sl::BuiltinId::incident: return incident;
    case sl::BuiltinId::opposite: return opposite;
    default: return nullptr;
    }
}

} // namespace candela::ir
