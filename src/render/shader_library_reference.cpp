// SPDX-License-Identifier: Apache-2.0
#include "render/shader_library_reference.h"

#include "foundation/base/whole_file.h"
#include "language/syntax/include.h"
#include "render/shader_entry.h"
#include "render/shader_folders.h"

#include <algorithm>
#include <filesystem>

namespace candela {

namespace {

namespace fs = std::filesystem;

/// In the order of the reference.
constexpr const char *kinds[] = {"surface", "light", "displacement", "volume", "imager", "filter"};

std::vector<std::string> libraryFolders() {
    DiagnosticList unheard; // Whoever renders is told that the library is missing.
    return shaderFolders("", {}, unheard).library;
}

/// The shader files of the library's folders for a kind, by name.
std::vector<fs::path> filesOf(const char *kind, const std::vector<std::string> &folders) {
    std::vector<fs::path> files;
    for (const fs::path folder : folders) {
        if (folder.filename() != kind)
            continue;
        std::error_code ignored;
        for (const auto &entry : fs::directory_iterator(folder, ignored))
            if (entry.path().extension() == ".sl")
                files.push_back(entry.path());
    }
    std::ranges::sort(files);
    return files;
}

std::vector<std::string> entriesOfFile(const fs::path &file,
                                       const std::vector<std::string> &folders) {
    DiagnosticList unheard; // Whoever renders with the shader is told of its faults.
    std::string problem;
    const auto text = readWholeFile(file.string(), problem, sl::sourceSizeLimit);
    return text ? shaderEntries({file.string(), *text}, folders, unheard)
                : std::vector<std::string>();
}

} // namespace

std::vector<std::string> shaderEntries(const sl::SourceText &source,
                                       const std::vector<std::string> &folders,
                                       DiagnosticSink &diagnostics) {
    std::vector<std::string> entries;
    const auto front = sl::analyzeSource(source, {folders, {}, false}, diagnostics);
    for (std::size_t k = 0; front && k < front->shaders.size(); ++k)
        entries.push_back(entryOf(*front->shaders[k], diagnostics));
    return entries;
}

std::vector<std::string> libraryShaderEntries(const std::string &word) {
    const std::vector<std::string> folders = libraryFolders();
    std::vector<std::string> entries;
    for (const char *kind : kinds)
        for (const fs::path &file : filesOf(kind, folders))
            if (word == "shaders" || word == std::string(kind) + "s" || word == file.stem())
                for (const std::string &entry : entriesOfFile(file, folders))
                    entries.push_back(entry);
    return entries;
}

std::vector<std::string> libraryShaderNames() {
    const std::vector<std::string> folders = libraryFolders();
    std::vector<std::string> names;
    for (const char *kind : kinds)
        for (const fs::path &file : filesOf(kind, folders))
            names.push_back(file.stem().string());
    return names;
}

} // namespace candela
