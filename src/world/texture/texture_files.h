// SPDX-License-Identifier: Apache-2.0
// From the names of textures to files.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace candela {

struct FoundTexture {
    std::string path;
    bool isExact = true; ///< The file bears the name; else another extension.
};

/// The file of that name in the first folder that has one; where none has, its namesake of other
/// folders (findNamesake()), or else the first that is called so up to its extension and is a
/// picture: texture("a.tx") takes a.tif.
std::optional<FoundTexture> findTexture(const std::string &name,
                                        const std::vector<std::string> &folders);

} // namespace candela
