// SPDX-License-Identifier: Apache-2.0
#include "image/output_path.h"

#include "foundation/base/visible_text.h"
#include "image/picture_marks.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace candela {

namespace {

namespace fs = std::filesystem;

bool liesWithin(const fs::path &path, const fs::path &folder) {
    const auto [end, unused] =
        std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
    return end == folder.end();
}

/// What the name of a picture has that only its owner may want; empty if nothing. Shells list no
/// files with a dot, and take those with a dash for options.
std::string oddityOf(const fs::path &nameInFolder) {
    if (hasControls(nameInFolder.string()))
        return "control characters in file names";
    for (const fs::path &part : nameInFolder)
        if (part.string().starts_with('.') || part.string().starts_with('-'))
            return "file names that begin with \"" + part.string().substr(0, 1) + "\"";
    return {};
}

/// An empty file has nothing to lose.
bool isPictureOrEmpty(const fs::path &path) {
    char beginning[pictureMarkLength];
    std::ifstream file(path, std::ios::binary);
    file.read(beginning, sizeof beginning);
    const std::string_view found(beginning, std::size_t(file.gcount()));
    return file.eof() && found.empty() ? true : looksLikePicture(found);
}

/// Why a stranger's file may not write there; empty if it may.
std::string refusal(const fs::path &path, const fs::path &folder) {
    if (const std::string oddity = oddityOf(path.lexically_relative(folder)); !oddity.empty())
        return oddity + " need --trust";
    std::error_code error;
    if (fs::is_regular_file(path, error) && !isPictureOrEmpty(path))
        return "it is there and no picture; to replace it needs --trust";
    return {};
}

} // namespace

std::optional<std::string> outputPath(const std::string &name, const OutputFolder &output,
                                      std::string &note, std::string &problem) {
    const auto fail = [&](const std::string &what) {
        problem = "cannot write " + name + ": " + what;
        return std::nullopt;
    };
    if (name.empty() || name.find('\0') != std::string::npos)
        return fail("a display needs a file name");
    std::error_code error;
    const fs::path folder =
        fs::absolute(output.directory.empty() ? "." : output.directory, error).lexically_normal();
    const fs::path realFolder = fs::weakly_canonical(folder, error);
    if (error)
        return fail(error.message());
    const auto leadsOutside = [&](const fs::path &path) {
        const fs::path real = fs::weakly_canonical(path, error);
        return error || !liesWithin(real, realFolder);
    };
    fs::path path = (folder / name).lexically_normal(); // An absolute name stands for itself.
    const bool isForeign = name.find('\\') != std::string::npos;
    if (isForeign || (!output.isTrusted && leadsOutside(path))) {
        const std::string last = name.substr(name.find_last_of("/\\") + 1);
        path = folder / last;
        if (last.empty() || last == ".." || leadsOutside(path))
            return fail(error ? error.message() : "writes outside the output folder need --trust");
        note = isForeign ? "it will be \"" + last + "\" in the output folder"
                         : "writes outside the output folder need --trust: it will be \"" + last +
                               "\" in it";
    }
    if (!output.isTrusted)
        if (const std::string why = refusal(path, folder); !why.empty())
            return fail(why);
    fs::create_directories(path.parent_path(), error);
    if (error)
        return fail("cannot make its folder " + path.parent_path().string() + ": " +
                    error.message());
    return path.string();
}

} // namespace candela
