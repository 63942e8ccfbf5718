// SPDX-License-Identifier: Apache-2.0
#include "render/shader_folders.h"

#include "foundation/base/installation.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>

namespace candela {

namespace {

namespace fs = std::filesystem;

void add(std::vector<std::string> &folders, const fs::path &folder) {
    std::error_code ignored;
    if (!fs::is_directory(folder, ignored) ||
        std::ranges::find(folders, folder.string()) != folders.end())
        return;
    folders.push_back(folder.string());
    for (const char *kind :
         {"surface", "light", "displacement", "volume", "imager", "filter", "include"})
        if (fs::is_directory(folder / kind, ignored))
            folders.push_back((folder / kind).string());
}

} // namespace

ShaderFolders shaderFolders(const std::string &ribFile, const std::vector<std::string> &shaderPath,
                            DiagnosticSink &diagnostics) {
    std::vector<std::string> listed, shipped;
    if (const char *variable = std::getenv("CANDELA_SHADERS")) {
        std::istringstream list(variable);
        for (std::string folder; std::getline(list, folder, ':');)
            add(listed, folder);
    }
    if (const auto library = installedPath("share/candela/shaders"))
        add(shipped, *library);
    else if (!std::getenv("CANDELA_SHADERS"))
        diagnostics.warning({}, "the shaders that come with Candela are not where they belong, in "
                                "share/candela/shaders beside the folder of the program or "
                                "library; set CANDELA_SHADERS to where they are");

    ShaderFolders folders;
    for (const std::string &folder : shaderPath)
        add(folders.all, folder);
    fs::path beside = fs::path(ribFile).parent_path();
    if (beside.empty())
        beside = ".";
    add(folders.all, beside);
    for (const char *neighbour : {"shaders", "../shaders"})
        add(folders.all, (beside / neighbour).lexically_normal());
    add(folders.all, ".");
    for (const auto *library : {&listed, &shipped})
        for (const std::string &folder : *library)
            if (std::ranges::find(folders.all, folder) == folders.all.end())
                folders.all.push_back(folder);
    folders.library = shipped.empty() ? listed : shipped;
    return folders;
}

std::string joinFolders(const std::vector<std::string> &folders) {
    std::string joined;
    for (const std::string &folder : folders)
        joined += (joined.empty() ? "" : ":") + folder;
    return joined;
}

} // namespace candela
