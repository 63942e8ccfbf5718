// SPDX-License-Identifier: Apache-2.0
#include "render/render.h"

#include "foundation/base/parallel.h"
#include "image/displays.h"
#include "interface/ri/graphics_state.h"
#include "interface/rib/rib_reader.h"
#include "light/transport/first_hit.h"
#include "light/transport/shader_warnings.h"
#include "render/console.h"
#include "render/shader_folders.h"
#include "render/statistics.h"

#include <cmath>
#include <filesystem>
#include <unistd.h>

namespace candela {

namespace {

constexpr int defaultDepth = 64;

/// The last word on the options is the command line's.
void overrideOptions(const RenderSettings &settings, Options &options) {
    if (settings.samplesPerPixel) {
        options.xSamples = float(*settings.samplesPerPixel);
        options.ySamples = 1;
    }
    if (settings.crop)
        options.cropWindow = *settings.crop;
    if (settings.resolution) {
        options.xResolution = (*settings.resolution)[0];
        options.yResolution = (*settings.resolution)[1];
    }
    if (settings.integrator) {
        Parameter &integrator = options.named["render:integrator"];
        integrator = {"integrator", {StorageClass::Uniform, ValueType::String, 1}, {}, {}};
        integrator.strings = {*settings.integrator};
    }
}

IntegratorSettings integratorSettings(const Scene &scene, const RenderSettings &settings) {
    const Options &options = scene.options();
    IntegratorSettings result;
    result.kind = scene.isClassic() ? IntegratorKind::Classic : IntegratorKind::Path;
    result.samplesPerPixel = std::max(
        1, int(std::lround(std::max(1.0f, options.xSamples) * std::max(1.0f, options.ySamples))));
    result.seed = settings.seed;
    result.maxDepth = int(options.number("trace:maxdepth", defaultDepth));
    result.hemisphereOnly = settings.hemisphereOnly;
    result.crop = options.cropPixels();
    return result;
}

FrameDescription describe(const Scene &scene, const IntegratorSettings &integrator,
                          const std::string &file) {
    FrameDescription description;
    description.metadata = {
        {"renderer", "Candela"},
        {"scene", std::filesystem::path(file).filename().string()},
        {"integrator", integrator.kind == IntegratorKind::Path ? "path" : "classic"},
        {"spp", std::to_string(integrator.samplesPerPixel)},
        {"seed", std::to_string(integrator.seed)},
        {"maxdepth", std::to_string(integrator.maxDepth)},
        {"sampling", integrator.hemisphereOnly ? "hemisphere" : "cones"}};
    const Matrix4 &worldToCamera = scene.options().camera.cameraFromWorld;
    description.worldToCamera = worldToCamera;
    description.worldToNdc = worldToCamera * scene.camera().ndcFromCamera();
    return description;
}

void checkIntegratorName(const Options &options, DiagnosticSink &diagnostics) {
    std::string name = options.string("render:integrator", "path");
    if (name != "path" && name != "classic")
        diagnostics.error({}, "there is no integrator \"" + name +
                                  "\": the known ones are \"path\" and \"classic\"; taking "
                                  "\"path\"");
}

/// One frame: samples to film, film to displays.
void renderFrame(const Scene &scene, const RenderSettings &settings, const std::string &file,
                 Console &console, Statistics &statistics) {
    const Options &options = scene.options();
    checkIntegratorName(options, console);
    const std::vector<DisplayRecord> displays = displaysOf(options);
    IntegratorSettings integrator = integratorSettings(scene, settings);
    integrator.progress = [&](double done) { console.progress(done); };

    PixelFilterSampler filter(options.filter, console);
    const auto [width, height] = options.effectiveResolution();
    const auto [x0, x1, y0, y1] = integrator.crop;
    Film film({{width, height, x0, x1, y0, y1},
               wantedChannels(displays, firstHitChannels()),
               filter.hasNegativeLobes(),
               wantsHalves(displays)});

    console.begin("rendering");
    TransportStatistics transport;
    statistics.measure("render",
                       [&] { integrate(scene, integrator, filter, film, transport, console); });
    statistics.add(scene, transport);

    std::vector<std::string> written =
        writeDisplays(film, options, describe(scene, integrator, file),
                      {settings.outputDirectory, settings.allowPrograms}, console);
    std::string summary;
    for (const std::string &name : written)
        summary += (summary.empty() ? "wrote " : ", ") + name;
    console.end(summary.empty() ? "nothing written" : summary);
}

} // namespace

int renderFile(const std::string &path, const RenderSettings &settings) {
    Console console(!settings.quiet && isatty(STDERR_FILENO));
    ThreadLimit threads(settings.threads);
    Statistics statistics;

    ShaderLibrary shaders({shaderFolders(path, settings.shaderPath, console), settings.jit},
                          console);
    ShaderWarnings warnings(console);
    SceneCompiler world(shaders, console, [&](const Scene &scene) {
        warnings.look(scene);
        renderFrame(scene, settings, path, console, statistics);
    });
    GraphicsStateSettings stateSettings;
    stateSettings.searchPaths = {joinFolders(settings.shaderPath),
                                 joinFolders(settings.texturePath),
                                 joinFolders(settings.archivePath)};
    stateSettings.overrideOptions = [&](Options &options) { overrideOptions(settings, options); };
    GraphicsState state(world, shaders, console, stateSettings);

    RibReader(state, state.diagnostics()).readFile(path);
    state.finish();
    statistics.add(shaders.statistics());
    if (!settings.statisticsFile.empty())
        statistics.write(settings.statisticsFile, console);
    return console.failed() ? 1 : 0;
}

} // namespace candela
