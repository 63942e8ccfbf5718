// SPDX-License-Identifier: Apache-2.0
// Numbers in their ASCII spellings. Private to the room.
#pragma once

#include <optional>
#include <string>

namespace candela {

struct TextNumber {
    double value = 0;
    float single = 0;   ///< The float that is nearest to the text, if not always to `value`.
    bool whole = false; ///< Written as an integer.
};

/// What a word says: also ".5", "+1.", "nan" and "-infinity", which programs print for numbers that
/// are none. Nothing if it is no number.
std::optional<TextNumber> parseNumber(const std::string &word);

/// The number that begins here, if it is a plain one (digits, a point, an exponent) and something
/// follows it before `end`: where it ends, or null. One that rounds to another float by way of a
/// double is not plain.
const char *parsePlainNumber(const char *begin, const char *end, TextNumber &);

} // namespace candela
