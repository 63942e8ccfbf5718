// SPDX-License-Identifier: Apache-2.0
#include "language/semantics/known_arguments.h"

#include "language/semantics/constant_value.h"
#include "language/semantics/print_pattern.h"
#include "language/semantics/spellings.h"

namespace candela::sl {

static void checkPattern(const ast::Expr &call, const std::vector<ExprPtr> &arguments,
                         Reporter &reporter) {
    if (arguments[0]->kind != ExprKind::Text)
        return;
    size_t next = 1;
    for (const PrintPiece &piece : splitPrintPattern(arguments[0]->text)) {
        if (!piece.converts)
            continue;
        if (next < arguments.size() && !printsType(piece.letter, arguments[next]->type.base))
            reporter.error(arguments[next]->where,
                           "'" + piece.conversion() + "' in the pattern of " + call.text +
                               " cannot print a " + nameOf(arguments[next]->type.base));
        ++next;
    }
    if (next != arguments.size())
        reporter.error(call.where, "the pattern of " + call.text + " asks for " +
                                       std::to_string(next - 1) + " values, but " +
                                       std::to_string(arguments.size() - 1) + " are given");
}

void checkStrings(const ast::Expr &call, BuiltinId id, const std::vector<ExprPtr> &arguments,
                  Reporter &reporter) {
    if (id == BuiltinId::printf || id == BuiltinId::format)
        checkPattern(call, arguments, reporter);
    for (const ExprPtr &argument : arguments) {
        if (argument->kind != ExprKind::Text)
            continue;
        if (id == BuiltinId::spline && splineBasisSpelled(argument->text).empty())
            reporter.error(argument->where, "unknown spline basis \"" + argument->text +
                                                "\"; expected " + splineBasisNames);
        if (id == BuiltinId::ctransform && colorSpaceSpelled(argument->text).empty())
            reporter.error(argument->where, "unknown colour space \"" + argument->text +
                                                "\"; expected " + colorSpaceNames);
    }
}

// (triple, index, ...) or (matrix, row, column, ...).
bool componentsExist(const ast::Expr &call, const BuiltinOverload &overload, Reporter &reporter) {
    const BuiltinId id = overload.function->id;
    if (id != BuiltinId::comp && id != BuiltinId::setcomp)
        return true;
    const BaseType base = overload.parameters[0].type;
    const std::string what = std::string("a ") + nameOf(base);
    if (base == BaseType::Matrix)
        return constantIndexFits(*call.operands[1], 4, what, reporter) &&
               constantIndexFits(*call.operands[2], 4, what, reporter);
    return constantIndexFits(*call.operands[1], 3, what, reporter);
}

} // namespace candela::sl
