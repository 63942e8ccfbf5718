// SPDX-License-Identifier: Apache-2.0
#include "interface/ri/search_path.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <system_error>

namespace candela {

static std::string environment(const std::string &name) {
    const char *value = std::getenv(name.c_str());
    return value ? value : "";
}

static std::string expandVariables(std::string_view entry) {
    std::string result;
    for (std::size_t i = 0; i < entry.size(); ++i) {
        const bool braced = entry.substr(i).starts_with("${");
        const std::size_t name = i + (braced ? 2 : 1);
        const std::size_t close = braced            ? entry.find('}', name)
                                  : entry[i] == '%' ? entry.find('%', name)
                                                    : std::string_view::npos;
        if (close != std::string_view::npos) {
            result += environment(std::string(entry.substr(name, close - name)));
            i = close;
        } else if (i == 0 && entry[i] == '~' && (entry.size() == 1 || entry[1] == '/')) {
            result += environment("HOME");
        } else {
            result += entry[i];
        }
    }
    return result;
}

std::vector<std::string> splitSearchPath(std::string_view text) {
    std::vector<std::string> result;
    while (!text.empty()) {
        std::string_view entry = text.substr(0, text.find_first_of(":;"));
        text.remove_prefix(std::min(entry.size() + 1, text.size()));
        if (!entry.empty())
            result.emplace_back(entry);
    }
    return result;
}

std::string expandSearchPath(std::string_view text, std::string_view previous,
                             std::string_view standard) {
    std::vector<std::string> folders;
    auto add = [&](std::string_view list) {
        for (std::string &folder : splitSearchPath(list))
            if (folders.size() < mostSearchFolders &&
                std::ranges::find(folders, folder) == folders.end())
                folders.push_back(std::move(folder));
    };
    for (const std::string &entry : splitSearchPath(text))
        add(entry == "&" ? std::string(previous)
                         : (entry == "@" ? std::string(standard) : expandVariables(entry)));
    std::string result;
    for (const std::string &folder : folders)
        result += (result.empty() ? "" : ":") + folder;
    return result;
}

std::vector<std::string> searchFolders(const Options &options, const std::string &kind) {
    return splitSearchPath(options.named.string("searchpath:" + kind, ""));
}

std::optional<std::string> findFile(const std::string &name,
                                    const std::vector<std::string> &folders) {
    namespace fs = std::filesystem;
    auto isFile = [](const fs::path &path) {
        std::error_code error;
        return fs::is_regular_file(path, error);
    };
    if (fs::path(name).is_absolute())
        return isFile(name) ? std::optional(name) : std::nullopt;
    for (const std::string &folder : folders)
        if (fs::path path = fs::path(folder) / name; isFile(path))
            return path.lexically_normal().string();
    return std::nullopt;
}

std::optional<std::string> findNamesake(const std::string &name,
                                        const std::vector<std::string> &folders) {
    const std::size_t end = name.find_last_of("/\\");
    if (end == std::string::npos || end + 1 == name.size())
        return std::nullopt;
    std::string slashed = name;
    std::ranges::replace(slashed, '\\', '/');
    const auto whole = findFile(slashed, folders);
    return whole ? whole : findFile(name.substr(end + 1), folders);
}

std::string withFoldersBeside(const std::string &path, const std::string &file) {
    namespace fs = std::filesystem;
    const fs::path beside = fs::path(file).parent_path();
    if (beside.empty() || beside == ".")
        return path;
    std::string result;
    for (const std::string &entry : splitSearchPath(path)) {
        result += (result.empty() ? "" : ":") + entry;
        const fs::path other = (beside / entry).lexically_normal();
        std::error_code error;
        if (fs::path(entry).is_relative() && fs::is_directory(other, error))
            result += ":" + other.string();
    }
    return result;
}

} // namespace candela
