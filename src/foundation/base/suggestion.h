// SPDX-License-Identifier: Apache-2.0
// What somebody may have meant who has slipped in spelling.
#pragma once

#include <string>
#include <vector>

namespace candela {

/// "; did you mean 'x'?" with the candidate that is nearest to the word, or "" if none is near.
std::string suggestion(const std::string &word, const std::vector<std::string> &candidates);

} // namespace candela
