// SPDX-License-Identifier: Apache-2.0
#include "language/semantics/named_arguments.h"

namespace candela::sl {

bool isResultName(BuiltinId function, std::string_view name) {
    if (function == BuiltinId::gather) // "ray:length", "surface:Ci"; "send:..." gives.
        return name.find(':') != name.npos && !name.starts_with("send:");
    if (function == BuiltinId::occlusion || function == BuiltinId::indirectdiffuse ||
        function == BuiltinId::indirect)
        return name == "environmentcolor" || name == "environmentdir";
    return false;
}

bool isNamedResult(BuiltinId function, const ast::Expr &call, size_t i) {
    const ast::Expr *before = i > 0 ? call.operands[i - 1].get() : nullptr;
    return before && before->kind == ast::ExprKind::Text && isResultName(function, before->text);
}

bool setsOperand(const Expr &call, size_t i) {
    const BuiltinOverload &overload = *call.overload;
    if (i < overload.parameters.size())
        return overload.parameters[i].output;
    const Expr *before = overload.openEnded && i > 0 ? call.operands[i - 1].get() : nullptr;
    return before && before->kind == ExprKind::Text &&
           isResultName(overload.function->id, before->text);
}

const Expr *namedOperand(const Expr &call, size_t first, std::string_view name) {
    for (size_t i = first; i + 1 < call.operands.size(); i += 2)
        if (call.operands[i]->kind == ExprKind::Text && call.operands[i]->text == name)
            return call.operands[i + 1].get();
    return nullptr;
}

} // namespace candela::sl
