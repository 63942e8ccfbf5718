// SPDX-License-Identifier: Apache-2.0
// The command line as other programs want it: manual pages, and what shells complete words by. All
// of it is read off the verbs' own options.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace candela {

/// The manual page of the verb, or of the program, in the language of man(1).
std::string manualPage(const CLI::App &verb);

/// The shells that completionScript() knows.
std::vector<std::string> completingShells();

/// A script that makes the shell complete `candela` with its verbs, options and their values, and
/// `candela help` with these words. For "zsh" and "bash" to be sourced, for "fish" to be put into
/// its folder of completions.
std::string completionScript(const std::string &shell, const CLI::App &program,
                             const std::vector<std::string> &helpWords);

} // namespace candela
