// SPDX-License-Identifier: Apache-2.0
#include "render/frame.h"

#include "image/displays.h"
#include "light/path/first_hit.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <new>
#include <unistd.h>

namespace candela {

namespace {

constexpr int defaultDepth = 64;

IntegratorSettings integratorSettings(const Scene &scene, const RenderSettings &settings) {
    const Options &options = scene.options();
    IntegratorSettings result;
    result.kind = scene.isClassic() ? IntegratorKind::Classic : IntegratorKind::Path;
    const double samples =
        std::round(double(std::max(1.0f, options.xSamples)) * std::max(1.0f, options.ySamples));
    result.lastSample = int(std::min<double>(samples, maximumSamplesPerPixel));
    result.seed = settings.seed;
    result.maxDepth = int(options.named.number("trace:maxdepth", defaultDepth));
    result.hemisphereOnly = settings.hemisphereOnly;
    result.crop = options.format.cropPixels();
    return result;
}

FrameDescription describe(const Scene &scene, const IntegratorSettings &integrator,
                          const std::string &file) {
    FrameDescription description;
    description.metadata = {
        {"renderer", "Candela"},
        {"scene", std::filesystem::path(file).filename().string()},
        {"integrator", integrator.kind == IntegratorKind::Path ? "path" : "classic"},
        {"spp", std::to_string(integrator.lastSample)},
        {"seed", std::to_string(integrator.seed)},
        {"maxdepth", std::to_string(integrator.maxDepth)},
        {"sampling", integrator.hemisphereOnly ? "hemisphere" : "cones"}};
    const Matrix4 &worldToCamera = scene.options().camera.cameraFromWorld;
    description.worldToCamera = worldToCamera;
    description.worldToNdc = worldToCamera * scene.camera().ndcFromCamera();
    return description;
}

double gigabytesOfMemory() {
    return double(sysconf(_SC_PHYS_PAGES)) * double(sysconf(_SC_PAGESIZE)) / 1e9;
}

/// What keeps a film of these settings from being made is reported.
bool canHold(const Film::Settings &film, const Options &options, DiagnosticSink &diagnostics) {
    const FrameWindow &window = film.window;
    if (window.x0 >= window.x1 || window.y0 >= window.y1) {
        diagnostics.error(options.places.cropWindow,
                          "the crop window holds no pixel; the frame is not rendered");
        return false;
    }
    const double needed = Film::bytesNeeded(film) / 1e9, there = gigabytesOfMemory();
    if (needed > there) {
        diagnostics.error(options.places.format,
                          fmt::format("a picture of {} x {} pixels takes {:.0f} GB of memory, and "
                                      "this machine has {:.0f}; the frame is not rendered",
                                      window.columns(), window.rows(), needed, there));
        return false;
    }
    return true;
}

Film::Settings filmSettings(const Options &options, const std::array<int, 4> &crop,
                            const PixelFilterSampler &filter) {
    const std::vector<DisplayRecord> displays = displaysOf(options);
    const auto [width, height] = options.format.effectiveResolution();
    const auto [x0, x1, y0, y1] = crop;
    return {{width, height, x0, x1, y0, y1},
            wantedChannels(displays, firstHitChannels()),
            filter.hasNegativeLobes(),
            wantsHalves(displays)};
}

void report(const std::vector<std::string> &written, Console &console) {
    std::string summary;
    for (const std::string &name : written)
        summary += (summary.empty() ? "wrote " : ", ") + name;
    console.end(summary.empty() ? "nothing written" : summary);
}

void renderAndWrite(const Scene &scene, const RenderSettings &settings, const std::string &file,
                    const FrameListeners &listeners) {
    const Options &options = scene.options();
    ErrorPolicy &diagnostics = listeners.diagnostics;
    const std::vector<PlannedDisplay> displays =
        planDisplays(options, firstHitChannels(),
                     {settings.outputDirectory, settings.allowPrograms}, diagnostics);
    IntegratorSettings integrator = integratorSettings(scene, settings);
    integrator.progress = [&](double done) { listeners.console.progress(done); };
    PixelFilterSampler filter(options.filter, diagnostics, options.places.pixelFilter);
    const Film::Settings wanted = filmSettings(options, integrator.crop, filter);
    if (displays.empty() || !canHold(wanted, options, diagnostics) || diagnostics.stopped())
        return;

    Film film(wanted);
    listeners.console.begin("rendering");
    TransportStatistics transport;
    listeners.statistics.measure(
        "render", [&] { integrate(scene, integrator, filter, film, transport, diagnostics); });
    listeners.statistics.add(scene, transport);
    report(writeDisplays(film, displays, options, describe(scene, integrator, file), diagnostics),
           listeners.console);
}

} // namespace

void renderFrame(const Scene &scene, const RenderSettings &settings, const std::string &file,
                 const FrameListeners &listeners) {
    if (scene.options().hider == "null") // RI: computes no pixels.
        return;
    try {
        renderAndWrite(scene, settings, file, listeners);
    } catch (const std::bad_alloc &) {
        listeners.diagnostics.error({}, "there is not enough memory for this frame; it is not "
                                        "rendered");
    }
}

} // namespace candela
