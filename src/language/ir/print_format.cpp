// SPDX-License-Identifier: Apache-2.0
#include "language/ir/print_format.h"

#include <cstdio>

namespace candela::ir {

namespace {

int argumentsOf(char conversion) {
    switch (conversion) {
    case 'p':
    case 'v':
    case 'n':
    case 'c': return 3;
    case 'm': return 16;
    default: return 1;
    }
}

void appendArgument(std::string &line, const PrintArgument &argument) {
    if (argument.text) {
        line += *argument.text;
        return;
    }
    char digits[64];
    std::snprintf(digits, sizeof digits, "%f", double(argument.number));
    line += digits;
}

} // namespace

std::string formatPrint(const std::string &format, const std::vector<PrintArgument> &arguments) {
    std::string line;
    std::size_t next = 0;
    for (std::size_t i = 0; i < format.size(); ++i) {
        if (format[i] != '%' || i + 1 == format.size()) {
            line += format[i];
            continue;
        }
        char conversion = format[++i];
        if (conversion == '%') {
            line += '%';
            continue;
        }
        int count = argumentsOf(conversion);
        for (int k = 0; k < count && next < arguments.size(); ++k, ++next) {
            if (k > 0)
                line += ' ';
            appendArgument(line, arguments[next]);
        }
    }
    return line;
}

} // namespace candela::ir
