// SPDX-License-Identifier: Apache-2.0
// The reference, from the tables that the program itself goes by and the library of shaders.
#pragma once

#include <string>
#include <vector>

namespace candela {

/// What there is of that name, whatever it is: requests, options and attributes (by category or
/// name), statements and functions of the Shading Language, shaders of the library; an entry each.
/// The name of a kind ("requests", "options", "attributes", "statements", "functions", "shaders",
/// or "surfaces" to "filters") has all of its kind.
std::vector<std::string> referenceOf(const std::string &word);

/// All words that have an entry.
std::vector<std::string> referenceWords();

} // namespace candela
