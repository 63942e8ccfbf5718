// SPDX-License-Identifier: Apache-2.0
// What shaders ask about the frame and the renderer.
#include "language/ir/core/builder_arithmetic.h"
#include "language/ir/core/builder_services.h"
#include "language/ir/core/builder_sources.h"
#include "language/ir/core/builder_vectors.h"
#include "language/ir/lower/builtins.h"
#include "language/ir/lower/color.h"
#include "language/ir/lower/place_scope.h"
#include "language/syntax/version.h"

#include <algorithm>

namespace candela::ir {
namespace {

/// Colours of a text are told in red, green and blue, element by element.
Components fromTold(Builder &b, const sl::Type &type, const Values &told) {
    if (type.base != sl::BaseType::Color)
        return told;
    Components all;
    for (size_t k = 0; k + 2 < told.size(); k += 3) {
        const Components color = colorOf(b, {told[k], told[k + 1], told[k + 2]});
        all.insert(all.end(), color.begin(), color.end());
    }
    return all;
}

/// The variable gets the value, or stays as it is if there is none.
void assignIf(BuiltinCall &call, ValueId isThere, const Components &told) {
    Components now;
    for (size_t k = 0; k < told.size(); ++k)
        now.push_back(select(call.b, isThere, told[k], call.arguments[1][k]));
    call.assign(1, now);
}

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
    const int numbers = componentCount(type.base, 3) * std::max(1, type.length);
    const PlaceScope place(b, call.expr.where);
    const Values answer = ask(name, sl::shapeOf(type), 1 + numbers);
    assignIf(call, notEqual(b, answer[0], number(b, 0)),
             fromTold(b, type, {answer.begin() + 1, answer.end()}));
    return {answer[0]};
}

Components option(BuiltinCall &call) {
    return askFor(call, [&](const std::string &name, const std::string &type, int numbers) {
        return query(call.b, info(Service::option), {name, type}, {}, numbers);
    });
}

/// Attributes are the same all over a primitive, so they are hidden parameters of the instance.
Components attribute(BuiltinCall &call) {
    return askFor(call, [&](const std::string &name, const std::string &type, int numbers) {
        auto &slots = call.b.function().parameters;
        const std::string hidden = attributeParameter(name, type);
        size_t first = 0;
        while (first < slots.size() && slots[first].name != hidden)
            ++first;
        for (int k = 0; first + size_t(k) == slots.size() && k < numbers; ++k)
            slots.push_back({hidden, k});
        Values answer;
        for (int k = 0; k < numbers; ++k)
            answer.push_back(parameter(call.b, int(first) + k));
        return answer;
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
