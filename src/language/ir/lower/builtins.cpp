// SPDX-License-Identifier: Apache-2.0
#include "language/ir/lower/builtins.h"

#include "language/ir/lower/expression.h"
#include "language/ir/lower/targets.h"

namespace candela::ir {

std::string BuiltinCall::text(size_t i, const char *what) const {
    return requiredText(lowering, arguments[i][0], expr.operands[i]->where, what);
}

size_t BuiltinCall::firstText(size_t from) const {
    while (from < count() && !isText(from))
        ++from;
    return from;
}

void BuiltinCall::assign(size_t i, const Components &value) const {
    const sl::Expr &target = *expr.operands[i];
    store(lowering, resolve(lowering, target), value, target.where);
}

Components builtin(Lowering &lowering, const sl::Expr &expr) {
    BuiltinCall call{lowering, lowering.b, expr, {}};
    for (const sl::ExprPtr &operand : expr.operands)
        call.arguments.push_back(evaluate(lowering, *operand));
    const sl::Lowering means = expr.overload->function->lowering;
    const bool asksSurface = means == sl::Lowering::Light || means == sl::Lowering::Derive;
    if (asksSurface && sl::runsFor(lowering.shader.kind) == sl::RunsFor::Picture) {
        lowering.messages.error(expr.where,
                                std::string(expr.overload->function->name) +
                                    "() is about points of surfaces; a filter is given a picture");
        return zero(lowering.b, expr.overload->result);
    }
    if (derivativeBuiltin(call.id()) || filterstepBuiltin(call.id()))
        lowering.derivatives.try_emplace(lowering.b.line(), expr.where);
    for (const auto subject :
         {mathsBuiltin, geometryBuiltin, spaceBuiltin, colorBuiltin, matrixBuiltin, noiseBuiltin,
          splineBuiltin, lightBuiltin, derivativeBuiltin, textBuiltin, informationBuiltin,
          imageBuiltin, rayBuiltin, filterstepBuiltin, messageBuiltin, textureBuiltin})
        if (const BuiltinLowering lowered = subject(call.id()))
            return lowered(call);
    lowering.messages.error(
        expr.where, std::string(expr.overload->function->name) +
                        "() is part of the language, but this renderer does not have it yet");
    return zero(lowering.b, expr.overload->result);
}

} // namespace candela::ir
