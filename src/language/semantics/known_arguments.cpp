// SPDX-License-Identifier: Apache-2.0
#include "language/semantics/known_arguments.h"

#include "language/semantics/constant_value.h"
#include "language/semantics/print_pattern.h"
#include "language/semantics/spellings.h"

namespace candela::sl {

/// What printf() cannot print is left out, for the picture does not need it.
static void checkPattern(const ast::Expr &call, BuiltinId id, const std::vector<ExprPtr> &arguments,
                         Reporter &reporter) {
    if (arguments[0]->kind != ExprKind::Text)
        return;
    const auto say = [&](const Place &where, const std::string &message) {
        if (id == BuiltinId::printf)
            reporter.warning(where, message + "; it prints nothing");
        else
            reporter.error(where, message);
    };
    size_t next = 1;
    for (const PrintPiece &piece : splitPrintPattern(arguments[0]->text)) {
        if (!piece.converts)
            continue;
        if (next < arguments.size() && !printsType(piece.letter, arguments[next]->type.base))
            say(arguments[next]->where, "'" + piece.conversion() + "' in the pattern of " +
                                            call.text + " cannot print a " +
                                            nameOf(arguments[next]->type.base));
        ++next;
    }
    if (next != arguments.size())
        say(call.where, "the pattern of " + call.text + " asks for " + std::to_string(next - 1) +
                            " values, but " + std::to_string(arguments.size() - 1) + " are given");
}

void checkStrings(const ast::Expr &call, BuiltinId id, const std::vector<ExprPtr> &arguments,
                  Reporter &reporter) {
    if (id == BuiltinId::printf || id == BuiltinId::format)
        checkPattern(call, id, arguments, reporter);
    for (const ExprPtr &argument : arguments) {
        if (argument->kind != ExprKind::Text)
            continue;
        const bool inverts = argument->text.starts_with(inverseSpline);
        const std::string basis = argument->text.substr(inverts ? inverseSpline.size() : 0);
        if (id == BuiltinId::spline && splineBasisSpelled(basis).empty())
            reporter.error(argument->where, "unknown spline basis \"" + argument->text +
                                                "\"; expected " + splineBasisNames);
    }
}

void warnOfColorAsVector(const ast::Expr &call, const BuiltinOverload &overload,
                         Reporter &reporter) {
    const BuiltinId id = overload.function->id;
    const bool isOfVector =
        id == BuiltinId::xcomp || id == BuiltinId::ycomp || id == BuiltinId::zcomp;
    if (isOfVector && overload.parameters[0].type == BaseType::Color)
        reporter.warning(call.where, call.text + "() is about vectors: of a color it gives what " +
                                         "comp() does, component " +
                                         (id == BuiltinId::xcomp   ? "0"
                                          : id == BuiltinId::ycomp ? "1"
                                                                   : "2"));
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
