// SPDX-License-Identifier: Apache-2.0
#include "render/read_scenes.h"

#include "foundation/base/parallel.h"
#include "interface/ri/graphics_state.h"
#include "interface/rib/rib_reader.h"
#include "light/frame/shader_warnings.h"
#include "render/shader_folders.h"
#include "render/texture_orders.h"

#include <filesystem>
#include <new>

namespace candela {

namespace {

/// The last word on the options is the command line's.
void overrideOptions(const RenderSettings &settings, Options &options) {
    if (settings.samplesPerPixel) {
        options.xSamples = float(*settings.samplesPerPixel);
        options.ySamples = 1;
    }
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
    const TextureOrderSettings orders{textureFolders(ribFile, settings), settings.outputDirectory,
                                      settings.trust};
    result.makeTexture = [=, &diagnostics](const TextureOrder &order, const Options &options) {
        makeOrderedTexture(order, options, orders, diagnostics);
    };
    result.searchPaths = {joinFolders(settings.shaderPath), joinFolders(settings.texturePath),
                          joinFolders(settings.archivePath)};
    result.overrideOptions = [&](Options &options) { overrideOptions(settings, options); };
    return result;
}

} // namespace

void readScenes(const std::string &path, const RenderSettings &settings,
                const FrameListeners &listeners, const SceneReceiver &receive) {
    ErrorPolicy &diagnostics = listeners.diagnostics;
    ShaderFolders folders = shaderFolders(path, settings.shaderPath, diagnostics);
    ShaderLibrary shaders({std::move(folders.all), std::move(folders.library), settings.jit,
                           textureFolders(path, settings)},
                          diagnostics);
    ShaderWarnings warnings(diagnostics);
    bool sawWorld = false;
    SceneCompiler world(shaders, diagnostics, [&](const Scene &scene) {
        sawWorld = true;
        warnings.look(scene);
        if (!diagnostics.stopped())
            receive(scene, shaders);
    });
    GraphicsState state(world, shaders, diagnostics, stateSettings(path, settings, diagnostics));

    try {
        RibReader(state, diagnostics, {settings.trust, {}}).readFile(path);
        state.finish();
    } catch (const std::bad_alloc &) {
        diagnostics.error({std::make_shared<const std::string>(path)},
                          "there is not enough memory to read it; what is left of it is not "
                          "rendered");
    }
    if (!sawWorld && !listeners.console.failed())
        diagnostics.warning({std::make_shared<const std::string>(path)},
                            "there is no WorldBegin in it: nothing is rendered");
    listeners.statistics.add(shaders.statistics());
}

} // namespace candela
