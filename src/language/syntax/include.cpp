// SPDX-License-Identifier: Apache-2.0
#include "language/syntax/include.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>

namespace candela::sl {

static constexpr uintmax_t fileSizeLimit = 16 << 20;

IncludeName includeName(const std::vector<Token> &line) {
    IncludeName result;
    result.angled = !line.empty() && line[0].is("<");
    if (!line.empty() && line[0].kind == TokenKind::Text)
        result.name = line[0].text;
    for (size_t i = 1; result.angled && i < line.size() && !line[i].is(">"); ++i)
        result.name += line[i].spelling;
    return result;
}

static std::optional<std::string> readFile(const std::filesystem::path &path) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error) ||
        std::filesystem::file_size(path, error) > fileSizeLimit || error)
        return std::nullopt;
    std::ifstream stream(path, std::ios::binary);
    if (!stream)
        return std::nullopt;
    return std::string(std::istreambuf_iterator<char>(stream), {});
}

std::unique_ptr<SourceFile> readInclude(const IncludeName &include, const Place &where,
                                        const std::vector<std::string> &folders,
                                        Reporter &reporter) {
    std::vector<std::filesystem::path> searched(folders.begin(), folders.end());
    auto own = std::filesystem::path(where.file->name()).parent_path();
    searched.insert(include.angled ? searched.end() : searched.begin(), own);
    std::string list;
    for (const auto &folder : searched) {
        auto path = folder / include.name;
        if (std::optional<std::string> text = readFile(path))
            return std::make_unique<SourceFile>(path.string(), *text);
        list += (list.empty() ? "" : ", ") + (folder.empty() ? "." : folder.string());
    }
    reporter.error(where, "cannot read \"" + include.name + "\"; searched: " + list);
    return nullptr;
}

} // namespace candela::sl
