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

std::optional<fs::path> installedPath(const std::string &relative) {
    static const fs::path code = fileOfThisCode();
    std::error_code error;
    const auto in = [&](const fs::path &folder) {
        const fs::path path = fs::canonical(folder / relative, error);
        return error ? std::nullopt : std::optional(path);
    };
    for (fs::path folder = code.parent_path(); folder.has_relative_path();
         folder = folder.parent_path())
        if (const auto found = in(folder))
            return found;
    return in(CANDELA_PREFIX);
}

} // namespace candela
