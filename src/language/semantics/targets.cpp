// SPDX-License-Identifier: Apache-2.0
#include "language/semantics/targets.h"

namespace candela::sl {

void hintIfReadOnly(const Symbol &symbol, const Place &where, const Surroundings &here) {
    const ShaderKind kind = here.names.shaderKind();
    if (symbol.kind == Symbol::Kind::Predefined && !symbol.predefined->writableIn(kind))
        here.reporter.hint(where, symbol.name + " is not for a " + nameOf(kind) +
                                      " shader to assign; only this shader sees the change");
    if (symbol.kind == Symbol::Kind::Parameter && !symbol.output)
        here.reporter.hint(where, "parameter " + symbol.name +
                                      " is assigned, but not declared output; only this shader "
                                      "sees the change");
    if (symbol.kind == Symbol::Kind::Formal && !symbol.output)
        here.reporter.hint(where, "argument " + symbol.name +
                                      " is assigned, but not declared output; the caller's value "
                                      "stays as it is");
}

Symbol &symbolOf(const Expr &target) {
    const Expr *e = &target;
    while (e->kind != ExprKind::Variable)
        e = e->operands[0].get();
    return *e->symbol;
}

bool detailFits(const Expr &target, Detail value, const Place &where, Reporter &reporter) {
    Symbol &symbol = symbolOf(target);
    if (value == Detail::Uniform || symbol.type.isVarying())
        return true;
    const bool isArgument =
        symbol.kind == Symbol::Kind::Parameter || symbol.kind == Symbol::Kind::Formal;
    if (isArgument && !symbol.detailStated)
        return true; // A copy of the shader's own, which varies where it is made to.
    if (symbol.kind == Symbol::Kind::Local && symbol.type.base == BaseType::String &&
        !symbol.detailStated) {
        symbol.type.detail = Detail::Varying;
        return true;
    }
    reporter.error(where, "a varying value cannot be assigned to uniform " +
                              std::string(nameOf(symbol.type.base)) + " " + symbol.name +
                              "; declare it varying");
    return false;
}

} // namespace candela::sl
