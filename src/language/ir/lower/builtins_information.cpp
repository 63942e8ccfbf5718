// SPDX-License-Identifier: Apache-2.0
// What shaders ask about the frame and the renderer.
#include "language/ir/core/builder_arithmetic.h"
#include "language/ir/core/builder_services.h"
#include "language/ir/core/builder_sources.h"
#include "language/ir/lower/builtins.h"
#include "language/ir/lower/place_scope.h"
#include "language/ir/lower/told_values.h"
#include "language/syntax/version.h"

namespace candela::ir {
namespace {

/// Asks the service for a value of the type of the variable.
Components askFor(BuiltinCall &call, Service service) {
    Builder &b = call.b;
    const sl::Type &type = call.expr.operands[1]->type;
    const std::string function = call.expr.overload->function->name;
    const std::string name = call.text(0, "the name of what is asked for");
    if (type.base == sl::BaseType::String) {
        call.lowering.messages.error(call.expr.operands[1]->where,
                                     function + "() tells numbers: strings have to be known when "
                                                "a shader is compiled");
        return {number(b, 0)};
    }
    const PlaceScope place(b, call.expr.where);
    const Values answer =
        query(b, info(service), {name, sl::shapeOf(type)}, {}, 1 + numbersTold(type));
    assignTold(call, notEqual(b, answer[0], number(b, 0)), {answer.begin() + 1, answer.end()});
    return {answer[0]};
}

Components option(BuiltinCall &call) { return askFor(call, Service::option); }

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
    case sl::BuiltinId::rendererinfo: return rendererinfo;
    default: return nullptr;
    }
}

} // namespace candela::ir
