// SPDX-License-Identifier: Apache-2.0
// Blocks, the dictionary and the error handler.
#include "interface/ri/raster_detail.h"
#include "interface/ri/search_path.h"
#include "interface/ri/state_handlers.h"

#include <filesystem>
#include <map>
#include <new>

namespace candela {

StateHandlers::StateHandlers(SceneBuilder &builder, ShaderLookup &shaders,
                             RequestDiagnostics &diagnostics, GraphicsStateSettings settings)
    : builder_(builder), diagnostics_(diagnostics), settings_(std::move(settings)),
      parameters_(shaders, diagnostics), object_(builder) {
    auto setPath = [&](const char *kind, const std::string &text) {
        Declaration type{StorageClass::Uniform, ValueType::String, 1};
        state_.options.named[std::string("searchpath:") + kind] = {
            kind, type, {}, {expandSearchPath(text, "", "")}};
    };
    setPath("shader", settings_.searchPaths.shader);
    setPath("texture", settings_.searchPaths.texture);
    setPath("archive", settings_.searchPaths.archive);
}

std::optional<std::string> StateHandlers::locate(const char *path, const std::string &name,
                                                 const SourceLocation &where) const {
    std::vector<std::string> folders = searchFolders(state_.options, path);
    for (std::string &folder : splitSearchPath(settings_.searchPaths.archive))
        folders.push_back(std::move(folder));
    if (where.file) {
        std::string folder = std::filesystem::path(*where.file).parent_path().string();
        folders.push_back(folder.empty() ? "." : folder);
    }
    folders.push_back(".");
    auto found = findFile(name, folders);
    if (!found && std::string_view(path) == "archive") {
        found = findNamesake(name, folders);
        if (found)
            diagnostics_.warnOnce(where, "namesake " + name,
                                  "there is no archive '" + name + "'; " + *found +
                                      " is taken in its place");
    }
    return found;
}

float StateHandlers::detailOf(const std::array<float, 6> &bound) const {
    return rasterDetail(bound, state_.transform.current.matrix, state_.options);
}

void StateHandlers::declare(const SourceLocation &where, const std::string &name,
                            const std::string &text) {
    parameters_.declare(where, name, text);
}

void StateHandlers::errorHandler(const SourceLocation &where, const std::string &handler) {
    if (handler == "ignore")
        diagnostics_.policy().setMode(ErrorPolicy::Mode::Ignore);
    else if (handler == "print")
        diagnostics_.policy().setMode(ErrorPolicy::Mode::Print);
    else if (handler == "abort")
        diagnostics_.policy().setMode(ErrorPolicy::Mode::Abort);
    else
        diagnostics_.error(where, "ErrorHandler",
                           "'" + handler +
                               "' is unknown: expected \"ignore\", \"print\" or \"abort\"");
}

void StateHandlers::saveFrame() { savedFrames_.push_back(state_); }

void StateHandlers::restoreFrame() {
    state_ = std::move(savedFrames_.back());
    savedFrames_.pop_back();
    ++lightLists_;
}

void StateHandlers::saveBlock(bool attributes) {
    savedBlocks_.push_back(
        {state_.transform, attributes ? state_.attributes : nullptr, state_.scopedSystems});
}

void StateHandlers::restoreBlock() {
    SavedBlock &saved = savedBlocks_.back();
    state_.transform = saved.transform;
    if (saved.attributes) {
        state_.attributes = std::move(saved.attributes);
        state_.scopedSystems = std::move(saved.scopedSystems);
    }
    savedBlocks_.pop_back();
}

void StateHandlers::frameBegin(const SourceLocation &, int number) {
    saveFrame();
    state_.options.frame = number;
}

void StateHandlers::frameEnd(const SourceLocation &) { restoreFrame(); }

/// Lights that were declared where the camera's motion stood already stand still in the world.
void StateHandlers::keepLightsInTheWorld() {
    const TransformMotion::Shared &camera = state_.options.camera.motion;
    for (auto &light : state_.lights.all) {
        const MotionTransform &placed = light->shader.currentFromShader;
        if (!camera || !placed.motion || !placed.motion->movesLike(*camera))
            continue;
        auto still = std::make_shared<LightRecord>(*light);
        still->shader.currentFromShader = {
            placed.motion->at(state_.options.camera.shutterOpen).rounded(), nullptr};
        light = std::move(still);
    }
}

void StateHandlers::worldBegin(const SourceLocation &where) {
    saveFrame();
    if (state_.transform.current.flat) {
        diagnostics_.error(
            where, "WorldBegin",
            "the transformation from world to camera is singular (it flattens space); the world "
            "is seen without it");
        state_.transform.current = {};
    }
    // Current space is the camera's when the shutter opens; what moves is the camera in it.
    state_.options.camera.motion = std::move(state_.transform.current.motion);
    if (state_.options.camera.motion)
        assign(state_.transform.current,
               state_.options.camera.motion->at(state_.options.camera.shutterOpen));
    keepLightsInTheWorld();
    const Matrix4 cameraFromWorld = state_.transform.current.matrix.rounded();
    state_.options.camera.cameraFromWorld = cameraFromWorld;
    state_.options.camera.exactCameraFromWorld = state_.transform.current.matrix;
    state_.options.coordinateSystems["world"] = cameraFromWorld;
    state_.options.coordinateSystems["camera"] = Matrix4{};
    state_.coordinateSystems["world"] = state_.transform.current;
    state_.coordinateSystems["camera"] = {};
    state_.transform.base = state_.transform.current;
    state_.inWorld = true;
    if (settings_.overrideOptions)
        settings_.overrideOptions(state_.options);
    builder_.worldBegin(state_.options);
    tellKeptObjects(builder_, state_.objects);
    for (const auto &light : state_.lights.all)
        builder_.light(light);
}

void StateHandlers::worldEnd(const SourceLocation &where) {
    try {
        builder_.worldEnd();
    } catch (const std::bad_alloc &) {
        diagnostics_.error(where, "WorldEnd",
                           "there is not enough memory for this world; it is not rendered");
    }
    restoreFrame();
}

void StateHandlers::attributeBegin(const SourceLocation &) { saveBlock(true); }

void StateHandlers::attributeEnd(const SourceLocation &) { restoreBlock(); }

void StateHandlers::transformBegin(const SourceLocation &) { saveBlock(false); }

void StateHandlers::transformEnd(const SourceLocation &) { restoreBlock(); }

void StateHandlers::solidBegin(const SourceLocation &where, const std::string &operation) {
    static const std::map<std::string, SolidOperation> known{
        {"primitive", SolidOperation::Primitive},
        {"union", SolidOperation::Union},
        {"intersection", SolidOperation::Intersection},
        {"difference", SolidOperation::Difference}};
    const auto found = known.find(operation);
    if (found == known.end())
        diagnostics_.error(where, "SolidBegin",
                           "'" + operation +
                               "' is unknown: expected \"primitive\", \"union\", "
                               "\"intersection\" or \"difference\"; it is read as a union");
    object_.tell(found == known.end() ? SolidOperation::Union : found->second);
    saveBlock(true);
}

void StateHandlers::solidEnd(const SourceLocation &) {
    restoreBlock();
    object_.tell(SolidEnding{});
}

} // namespace candela
