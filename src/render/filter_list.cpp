// SPDX-License-Identifier: Apache-2.0
// `candela filter --list`.
#include "foundation/base/whole_file.h"
#include "language/semantics/front.h"
#include "language/syntax/include.h"
#include "render/console.h"
#include "render/filter_file.h"
#include "render/shader_folders.h"

#include <cstdio>
#include <filesystem>
#include <map>
#include <sstream>

namespace candela {

namespace {

/// Of a comment, the licence's line apart.
std::string firstLine(const std::string &comment) {
    std::istringstream lines(comment);
    for (std::string line; std::getline(lines, line);) {
        const std::size_t start = line.find_first_not_of(" \t*/");
        if (start != line.npos && line.compare(start, 5, "SPDX-") != 0)
            return line.substr(start, line.find_last_not_of(" \t\r*/") + 1 - start);
    }
    return {};
}

std::string lineOf(const sl::TypedShader &shader) {
    std::string line = shader.name + "(";
    for (const sl::Parameter &parameter : shader.parameters) {
        const sl::Symbol &symbol = *parameter.symbol;
        line += (&parameter == shader.parameters.data() ? "" : ", ") +
                std::string(sl::nameOf(symbol.type.base)) + " " + symbol.name;
        if (symbol.type.length > 0)
            line += "[" + std::to_string(symbol.type.length) + "]";
    }
    const std::string about = firstLine(shader.doc);
    return line + ")" + (about.empty() ? "" : "  " + about);
}

/// By name; what the path finds first counts.
void collect(const std::filesystem::path &file, const ShaderFolders &folders,
             std::map<std::string, std::string> &lines, DiagnosticSink &diagnostics) {
    std::string problem;
    const auto text = readWholeFile(file.string(), problem, sl::sourceSizeLimit);
    if (!text)
        return diagnostics.error({}, problem);
    if (text->find("filter") == text->npos) // Surfaces with errors are nobody's concern here.
        return;
    const auto front = sl::analyzeSource({file.string(), *text}, {folders.all, {}}, diagnostics);
    for (std::size_t k = 0; front && k < front->shaders.size(); ++k)
        if (front->shaders[k]->kind == sl::ShaderKind::Filter)
            lines.emplace(front->shaders[k]->name, lineOf(*front->shaders[k]));
}

} // namespace

int listFilters(const FilterFileSettings &settings) {
    Console console(Console::Words::Messages);
    const ShaderFolders folders = shaderFolders("", settings.shaderPath, console);
    std::map<std::string, std::string> lines;
    for (const std::string &folder : folders.all) {
        std::error_code ignored;
        std::map<std::string, std::filesystem::path> files; // Folders have no order of their own.
        for (const auto &entry : std::filesystem::directory_iterator(folder, ignored))
            if (entry.path().extension() == ".sl")
                files[entry.path().string()] = entry.path();
        for (const auto &[name, path] : files)
            collect(path, folders, lines, console);
    }
    for (const auto &[name, line] : lines)
        std::printf("%s\n", line.c_str());
    return console.failed() ? 1 : 0;
}

} // namespace candela
