// SPDX-License-Identifier: Apache-2.0
// Makes a text that fails as small as it gets while it fails the same way.
#pragma once

#include "words.h"

#include <functional>
#include <string>

namespace candela::fuzz {

/// Removes lines and words, ever fewer at a time (Zeller's delta debugging), as long as `fails`
/// says yes to what remains.
std::string reduceText(const std::string &text,
                       const std::function<bool(const std::string &)> &fails);

} // namespace candela::fuzz
