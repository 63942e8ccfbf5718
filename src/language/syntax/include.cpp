// SPDX-License-Identifier: Apache-2.0
#include "language/syntax/include.h"

#include "foundation/base/whole_file.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>

namespace candela::sl {

IncludeName includeName(const std::vector<Token> &line) {
    IncludeName result;
    result.angled = !line.empty() && line[0].is("<");
    if (!line.empty() && line[0].kind == TokenKind::Text)
        result.name = line[0].text;
    for (size_t i = 1; result.angled && i < line.size() && !line[i].is(">"); ++i)
        result.name += line[i].spelling;
    return result;
}

/// Lines of other files are nobody's business: a shader of unknown origin may name any.
static bool isNamedAsSource(const std::filesystem::path &path) {
    constexpr std::array<std::string_view, 8> extensions = {".h",   ".sl",  ".slh",  ".inc",
                                                            ".rsl", ".hpp", ".slim", ".cpp"};
    return std::ranges::find(extensions, path.extension().string()) != extensions.end();
}

std::unique_ptr<SourceFile> readInclude(const IncludeName &include, const Place &where,
                                        const std::vector<std::string> &folders,
                                        Reporter &reporter) {
    std::vector<std::filesystem::path> searched(folders.begin(), folders.end());
    auto own = std::filesystem::path(where.file->name()).parent_path();
    searched.insert(include.angled ? searched.end() : searched.begin(), own);
    std::string list;
    for (const auto &folder : searched) {
        const auto path = folder / include.name;
        std::error_code error;
        if (std::filesystem::is_regular_file(path, error)) {
            std::string problem;
            if (auto text = readWholeFile(path.string(), problem, sourceSizeLimit))
                return std::make_unique<SourceFile>(path.string(), *text, isNamedAsSource(path));
            reporter.error(where, problem);
            return nullptr;
        }
        // What is not there may be named by what the environment holds.
        if (folder.empty() || std::filesystem::is_directory(folder, error))
            list += (list.empty() ? "" : ", ") + (folder.empty() ? "." : folder.string());
    }
    reporter.error(where, "cannot read \"" + include.name + "\"; searched: " + list);
    return nullptr;
}

} // namespace candela::sl
