// SPDX-License-Identifier: Apache-2.0
// Which lights a light loop listens to (RI 3.2 light categories).
#pragma once

#include <string>
#include <vector>

namespace candela {

/// What a light shader says of itself in __category, __nondiffuse and __nonspecular.
struct LightTags {
    std::vector<std::string> categories;
    bool nonDiffuse = false, nonSpecular = false;
};

/// "a, b" as words.
std::vector<std::string> categoryWords(const std::string &);

/// Does a loop of category `expression` ("a,-b", "!diffuse", "!specular") hear the light? Words
/// with a minus exclude, "!" words refuse lights marked so, and of the others one must match.
bool categoryAccepts(const std::string &expression, const LightTags &);

} // namespace candela
