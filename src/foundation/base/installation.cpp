// SPDX-License-Identifier: Apache-2.0
#include "foundation/base/installation.h"

#include <cinttypes>
#include <cstdio>
#include <fstream>
#include <system_error>

namespace candela {

namespace fs = std::filesystem;

/// The file that this code has been mapped from, be it a program or a library of another one.
static fs::path fileOfThisCode() {
    const auto here = reinterpret_cast<std::uintptr_t>(&fileOfThisCode);
    std::ifstream mappings("/proc/self/maps"); // "first-last flags offset device inode   path"
    for (std::string line; std::getline(mappings, line);) {
        std::uintptr_t first = 0, last = 0;
        int path = 0;
        if (std::sscanf(line.c_str(), "%" SCNxPTR "-%" SCNxPTR " %*s %*s %*s %*s %n", &first, &last,
                        &path) == 2 &&
            first <= here && here < last)
            return line.substr(std::size_t(path));
    }
    return {};
}

fs::path prefixOf(const fs::path &file) {
    constexpr int deepest = 4; // lib/python3/dist-packages/candela
    const fs::path folder = file.parent_path();
    if (folder.filename() == "bin")
        return folder.parent_path();
    fs::path above = folder;
    for (int level = 0; level <= deepest && above.has_relative_path(); ++level) {
        const std::string name = above.filename().string();
        above = above.parent_path();
        if (name == "lib" || name == "lib64")
            return above;
    }
    return {};
}

std::optional<fs::path> installedPath(const std::string &relative) {
    static const fs::path prefix = prefixOf(fileOfThisCode());
    for (const fs::path &folder : {prefix, fs::path(CANDELA_PREFIX)}) {
        std::error_code error;
        const fs::path path = folder.empty() ? fs::path() : fs::canonical(folder / relative, error);
        if (!error && !path.empty())
            return path;
    }
    return std::nullopt;
}

} // namespace candela
