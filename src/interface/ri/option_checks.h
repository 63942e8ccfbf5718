// SPDX-License-Identifier: Apache-2.0
// Values of Candela's own options, checked where they are given.
#pragma once

#include "interface/ri/parameter_list.h"
#include "interface/ri/request_diagnostics.h"

#include <string>

namespace candela {

/// Reports a value that the option does not have. False if the option is to stay as it was.
bool checkOption(RequestDiagnostics &, const SourceLocation &, const std::string &category,
                 const Parameter &);

} // namespace candela
