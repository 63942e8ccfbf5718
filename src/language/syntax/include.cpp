// SPDX-License-Identifier: Apache-2.0
#include "language/syntax/include.h"

#include "foundation/base/whole_file.h"

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

std::unique_ptr<SourceFile> readInclude(const IncludeName &include, const Place &where,
                                        const std::vector<std::string> &folders,
                                        Reporter &reporter) {
    std::vector<std::filesystem::path> searched(folders.begin(), folders.end());
    auto own = std::filesystem::path(where.file->name()).parent_path();
    searched.insert(include.angled ? searched.end() : searched.begin(), own);
    std::string list;
    for (const auto &folder : searched) {
        const auto path = folder / include.name;
        if (std::error_code error; std::filesystem::is_regular_file(path, error)) {
            std::string problem;
            if (auto text = readWholeFile(path.string(), problem, sourceSizeLimit))
                return std::make_unique<SourceFile>(path.string(), *text);
            reporter.error(where, problem);
            return nullptr;
        }
        list += (list.empty() ? "" : ", ") + (folder.empty() ? "." : folder.string());
    }
    reporter.error(where, "cannot read \"" + include.name + "\"; searched: " + list);
    return nullptr;
}

} // namespace candela::sl
