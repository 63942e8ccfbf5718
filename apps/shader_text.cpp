// SPDX-License-Identifier: Apache-2.0
#include "apps/shader_text.h"

#include "foundation/base/whole_file.h"
#include "interface/ri/search_path.h"
#include "language/syntax/include.h"
#include "world/shading/shader_source.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <unistd.h>

namespace candela {

std::optional<std::string> readSource(const std::string &name, std::string &problem) {
    const int file = name == "-" ? ::dup(STDIN_FILENO) : ::open(name.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0) {
        problem = std::strerror(errno);
        return std::nullopt;
    }
    auto text = readAll(file, problem, sl::sourceSizeLimit);
    ::close(file);
    return text;
}

std::optional<sl::SourceText>
readShader(const std::string &name, const std::vector<std::string> &folders, std::string &problem) {
    std::error_code none;
    std::string path = name;
    if (name != "-" && !std::filesystem::exists(name, none)) {
        const auto found = findFile(plainShaderName(name) + ".sl", folders);
        if (!found) {
            problem = "no shader \"" + name +
                      "\": it is no file, and no such .sl file lies on the "
                      "shader path or in the library";
            return std::nullopt;
        }
        path = *found;
    }
    auto text = readSource(path, problem);
    if (!text) {
        problem = "cannot read the shader file \"" + path + "\": " + problem;
        return std::nullopt;
    }
    return sl::SourceText{path == "-" ? "standard input" : path, std::move(*text)};
}

std::string flawOfDefine(const std::string &text) {
    const std::string name = text.substr(0, text.find('='));
    const auto isLetter = [](unsigned char c) { return std::isalpha(c) || c == '_'; };
    const bool isName =
        !name.empty() && isLetter(name[0]) &&
        std::ranges::all_of(name, [&](unsigned char c) { return isLetter(c) || std::isdigit(c); });
    return isName ? "" : "expected NAME or NAME=VALUE, not '" + text + "'";
}

std::pair<std::string, std::string> defineOf(const std::string &text) {
    const size_t equals = text.find('=');
    return equals == std::string::npos ? std::pair(text, std::string("1"))
                                       : std::pair(text.substr(0, equals), text.substr(equals + 1));
}

} // namespace candela
