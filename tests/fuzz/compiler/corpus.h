// SPDX-License-Identifier: Apache-2.0
// The shaders that inputs are made from.
#pragma once

#include "words.h"

#include <map>
#include <string>
#include <vector>

namespace candela::fuzz {

struct Corpus {
    std::vector<Words> texts;
    /// The words that follow a word somewhere in the texts, as often as they do.
    std::map<std::string, std::vector<std::string>> followers;

    void add(std::string_view text);
};

/// All files named *.sl in and below the folders, in the order of their paths.
Corpus readCorpus(const std::vector<std::string> &folders);

} // namespace candela::fuzz
