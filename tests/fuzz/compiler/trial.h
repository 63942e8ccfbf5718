// SPDX-License-Identifier: Apache-2.0
// A text through the whole compiler: front end, IR, every question, and for some the code.
#pragma once

#include "workers.h"

#include <string>

namespace candela::fuzz {

enum class Thoroughness : std::uint8_t {
    Share,       ///< The text's bytes choose the light rule, and code for a question now and then.
    Interpreted, ///< Both light rules, no code.
    All,         ///< Both light rules, code for every question.
};

struct TrialSettings {
    std::string includeFolder; ///< Where #include finds shaders.
    Thoroughness thoroughness = Thoroughness::Share;
    int generateOneIn = 3; ///< With Share: of the texts that compile.
};

/// Whether the front end accepts the text.
bool compiles(const std::string &text, const TrialSettings &);

/// What is wrong with the compiler's answer to the text, or nothing.
std::string tryText(const std::string &text, const TrialSettings &, Monitor &);

} // namespace candela::fuzz
