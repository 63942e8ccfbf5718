// SPDX-License-Identifier: Apache-2.0
#include "image/output_path.h"

#include <algorithm>
#include <filesystem>

namespace candela {

namespace fs = std::filesystem;

static bool liesWithin(const fs::path &path, const fs::path &folder) {
    const auto [end, unused] =
        std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
    return end == folder.end();
}

std::optional<std::string> outputPath(const std::string &name, const std::string &directory,
                                      bool allowOutside, std::string &note, std::string &problem) {
    const auto fail = [&](const std::string &what) {
        problem = "cannot write " + name + ": " + what;
        return std::nullopt;
    };
    if (name.empty() || name.find('\0') != std::string::npos)
        return fail("a display needs a file name");
    std::error_code error;
    const fs::path folder = fs::absolute(directory.empty() ? "." : directory, error);
    fs::path path = folder / name; // An absolute name stands for itself.
    const fs::path realFolder = fs::weakly_canonical(folder, error);
    if (error)
        return fail(error.message());
    const fs::path realPath = fs::weakly_canonical(path, error);
    if (error)
        return fail(error.message());
    const bool isForeign = name.find('\\') != std::string::npos;
    if (isForeign || (!allowOutside && !liesWithin(realPath, realFolder))) {
        const std::string last = name.substr(name.find_last_of("/\\") + 1);
        path = folder / last;
        if (last.empty() || last == ".." ||
            !liesWithin(fs::weakly_canonical(path, error), realFolder))
            return fail("writes outside the output folder need --trust");
        note = isForeign ? "it will be \"" + last + "\" in the output folder"
                         : "writes outside the output folder need --trust: it will be \"" + last +
                               "\" in it";
    }
    fs::create_directories(path.parent_path(), error);
    if (error)
        return fail("cannot make its folder " + path.parent_path().lexically_normal().string() +
                    ": " + error.message());
    return path.lexically_normal().string();
}

} // namespace candela
