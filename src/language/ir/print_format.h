// SPDX-License-Identifier: Apache-2.0
// What the shaders' printf() prints (RI 3.2 section 15.8).
#pragma once

#include <string>
#include <vector>

namespace candela::ir {

/// A float, or a string if there is one.
struct PrintArgument {
    float number = 0;
    const std::string *text = nullptr;
};

/// %f takes one number, %p %v %n %c three, %m sixteen, %s a string; %% is a percent sign. What a
/// format asks for beyond the arguments is left out.
std::string formatPrint(const std::string &format, const std::vector<PrintArgument> &);

} // namespace candela::ir
