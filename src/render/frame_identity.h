// SPDX-License-Identifier: Apache-2.0
// What files that are gone on with have been made of, and whether that is what is rendered now.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace candela {

/// All that a result depends on, by name: the scene's requests and shaders (as fingerprints), seed,
/// samples, version and so on.
using FrameIdentity = std::vector<std::pair<std::string, std::string>>;

/// As bytes of a file, and back from the front of them; false if there is too little.
void appendIdentity(std::string &bytes, const FrameIdentity &);
bool takeIdentity(std::string_view &bytes, FrameIdentity &);

/// What the second identity has that the first one has not, in words; empty if nothing.
std::string differenceOf(const FrameIdentity &saved, const FrameIdentity &now);

} // namespace candela
