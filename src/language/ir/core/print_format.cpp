// SPDX-License-Identifier: Apache-2.0
#include "language/ir/core/print_format.h"

#include "language/semantics/print_pattern.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string_view>

namespace candela::ir {

namespace {

constexpr int mostCharacters = 128; // Of a width or a precision: patterns may come from scenes.

int argumentsOf(char letter) {
    switch (letter) {
    case 'p':
    case 'v':
    case 'n':
    case 'c': return 3;
    case 'm': return 16;
    default: return 1;
    }
}

/// Digits at the start of `rest`, which are taken off it; -1 if there are none.
int takeCount(std::string_view &rest) {
    int count = -1;
    for (; !rest.empty() && rest[0] >= '0' && rest[0] <= '9'; rest.remove_prefix(1))
        count = std::min(std::max(count, 0) * 10 + (rest[0] - '0'), mostCharacters);
    return count;
}

/// Options that are safe to hand to the C library: known flags once each, and numbers in bounds.
std::string safeOptions(std::string_view options, std::string_view allowedFlags) {
    std::string result;
    const size_t flags = std::min(options.find_first_not_of("-+ #0"), options.size());
    for (char flag : allowedFlags)
        if (options.substr(0, flags).find(flag) != options.npos)
            result += flag;
    options.remove_prefix(flags);
    if (const int width = takeCount(options); width >= 0)
        result += std::to_string(width);
    if (options.starts_with('.')) {
        options.remove_prefix(1);
        result += "." + std::to_string(std::max(0, takeCount(options)));
    }
    return result;
}

template <typename Value> std::string printed(const std::string &conversion, Value value) {
    const int length = std::snprintf(nullptr, 0, conversion.c_str(), value);
    std::string result(size_t(length) + 1, '\0');
    std::snprintf(result.data(), result.size(), conversion.c_str(), value);
    result.pop_back();
    return result;
}

std::string printedWhole(const std::string &options, double number) {
    constexpr double most = 9e18;
    if (std::fabs(number) < most)
        return printed("%" + safeOptions(options, "-+ 0") + "lld", std::llround(number));
    return printed("%" + safeOptions(options, "-+ 0") + "f", number); // Infinite, or no number.
}

std::string printedArgument(const sl::PrintPiece &piece, const PrintArgument &argument) {
    if (argument.text)
        return printed("%" + safeOptions(piece.options, "-") + "s", argument.text->c_str());
    const double number = argument.number;
    if (piece.letter == 'd' || piece.letter == 'i')
        return printedWhole(piece.options, number);
    const bool hasStyle = piece.letter == 'e' || piece.letter == 'g';
    return printed("%" + safeOptions(piece.options, "-+ #0") + (hasStyle ? piece.letter : 'f'),
                   number);
}

} // namespace

std::string formatPrint(const std::string &pattern, const std::vector<PrintArgument> &arguments) {
    std::string line;
    std::size_t next = 0;
    for (const sl::PrintPiece &piece : sl::splitPrintPattern(pattern)) {
        line += piece.text;
        const int count = piece.converts ? argumentsOf(piece.letter) : 0;
        for (int k = 0; k < count && next < arguments.size(); ++k, ++next)
            line += (k > 0 ? " " : "") + printedArgument(piece, arguments[next]);
    }
    return line;
}

std::string printedText(const ServiceCall &call, int lane) {
    std::vector<std::string> texts(std::size_t(call.site->operandCount));
    std::vector<PrintArgument> values;
    for (int k = 0; k < call.site->operandCount; ++k) {
        const char type = call.site->types[k];
        if (type == 's') {
            texts[std::size_t(k)] = call.string(k, lane);
            values.push_back({0, &texts[std::size_t(k)]});
        } else {
            const ServiceCell cell = call.operand(k, lane);
            values.push_back({type == 'f' ? cell.number : float(cell.integer), nullptr});
        }
    }
    return formatPrint(call.site->texts[0], values);
}

} // namespace candela::ir
