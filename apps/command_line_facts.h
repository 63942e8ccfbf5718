// SPDX-License-Identifier: Apache-2.0
// What a verb takes, read off its options.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace candela {

/// The verbs of the program that --help shows, in its order.
std::vector<const CLI::App *> verbsOf(const CLI::App &program);

/// The options that --help shows, those of its groups behind its own.
std::vector<const CLI::Option *> optionsOf(const CLI::App &verb);

/// "--integrator", "-o": all names that begin with dashes.
std::vector<std::string> dashedNames(const CLI::Option &);

/// The values that it takes, where these are a set of words; else none.
std::vector<std::string> choicesOf(const CLI::Option &);

} // namespace candela
