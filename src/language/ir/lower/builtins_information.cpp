// SPDX-License-Identifier: Apache-2.0
// What shaders ask about the frame and the renderer.
#include "language/ir/core/builder_arithmetic.h"
#include "language/ir/core/builder_services.h"
#include "language/ir/core/builder_sources.h"
#include "language/ir/lower/builtins.h"
#include "language/ir/lower/color.h"
#include "language/ir/lower/place_scope.h"

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

/// Asks for a value of the type of the variable, which stays as it is if there is none.
Components option(BuiltinCall &call) {
    Builder &b = call.b;
    const sl::Type &type = call.expr.operands[1]->type;
    const std::string name = call.text(0, "the name of an option");
    if (type.base == sl::BaseType::String) {
        call.lowering.messages.error(call.expr.operands[1]->where,
                                     "option() tells numbers: strings are known when a shader is "
                                     "compiled, options are not");
        return {number(b, 0)};
    }
    const int numbers = componentCount(type.base, 3) * std::max(1, type.length);
    const PlaceScope place(b, call.expr.where);
    const Values answer =
        query(b, info(Service::option), {name, sl::shapeOf(type)}, {}, 1 + numbers);
    const ValueId isThere = notEqual(b, answer[0], number(b, 0));
    const Components told = fromTold(b, type, {answer.begin() + 1, answer.end()});
    Components now;
    for (size_t k = 0; k < told.size(); ++k)
        now.push_back(select(b, isThere, told[k], call.arguments[1][k]));
    call.assign(1, now);
    return {answer[0]};
}

} // namespace

BuiltinLowering informationBuiltin(sl::BuiltinId id) {
    return id == sl::BuiltinId::option ? option : nullptr;
}

} // namespace candela::ir
