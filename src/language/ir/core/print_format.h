// SPDX-License-Identifier: Apache-2.0
// What the shaders' printf() and format() make of values (RI 3.2 section 15.8).
#pragma once

#include "language/runtime/services.h"

#include <string>
#include <vector>

namespace candela::ir {

/// A float, or a string if there is one.
struct PrintArgument {
    float number = 0;
    const std::string *text = nullptr;
};

/// %f %e %g print a number as in C, %d and %i the whole number that is nearest; %p %v %n %c print
/// three numbers with blanks between, %m sixteen, each as %f does; %s prints a string; %% is a
/// percent sign. Flags, width and precision are those of C, the last two at most 128. What a
/// pattern asks for beyond the arguments is left out.
std::string formatPrint(const std::string &pattern, const std::vector<PrintArgument> &);

/// What a lane that asks Service::print has to say.
std::string printedText(const ServiceCall &, int lane);

} // namespace candela::ir
