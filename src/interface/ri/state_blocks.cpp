// SPDX-License-Identifier: Apache-2.0
// Blocks, the dictionary and the error handler.
#include "interface/ri/search_path.h"
#include "interface/ri/state_handlers.h"

#include <cmath>
#include <filesystem>
#include <new>

namespace candela {

StateHandlers::StateHandlers(SceneBuilder &builder, ShaderLookup &shaders, ErrorPolicy &diagnostics,
                             GraphicsStateSettings settings)
    : builder_(builder), shaders_(shaders), diagnostics_(diagnostics),
      settings_(std::move(settings)) {
    auto setPath = [&](const char *kind, const std::string &text) {
        Declaration type{StorageClass::Uniform, ValueType::String, 1};
        options_.named[std::string("searchpath:") + kind] = {
            kind, type, {}, {expandSearchPath(text, "", "")}};
    };
    setPath("shader", settings_.searchPaths.shader);
    setPath("texture", settings_.searchPaths.texture);
    setPath("archive", settings_.searchPaths.archive);
}

void StateHandlers::error(const SourceLocation &where, const char *request,
                          const std::string &message) {
    diagnostics_.error(where, std::string(request) + ": " + message);
}

void StateHandlers::warnOnce(const SourceLocation &where, const std::string &about,
                             const std::string &message) {
    if (warned_.insert(about).second)
        diagnostics_.warning(where, message);
}

bool StateHandlers::finite(const SourceLocation &where, const char *request,
                           std::initializer_list<float> values) {
    for (float value : values)
        if (!std::isfinite(value)) {
            error(where, request, "expected finite numbers; the request is left out");
            return false;
        }
    return true;
}

std::optional<std::string> StateHandlers::findArchive(const std::string &name,
                                                      const SourceLocation &where) const {
    std::vector<std::string> folders = searchFolders(options_, "archive");
    for (std::string &folder : splitSearchPath(settings_.searchPaths.archive))
        folders.push_back(std::move(folder));
    if (where.file) {
        std::string folder = std::filesystem::path(*where.file).parent_path().string();
        folders.push_back(folder.empty() ? "." : folder);
    }
    folders.push_back(".");
    return findFile(name, folders);
}

void StateHandlers::declare(const SourceLocation &where, const std::string &name,
                            const std::string &text) {
    if (auto declaration = parseDeclaration(text))
        dictionary_.declare(name, *declaration);
    else
        error(where, "Declare",
              "'" + text + "' is no declaration: expected \"[class] type[n]\", for example " +
                  "\"varying color\" or \"float[2]\"");
}

void StateHandlers::errorHandler(const SourceLocation &where, const std::string &handler) {
    if (handler == "ignore")
        diagnostics_.setMode(ErrorPolicy::Mode::Ignore);
    else if (handler == "print")
        diagnostics_.setMode(ErrorPolicy::Mode::Print);
    else if (handler == "abort")
        diagnostics_.setMode(ErrorPolicy::Mode::Abort);
    else
        error(where, "ErrorHandler",
              "'" + handler + "' is unknown: expected \"ignore\", \"print\" or \"abort\"");
}

void StateHandlers::saveGlobals() {
    savedGlobals_.push_back(
        {options_, attributes_, ctm_, base_, coordinateSystems_, lights_, objects_});
}

void StateHandlers::restoreGlobals() {
    GlobalState &saved = savedGlobals_.back();
    options_ = std::move(saved.options);
    attributes_ = std::move(saved.attributes);
    ctm_ = saved.ctm;
    base_ = saved.base;
    coordinateSystems_ = std::move(saved.coordinateSystems);
    lights_ = std::move(saved.lights);
    objects_ = std::move(saved.objects);
    savedGlobals_.pop_back();
}

void StateHandlers::frameBegin(const SourceLocation &, int number) {
    saveGlobals();
    options_.frame = number;
}

void StateHandlers::frameEnd(const SourceLocation &) { restoreGlobals(); }

void StateHandlers::worldBegin(const SourceLocation &where) {
    saveGlobals();
    if (ctm_.flat) {
        error(where, "WorldBegin",
              "the transformation from world to camera is singular (it flattens space); the world "
              "is seen without it");
        ctm_ = {};
    }
    const Matrix4 cameraFromWorld = ctm_.matrix.rounded();
    options_.camera.cameraFromWorld = cameraFromWorld;
    options_.coordinateSystems["world"] = cameraFromWorld;
    options_.coordinateSystems["camera"] = Matrix4{};
    coordinateSystems_["world"] = ctm_;
    coordinateSystems_["camera"] = {};
    base_ = ctm_;
    inWorld_ = true;
    if (settings_.overrideOptions)
        settings_.overrideOptions(options_);
    builder_.worldBegin(options_);
    tellKeptObjects();
    for (const auto &light : lights_.all)
        builder_.light(light);
}

void StateHandlers::worldEnd(const SourceLocation &where) {
    try {
        builder_.worldEnd();
    } catch (const std::bad_alloc &) {
        error(where, "WorldEnd", "there is not enough memory for this world; it is not rendered");
    }
    inWorld_ = false;
    restoreGlobals();
}

void StateHandlers::attributeBegin(const SourceLocation &) {
    savedAttributes_.push_back(attributes_);
    savedTransforms_.push_back(ctm_);
}

void StateHandlers::attributeEnd(const SourceLocation &) {
    attributes_ = std::move(savedAttributes_.back());
    savedAttributes_.pop_back();
    ctm_ = savedTransforms_.back();
    savedTransforms_.pop_back();
}

void StateHandlers::transformBegin(const SourceLocation &) { savedTransforms_.push_back(ctm_); }

void StateHandlers::transformEnd(const SourceLocation &) {
    ctm_ = savedTransforms_.back();
    savedTransforms_.pop_back();
}

void StateHandlers::solidBegin(const SourceLocation &where, const std::string &) {
    warnOnce(where, "SolidBegin",
             "SolidBegin: this version draws the primitives of a solid one by one, without "
             "cutting them against each other");
    attributeBegin(where);
}

void StateHandlers::solidEnd(const SourceLocation &where) { attributeEnd(where); }

} // namespace candela
