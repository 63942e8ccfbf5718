// SPDX-License-Identifier: Apache-2.0
// What shaders ask about the frame and the renderer.
#include "language/ir/core/builder_arithmetic.h"
#include "language/ir/core/builder_services.h"
#include "language/ir/core/builder_sources.h"
#include "language/ir/core/builder_vectors.h"
#include "language/ir/lower/builtins.h"
#include "language/ir/lower/place_scope.h"
#include "language/ir/lower/told_values.h"
#include "language/syntax/version.h"

namespace candela::ir {
namespace {

/// Asks for a value of the type of the variable: `ask` gives, for a name, a type and a number of
/// numbers, whether it is there and the value.
template <class Ask> Components askFor(BuiltinCall &call, Ask ask) {
    Builder &b = call.b;
    const sl::Type &type = call.expr.operands[1]->type;
    const std::string function = call.expr.overload->function->name;
    const std::string name = call.text(0, "the name of what is asked for");
    if (type.base == sl::BaseType::String) {
        call.lowering.messages.warning(call.expr.operands[1]->where,
                                       function + "() tells numbers: strings have to be known when "
                                                  "a shader is compiled; it gives 0");
        return {number(b, 0)};
    }
    const PlaceScope place(b, call.expr.where);
    return {takeTold(call, 1, ask(name, sl::shapeOf(type), 1 + numbersTold(type)))};
}

Components option(BuiltinCall &call) {
    return askFor(call, [&](const std::string &name, const std::string &type, int numbers) {
        return query(call.b, info(Service::option), {name, type}, {}, numbers);
    });
}

/// Attributes are the same all over a primitive, so they are hidden parameters of the instance.
Components attribute(BuiltinCall &call) {
    const sl::ShaderKind kind = call.lowering.shader.kind;
    if (kind != sl::ShaderKind::Surface)
        call.lowering.messages.warning(call.expr.where,
                                       "attribute() is told to surface shaders alone; in a " +
                                           std::string(sl::nameOf(kind)) + " shader it gives 0");
    return askFor(call, [&](const std::string &name, const std::string &type, int numbers) {
        return toldSlots(call.b, attributeParameter(name, type), numbers);
    });
}

Components zero(BuiltinCall &call) { return zero(call.b, call.result()); }

/// The name is known of this shader alone.
Components shadername(BuiltinCall &call) {
    const sl::TypedShader &shader = call.lowering.shader;
    const bool own =
        call.count() == 0 || call.text(0, "a kind of shader") == sl::nameOf(shader.kind);
    return {text(call.b, own ? shader.name : "")};
}

Components raydepth(BuiltinCall &call) { return {input(call.b, ShaderInput::rayDepth)}; }

/// What is known of the ray that sees the point.
Components rayFact(BuiltinCall &call, const std::string &field) {
    Builder &b = call.b;
    const Triple I = tripleOf(call.lowering.variables.load(sl::PredefinedId::I));
    if (field == "depth")
        return raydepth(call);
    if (field == "length")
        return {length(b, I)};
    if (field == "direction")
        return componentsOf(normalize(b, I));
    if (field == "origin")
        return componentsOf(sub(b, tripleOf(call.lowering.variables.load(sl::PredefinedId::P)), I));
    if (field == "label")
        return {text(b, "")};
    if (field == "type") {
        const ValueId fromEye = equal(b, raydepth(call)[0], number(b, 0));
        return {select(b, fromEye, text(b, "camera"), text(b, "specular"))};
    }
    return {};
}

Components rayinfo(BuiltinCall &call) {
    Builder &b = call.b;
    const std::string field = call.text(0, "the name of what is asked for");
    const sl::Type &type = call.expr.operands[1]->type;
    const bool wantsText = field == "label" || field == "type";
    const Components fact = rayFact(call, field);
    const bool fits = !fact.empty() && fact.size() == call.arguments[1].size() &&
                      wantsText == (type.base == sl::BaseType::String) &&
                      type.base != sl::BaseType::Color;
    if (fits)
        call.assign(1, fact);
    return {number(b, fits ? 1 : 0)};
}

/// Known when the shader is compiled.
Components rendererinfo(BuiltinCall &call) {
    Builder &b = call.b;
    const std::string name = call.text(0, "the name of what is asked for");
    const std::string shape = sl::shapeOf(call.expr.operands[1]->type);
    Components told;
    if (name == "renderer" && shape == "string")
        told = {text(b, "Candela")};
    if (name == "versionstring" && shape == "string")
        told = {text(b, sl::versionText())};
    if (name == "version" && shape == "float[4]") {
        for (int part : sl::version())
            told.push_back(number(b, float(part)));
        told.push_back(number(b, 0));
    }
    if (!told.empty())
        call.assign(1, told);
    return {number(b, told.empty() ? 0 : 1)};
}

} // namespace

BuiltinLowering informationBuiltin(sl::BuiltinId id) {
    switch (id) {
    case sl::BuiltinId::option: return option;
    case sl::BuiltinId::attribute: return attribute;
    case sl::BuiltinId::shadername: return shadername;
    case sl::BuiltinId::raydepth:
    case sl::BuiltinId::raylevel: return raydepth;
    case sl::BuiltinId::rayinfo: return rayinfo;
    case sl::BuiltinId::isshadowray:
    case sl::BuiltinId::isindirectray:
    case sl::BuiltinId::raylabel: return zero;
    case sl::BuiltinId::rendererinfo: return rendererinfo;
    default: return nullptr;
    }
}

} // namespace candela::ir
