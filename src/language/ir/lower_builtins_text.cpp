// SPDX-License-Identifier: Apache-2.0
// Strings are known when a shader is compiled: concat(), format() and match() are computed here.
// printf() keeps its numbers for run time.
#include "language/ir/lower_internal.h"
#include "language/ir/print_format.h"
#include "language/ir/regular_expression.h"

namespace candela::ir {
namespace {

/// A pattern in pieces: text between conversions, and the conversions. Widths and precisions, as in
/// "%.3f", are read and have no effect.
struct Piece {
    std::string text;    ///< Of a conversion: what stands before its letter.
    char conversion = 0; ///< 0: plain text, "%%" already replaced.
};

std::vector<Piece> splitPattern(const std::string &pattern) {
    std::vector<Piece> pieces(1);
    for (size_t i = 0; i < pattern.size(); ++i) {
        if (pattern[i] != '%' || i + 1 == pattern.size()) {
            pieces.back().text += pattern[i];
        } else if (pattern[i + 1] == '%') {
            pieces.back().text += '%';
            ++i;
        } else {
            const size_t end = pattern.find_first_not_of("0123456789.+- #", i + 1);
            if (end == std::string::npos)
                break;
            pieces.push_back({pattern.substr(i, end - i), pattern[end]});
            pieces.emplace_back();
            i = end;
        }
    }
    return pieces;
}

std::string escaped(const std::string &text) {
    std::string result;
    for (char c : text)
        result += c == '%' ? std::string("%%") : std::string(1, c);
    return result;
}

/// A pattern with conversions of single floats and strings only, and their values.
struct Expansion {
    std::string pattern;
    Components values;
};

bool accepts(char conversion, sl::BaseType base) {
    switch (conversion) {
    case 'f':
    case 'e':
    case 'g':
    case 'd':
    case 'i': return base == sl::BaseType::Float;
    case 'c':
    case 'p':
    case 'v':
    case 'n':
    case 'h': return sl::isTriple(base);
    case 'm': return base == sl::BaseType::Matrix;
    default: return conversion == 's' && base == sl::BaseType::String;
    }
}

/// Checks conversions against arguments; composite values become floats with blanks between.
std::optional<Expansion> expand(BuiltinCall &call) {
    Expansion result;
    size_t next = 1;
    for (const Piece &piece : splitPattern(call.text(0, "a pattern"))) {
        if (!piece.conversion) {
            result.pattern += escaped(piece.text);
            continue;
        }
        if (next >= call.count() ||
            !accepts(piece.conversion, call.expr.operands[next]->type.base)) {
            const std::string given = next >= call.count()
                                          ? "nothing"
                                          : "a " + sl::shapeOf(call.expr.operands[next]->type);
            call.lowering.error(call.expr.where, piece.text + piece.conversion + " is given " +
                                                     given +
                                                     "; %f, %g and %d print a float, %c a color, "
                                                     "%p a point, %m a matrix, %s a string");
            return std::nullopt;
        }
        const Components &argument = call.arguments[next++];
        const std::string *known = call.b.constantText(argument[0]);
        if (piece.conversion == 's' && known) {
            result.pattern += escaped(*known);
            continue;
        }
        for (size_t i = 0; i < argument.size(); ++i) {
            result.pattern += i ? " " : "";
            result.pattern += piece.conversion == 's' ? "%s" : "%f";
            result.values.push_back(argument[i]);
        }
    }
    return result;
}

Components printf(BuiltinCall &call) {
    if (const auto expansion = expand(call))
        call.b.printValues(expansion->pattern, expansion->values);
    return {};
}

Components format(BuiltinCall &call) {
    const auto expansion = expand(call);
    if (!expansion)
        return {call.b.text("")};
    std::vector<PrintArgument> arguments;
    for (ValueId value : expansion->values) {
        const float *known = call.b.constantFloat(value);
        if (!known) {
            call.lowering.error(call.expr.where, "format() makes its string when the shader is "
                                                 "compiled, so its arguments must be constants");
            return {call.b.text("")};
        }
        arguments.push_back({*known, nullptr});
    }
    return {call.b.text(formatPrint(expansion->pattern, arguments))};
}

Components concat(BuiltinCall &call) {
    std::string result;
    for (size_t i = 0; i < call.count(); ++i)
        result += call.text(i, "a string that concat() joins");
    return {call.b.text(result)};
}

Components match(BuiltinCall &call) {
    const std::string pattern = call.text(0, "a regular expression");
    const std::string subject = call.text(1, "the subject of match()");
    if (const auto expression = RegularExpression::parse(pattern))
        return {call.b.number(expression->foundIn(subject))};
    call.lowering.error(call.expr.operands[0]->where,
                        "\"" + pattern + "\" is not a regular expression, or too large a one");
    return {call.b.number(0)};
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
