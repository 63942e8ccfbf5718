// SPDX-License-Identifier: Apache-2.0
// Calls of built-in functions: each subject has a file of its own; here they are brought together.
#include "language/ir/lower_internal.h"

namespace candela::ir {

std::string BuiltinCall::text(size_t i, const char *what) const {
    return lowering.requiredText(arguments[i][0], expr.operands[i]->where, what);
}

void BuiltinCall::assign(size_t i, const Components &value) const {
    const sl::Expr &target = *expr.operands[i];
    lowering.store(lowering.resolve(target), value, target.where);
}

Components Lowering::builtin(const sl::Expr &expr) {
    BuiltinCall call{*this, b, expr, {}};
    for (const sl::ExprPtr &operand : expr.operands)
        call.arguments.push_back(evaluate(*operand));
    for (const auto subject :
         {mathsBuiltin, geometryBuiltin, spaceBuiltin, colorBuiltin, matrixBuiltin, noiseBuiltin,
          splineBuiltin, lightBuiltin, derivativeBuiltin, textBuiltin})
        if (const BuiltinLowering lowered = subject(call.id()))
            return lowered(call);
    error(expr.where, std::string(expr.overload->function->name) +
                          "() is part of the language, but this renderer does not have it yet");
    return zero(expr.overload->result);
}

} // namespace candela::ir
