// SPDX-License-Identifier: Apache-2.0
// concat(), format() and match() are computed here, of strings that are known when a shader is
// compiled. printf() keeps its numbers for run time, and strings that are left to it.
#include "language/ir/core/builder_services.h"
#include "language/ir/core/builder_sources.h"
#include "language/ir/core/print_format.h"
#include "language/ir/lower/builtins.h"
#include "language/ir/lower/color.h"
#include "language/ir/lower/limits.h"
#include "language/ir/lower/regular_expression.h"
#include "language/semantics/print_pattern.h"

#include <fmt/format.h>

namespace candela::ir {
namespace {

std::string escaped(const std::string &text) {
    std::string result;
    for (char c : text)
        result += c == '%' ? std::string("%%") : std::string(1, c);
    return result;
}

/// A string that is made while the shader is compiled, unless there are too many characters in it
/// or in all strings together.
Components madeText(BuiltinCall &call, const std::string &made) {
    size_t together = made.size();
    for (const std::string &known : call.b.function().strings)
        together += known.size();
    if (made.size() <= mostCharacters && together <= mostCharactersTogether)
        return {text(call.b, made)};
    call.lowering.messages.error(
        call.expr.where,
        fmt::format("the string that {}() makes here is too long: {} characters in a string and "
                    "{} in all strings of a shader are the most",
                    call.expr.overload->function->name, mostCharacters, mostCharactersTogether));
    return {text(call.b, "")};
}

/// A pattern with known strings filled in, and the values of its other conversions.
struct Expansion {
    std::string pattern;
    Components values;
};

/// True if the call has a value of the right type for the conversion; else it is reported.
bool isGiven(BuiltinCall &call, const sl::PrintPiece &piece, size_t argument) {
    const bool missing = argument >= call.count();
    if (!missing && sl::printsType(piece.letter, call.expr.operands[argument]->type.base))
        return true;
    const std::string given =
        missing ? "nothing" : "a " + sl::shapeOf(call.expr.operands[argument]->type);
    const std::string message = piece.conversion() + " is given " + given +
                                "; %f, %g and %d print a float, %c a color, %p a point, %m a "
                                "matrix, %s a string";
    if (call.id() == sl::BuiltinId::format)
        call.lowering.messages.error(call.expr.where, message);
    return false; // Of printf() the checker has told.
}

/// Checks conversions against arguments.
std::optional<Expansion> expand(BuiltinCall &call) {
    Expansion result;
    size_t next = 1;
    for (const sl::PrintPiece &piece : sl::splitPrintPattern(call.text(0, "a pattern"))) {
        result.pattern += escaped(piece.text);
        if (!piece.converts)
            continue;
        if (!isGiven(call, piece, next))
            return std::nullopt;
        const Components &argument = call.arguments[next++];
        if (const std::string *known = constantText(call.b, argument[0])) {
            result.pattern += escaped(formatPrint(piece.conversion(), {{0, known}}));
            continue;
        }
        if (call.id() == sl::BuiltinId::format && call.isText(next - 1))
            call.lowering.stringsAtRunTime.need(argument[0]);
        result.pattern += piece.conversion();
        const bool isColor = call.expr.operands[next - 1]->type.base == sl::BaseType::Color;
        const Components shown = isColor ? componentsOf(rgbOf(call.b, argument)) : argument;
        result.values.insert(result.values.end(), shown.begin(), shown.end());
    }
    return result;
}

Components printf(BuiltinCall &call) {
    const auto expansion = expand(call);
    if (expansion && expansion->values.size() > mostPrinted)
        call.lowering.messages.error(
            call.expr.where,
            fmt::format("a printf() prints at most {} numbers (a point is three, a "
                        "matrix sixteen), not {}; print the rest with another",
                        mostPrinted, expansion->values.size()));
    else if (expansion)
        printValues(call.b, expansion->pattern, expansion->values);
    return {};
}

Components format(BuiltinCall &call) {
    const auto expansion = expand(call);
    if (!expansion)
        return {text(call.b, "")};
    std::vector<PrintArgument> arguments;
    for (ValueId value : expansion->values) {
        const float *known = constantFloat(call.b, value);
        if (!known)
            call.lowering.messages.warning(call.expr.where,
                                           "format() makes its string when the shader is compiled; "
                                           "0 stands for what is not known then");
        arguments.push_back({known ? *known : 0, nullptr});
    }
    return madeText(call, formatPrint(expansion->pattern, arguments));
}

Components concat(BuiltinCall &call) {
    std::string result;
    for (size_t i = 0; i < call.count(); ++i)
        result += call.text(i, "a string that concat() joins");
    return madeText(call, result);
}

Components match(BuiltinCall &call) {
    const std::string pattern = call.text(0, "a regular expression");
    const std::string subject = call.text(1, "the subject of match()");
    if (const auto expression = RegularExpression::parse(pattern))
        return {number(call.b, expression->foundIn(subject))};
    call.lowering.messages.error(call.expr.operands[0]->where,
                                 "\"" + pattern +
                                     "\" is not a regular expression, or too large a one");
    return {number(call.b, 0)};
}

} // namespace

BuiltinLowering textBuiltin(sl::BuiltinId id) {
    switch (id) {
    case sl::BuiltinId::printf: return printf;
    case sl::BuiltinId::format: return format;
    case sl::BuiltinId::concat: return concat;
    case sl::BuiltinId::match: return match;
    default: return nullptr;
    }
}

} // namespace candela::ir
