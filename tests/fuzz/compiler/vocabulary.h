// SPDX-License-Identifier: Apache-2.0
// The words that the Shading Language knows, by what they are.
#pragma once

#include <string>
#include <vector>

namespace candela::fuzz {

struct Vocabulary {
    using Spellings = std::vector<std::string>;

    Spellings types;      ///< "float"...
    Spellings kinds;      ///< "surface"...
    Spellings storage;    ///< "uniform", "output"...
    Spellings statements; ///< "if", "illuminance"...
    Spellings functions;  ///< All built-in ones.
    Spellings variables;  ///< All predefined ones, of all kinds of shaders.
    Spellings operators;
    Spellings brackets;   ///< With the comma and the semicolon.
    Spellings numbers;    ///< Ordinary, huge, tiny, and no numbers at all.
    Spellings strings;    ///< Names of spaces, categories, formats, and escapes.
    Spellings directives; ///< Whole lines that begin with #.
    Spellings strays;     ///< What begins no word of the language.

    /// Lists of words that can mostly stand for each other: functions of the same arguments,
    /// variables of the same type.
    std::vector<Spellings> alike;
    /// Lists of words of the same class.
    std::vector<Spellings> related;
};

const Vocabulary &vocabulary();

} // namespace candela::fuzz
