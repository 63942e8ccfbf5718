// SPDX-License-Identifier: Apache-2.0
#include "render/read_scenes.h"

#include "foundation/base/parallel.h"
#include "image/display_planes.h"
#include "interface/ri/graphics_state.h"
#include "interface/rib/fingerprint_sink.h"
#include "interface/rib/rib_reader.h"
#include "interface/rib/world_fingerprint.h"
#include "light/frame/light_warnings.h"
#include "light/frame/shader_warnings.h"
#include "render/shader_folders.h"
#include "render/texture_orders.h"

#include <filesystem>
#include <fmt/format.h>
#include <new>

namespace candela {

namespace {

/// What a scene that names no display is written as: its own name; RI's for one that has none.
std::string pictureName(const std::string &ribFile) {
    std::filesystem::path name = std::filesystem::path(ribFile).filename();
    if (name.extension() == ".gz")
        name = name.stem();
    return name.empty() || name == "-" ? "ri.exr" : name.stem().string() + ".exr";
}

/// The last word on the options is the command line's.
void overrideOptions(const RenderSettings &settings, Options &options) {
    if (settings.samplesPerPixel) {
        options.xSamples = float(*settings.samplesPerPixel);
        options.ySamples = 1;
        options.pixelVariance.reset(); // That many are wanted.
    }
    if (settings.pixelVariance)
        options.pixelVariance = settings.pixelVariance;
    if (settings.crop) {
        options.format.cropWindow = *settings.crop;
        options.places.cropWindow = {};
    }
    if (settings.resolution) {
        options.format.xResolution = (*settings.resolution)[0];
        options.format.yResolution = (*settings.resolution)[1];
        options.places.format = {};
    }
    if (settings.integrator) {
        Parameter &integrator = options.named["render:integrator"];
        integrator = {"integrator", {StorageClass::Uniform, ValueType::String, 1}, {}, {}};
        integrator.strings = {*settings.integrator};
    }
}

/// Behind the RIB's own search path. What a frame has written the next ones may read.
std::vector<std::string> textureFolders(const std::string &ribFile,
                                        const RenderSettings &settings) {
    std::vector<std::string> folders = settings.texturePath;
    const std::string beside = std::filesystem::path(ribFile).parent_path().string();
    folders.insert(folders.end(), {settings.outputDirectory, beside.empty() ? "." : beside, "."});
    return folders;
}

GraphicsStateSettings stateSettings(const std::string &ribFile, const RenderSettings &settings,
                                    DiagnosticSink &diagnostics) {
    GraphicsStateSettings result;
    const TextureOrderSettings orders{textureFolders(ribFile, settings),
                                      {settings.outputDirectory, settings.trust}};
    result.makeTexture = [=, &diagnostics](const TextureOrder &order, const Options &options) {
        makeOrderedTexture(order, options, orders, diagnostics);
    };
    result.searchPaths = {joinFolders(settings.shaderPath), joinFolders(settings.texturePath),
                          joinFolders(settings.archivePath)};
    result.overrideOptions = [&settings, picture = pictureName(ribFile)](Options &options) {
        overrideOptions(settings, options);
        if (options.displays.empty())
            options.displays.push_back(defaultDisplay(picture));
    };
    return result;
}

ShaderLibrary libraryFor(const std::string &ribFile, const RenderSettings &settings,
                         DiagnosticSink &diagnostics) {
    ShaderFolders folders = shaderFolders(ribFile, settings.shaderPath, diagnostics);
    return ShaderLibrary({std::move(folders.all), std::move(folders.library), settings.jit,
                          textureFolders(ribFile, settings)},
                         diagnostics);
}

std::unique_ptr<FrameChooser> makeChooser(const RenderSettings &settings, RequestSink &sink) {
    return settings.frames.empty() ? nullptr
                                   : std::make_unique<FrameChooser>(sink, settings.frames);
}

std::unique_ptr<StreamFingerprint> makeFingerprint(const RenderSettings &settings,
                                                   RequestSink &sink) {
    const bool isWanted = !settings.checkpointFile.empty() || !settings.resumeFile.empty();
    return isWanted ? std::make_unique<StreamFingerprint>(sink) : nullptr;
}

std::unique_ptr<WorldFingerprint> makeWorldFingerprint(const RenderSettings &settings,
                                                       RequestSink &sink) {
    return settings.solutionFile.empty() ? nullptr : std::make_unique<WorldFingerprint>(sink);
}

/// Where requests go that pass `before`, if there is one, on their way to `sink`.
RequestSink &firstOf(RequestSink *before, RequestSink &sink) { return before ? *before : sink; }

} // namespace

struct SceneReading::State {
    State(const std::string &name, const RenderSettings &settings, const FrameListeners &listeners,
          SceneReceiver receive)
        : name(name), listeners(listeners), receive(std::move(receive)),
          shaders(libraryFor(name, settings, listeners.diagnostics)),
          shaderWarnings(listeners.diagnostics),
          world(shaders, listeners.diagnostics, [this](const Scene &scene) { take(scene); }),
          graphics(world, shaders, listeners.diagnostics,
                   stateSettings(name, settings, listeners.diagnostics)),
          chooser(makeChooser(settings, graphics)),
          ofWorld(makeWorldFingerprint(settings, firstOf(chooser.get(), graphics))),
          fingerprint(
              makeFingerprint(settings, firstOf(ofWorld.get(), firstOf(chooser.get(), graphics)))),
          reader(
              firstOf(fingerprint.get(), firstOf(ofWorld.get(), firstOf(chooser.get(), graphics))),
              listeners.diagnostics, {settings.trust, {}}) {}

    void take(const Scene &scene) {
        sawWorld = true;
        shaderWarnings.look(scene);
        warnOfLights(scene, listeners.diagnostics);
        if (!listeners.diagnostics.stopped())
            receive(scene, shaders,
                    {fingerprint ? fingerprint->text() : "", ofWorld ? ofWorld->text() : ""});
    }

    const std::string name;
    const FrameListeners listeners;
    SceneReceiver receive;
    ShaderLibrary shaders;
    ShaderWarnings shaderWarnings;
    SceneCompiler world;
    GraphicsState graphics;
    std::unique_ptr<FrameChooser> chooser;          ///< Null where all frames are wanted.
    std::unique_ptr<WorldFingerprint> ofWorld;      ///< Null unless a solution is to be kept.
    std::unique_ptr<StreamFingerprint> fingerprint; ///< Null unless there are to be checkpoints.
    RibReader reader;
    bool sawWorld = false;
};

SceneReading::SceneReading(const std::string &name, const RenderSettings &settings,
                           const FrameListeners &listeners, SceneReceiver receive)
    : state_(std::make_unique<State>(name, settings, listeners, std::move(receive))) {}
SceneReading::~SceneReading() = default;

RibReader &SceneReading::reader() { return state_->reader; }

void SceneReading::finish(bool cut) {
    if (!cut)
        state_->graphics.finish();
    const FrameListeners &listeners = state_->listeners;
    const FrameChooser *chooser = state_->chooser.get();
    for (const auto &[first, last] : chooser ? chooser->missing() : FrameNumbers())
        listeners.diagnostics.warning(
            {}, first == last ? fmt::format("there is no frame {}", first)
                              : fmt::format("there is no frame of {} to {}", first, last));
    if (!state_->sawWorld && !listeners.console.failed())
        listeners.diagnostics.warning({std::make_shared<const std::string>(state_->name)},
                                      "there is no WorldBegin in it: nothing is rendered");
    listeners.statistics.add(state_->shaders.statistics());
}

void readScenes(const std::vector<std::string> &paths, const RenderSettings &settings,
                const FrameListeners &listeners, const SceneReceiver &receive) {
    SceneReading scenes(paths.front(), settings, listeners, receive);
    bool cut = false;
    std::string path;
    try {
        for (const std::string &next : paths) {
            path = next;
            scenes.reader().readFile(path);
        }
    } catch (const std::bad_alloc &) {
        listeners.diagnostics.error({std::make_shared<const std::string>(path)},
                                    "there is not enough memory to read it; what is left of it is "
                                    "not rendered");
        cut = true;
    }
    scenes.finish(cut);
}

} // namespace candela
