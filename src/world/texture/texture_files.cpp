// SPDX-License-Identifier: Apache-2.0
#include "world/texture/texture_files.h"

#include "interface/ri/search_path.h"

#include <filesystem>

namespace candela {

/// Ready textures first, then pictures by how much they can hold.
static constexpr const char *extensions[] = {".tx",  ".tex", ".exr",  ".tif", ".tiff", ".hdr",
                                             ".png", ".jpg", ".jpeg", ".tga", ".bmp",  ".sgi",
                                             ".rgb", ".pic", ".env",  ".shd", ".webp", ".gif"};

std::optional<FoundTexture> findTexture(const std::string &name,
                                        const std::vector<std::string> &folders) {
    if (const auto path = findFile(name, folders))
        return FoundTexture{*path, true};
    if (const auto path = findNamesake(name, folders))
        return FoundTexture{*path, false};
    std::filesystem::path other(name);
    if (!other.has_stem())
        return std::nullopt;
    for (const auto find : {findFile, findNamesake})
        for (const char *extension : extensions)
            if (const auto path = find(other.replace_extension(extension).string(), folders))
                return FoundTexture{*path, false};
    return std::nullopt;
}

} // namespace candela
