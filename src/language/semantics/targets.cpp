// SPDX-License-Identifier: Apache-2.0
#include "language/semantics/targets.h"

namespace candela::sl {

bool mayWrite(const Symbol &symbol, const Place &where, const Surroundings &here) {
    const ShaderKind kind = here.names.shaderKind();
    std::string problem;
    if (symbol.kind == Symbol::Kind::Predefined && !symbol.predefined->writableIn(kind))
        problem = symbol.name + " cannot be assigned in a " + nameOf(kind) + " shader";
    if (symbol.kind == Symbol::Kind::Parameter && !symbol.output)
        problem = "parameter " + symbol.name +
                  " cannot be assigned; declare it output, or copy it "
                  "into a variable";
    if (symbol.kind == Symbol::Kind::Formal && !symbol.output)
        problem = "argument " + symbol.name +
                  " cannot be assigned; declare it output, or copy it "
                  "into a variable";
    if (problem.empty())
        return true;
    here.reporter.error(where, problem);
    return false;
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
