// SPDX-License-Identifier: Apache-2.0
// Parts of Candela that are loaded when they are first needed, with the libraries that they bring.
#pragma once

#include <string>

namespace candela {

/// The function of the module lib/candela/NAME.so of the installation. Null, and `problem` says
/// why, if it cannot be had.
void *functionOfModule(const std::string &name, const char *function, std::string &problem);

} // namespace candela
