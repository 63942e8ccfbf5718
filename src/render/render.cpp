// SPDX-License-Identifier: Apache-2.0
#include "render/render.h"

#include "foundation/base/parallel.h"
#include "interface/ri/graphics_state.h"
#include "interface/rib/rib_reader.h"
#include "light/frame/shader_warnings.h"
#include "render/console.h"
#include "render/frame.h"
#include "render/interrupt.h"
#include "render/shader_folders.h"
#include "render/statistics.h"
#include "render/texture_orders.h"

#include <filesystem>
#include <new>
#include <unistd.h>

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
                                      settings.allowPrograms};
    result.makeTexture = [=, &diagnostics](const TextureOrder &order, const Options &options) {
        makeOrderedTexture(order, options, orders, diagnostics);
    };
    result.searchPaths = {joinFolders(settings.shaderPath), joinFolders(settings.texturePath),
                          joinFolders(settings.archivePath)};
    result.overrideOptions = [&](Options &options) { overrideOptions(settings, options); };
    return result;
}

} // namespace

int renderFile(const std::string &path, const RenderSettings &settings) {
    Console console(!settings.quiet && isatty(STDERR_FILENO));
    ErrorPolicy diagnostics(console);
    ThreadLimit threads(settings.threads);
    Statistics statistics;

    ShaderFolders folders = shaderFolders(path, settings.shaderPath, diagnostics);
    ShaderLibrary shaders({std::move(folders.all), std::move(folders.library), settings.jit,
                           textureFolders(path, settings)},
                          diagnostics);
    ShaderWarnings warnings(diagnostics);
    bool sawWorld = false, interrupted = false;
    SceneCompiler world(shaders, diagnostics, [&](const Scene &scene) {
        sawWorld = true;
        warnings.look(scene);
        if (!diagnostics.stopped() && !interrupted)
            interrupted =
                !renderFrame(scene, shaders, settings, path, {diagnostics, console, statistics});
    });
    GraphicsState state(world, shaders, diagnostics, stateSettings(path, settings, diagnostics));

    try {
        RibReader(state, diagnostics).readFile(path);
        state.finish();
    } catch (const std::bad_alloc &) {
        diagnostics.error({std::make_shared<const std::string>(path)},
                          "there is not enough memory to read it; what is left of it is not "
                          "rendered");
    }
    if (!sawWorld && !console.failed())
        diagnostics.warning({std::make_shared<const std::string>(path)},
                            "there is no WorldBegin in it: nothing is rendered");
    statistics.add(shaders.statistics());
    if (!settings.statisticsFile.empty())
        statistics.write(settings.statisticsFile, diagnostics);
    return interrupted ? statusOfInterrupt : console.failed() ? 1 : 0;
}

} // namespace candela
