// SPDX-License-Identifier: Apache-2.0
#include "world/shading/shader_source.h"

#include "foundation/base/whole_file.h"
#include "interface/ri/search_path.h"
#include "language/syntax/include.h"

#include <algorithm>
#include <filesystem>

namespace candela {

namespace {

sl::ShaderKind languageKind(ShaderKind kind) {
    switch (kind) {
    case ShaderKind::Surface: return sl::ShaderKind::Surface;
    case ShaderKind::Light: return sl::ShaderKind::Light;
    case ShaderKind::Displacement: return sl::ShaderKind::Displacement;
    case ShaderKind::Volume: return sl::ShaderKind::Volume;
    case ShaderKind::Imager: return sl::ShaderKind::Imager;
    case ShaderKind::Filter: return sl::ShaderKind::Filter;
    case ShaderKind::Transformation: return sl::ShaderKind::Transformation;
    }
    return sl::ShaderKind::Surface;
}

std::string lastPart(const std::string &name) { return name.substr(name.find_last_of("/\\") + 1); }

} // namespace

std::string plainShaderName(const std::string &name) {
    for (const char *ending : {".slo", ".sdr", ".slx", ".slc", ".sl", ".sdl", ".so"}) {
        std::string_view suffix = ending;
        if (name.size() > suffix.size() && name.ends_with(suffix))
            return name.substr(0, name.size() - suffix.size());
    }
    return name;
}

const sl::TypedShader *ShaderSources::find(ShaderKind kind, const std::string &name,
                                           const std::vector<std::string> &searchPath,
                                           const SourceLocation &where) {
    std::vector<std::string> folders = searchPath;
    for (const std::string &folder : folders_)
        if (std::ranges::find(folders, folder) == folders.end())
            folders.push_back(folder);
    return findIn(folders, kind, name, where);
}

const sl::TypedShader *ShaderSources::findIn(const std::vector<std::string> &folders,
                                             ShaderKind kind, const std::string &name,
                                             const SourceLocation &where) {
    std::string key = std::to_string(int(kind)) + name;
    for (const std::string &folder : folders)
        key += '\n' + folder;
    if (auto known = found_.find(key); known != found_.end())
        return known->second;
    const sl::TypedShader *shader = lookFor(folders, kind, name, where);
    if (shader)
        found_.emplace(std::move(key), shader);
    return shader;
}

/// Those that are there: others may be named by what the environment holds.
static std::string listOf(const std::vector<std::string> &folders) {
    constexpr std::size_t most = 10;
    std::string list;
    std::size_t count = 0;
    std::error_code error;
    for (const std::string &folder : folders)
        if (std::filesystem::is_directory(folder, error) && ++count <= most)
            list += (list.empty() ? "" : ", ") + folder;
    return count > most ? list + " and " + std::to_string(count - most) + " others" : list;
}

const sl::TypedShader *ShaderSources::lookFor(const std::vector<std::string> &folders,
                                              ShaderKind kind, const std::string &name,
                                              const SourceLocation &where) {
    std::string plain = plainShaderName(name);
    const char *kindName = sl::nameOf(languageKind(kind));
    auto reportOnce = [&](const std::string &message) {
        if (!std::exchange(reported_[kindName + plain], true))
            diagnostics_.error(where, message);
    };

    std::optional<std::string> path = findFile(plain + ".sl", folders);
    if (!path)
        path = findNamesake(plain + ".sl", folders);
    if (!path) {
        reportOnce("no shader \"" + name + "\": there is no \"" + plain + ".sl\" in " +
                   listOf(folders));
        return nullptr;
    }
    const sl::CompiledFront *front = load(*path);
    if (!front) {
        reportOnce("shader \"" + name + "\" has errors and is not used");
        return nullptr;
    }
    for (const auto &shader : front->shaders)
        if (shader->kind == languageKind(kind) &&
            (shader->name == lastPart(plain) || front->shaders.size() == 1))
            return shader.get();
    std::string others;
    for (const auto &shader : front->shaders)
        others += (others.empty() ? "" : ", ") + std::string("the ") + sl::nameOf(shader->kind) +
                  " shader \"" + shader->name + "\"";
    reportOnce(*path + " holds " + (others.empty() ? "no shader" : others) + ", and no " +
               kindName + " shader \"" + plain + "\"");
    return nullptr;
}

const sl::CompiledFront *ShaderSources::load(const std::string &path) {
    auto [entry, isNew] = files_.try_emplace(path);
    if (isNew) {
        std::string problem;
        if (const auto text = readWholeFile(path, problem, sl::sourceSizeLimit))
            entry->second = sl::analyzeSource({path, *text}, {folders_, {}, false}, diagnostics_);
        else
            diagnostics_.error({}, problem);
    }
    return entry->second ? &*entry->second : nullptr;
}

} // namespace candela
