// SPDX-License-Identifier: Apache-2.0
#include "render/frame.h"

#include "image/displays.h"
#include "image/film_maps.h"
#include "image/imager.h"
#include "image/kept_samples.h"
#include "light/path/first_hit.h"
#include "light/path/shader_channels.h"
#include "render/filtering.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <new>
#include <unistd.h>

namespace candela {

namespace {

/// Options "bidir" and "vcm": how many paths begin on lights, and what becomes of them.
BidirectionalWishes wishesOf(const NamedParameters &named) {
    BidirectionalWishes wishes;
    if (const double paths = named.number("bidir:lightpaths", -1); paths >= 0)
        wishes.lightPaths = paths;
    if (const double connections = named.number("bidir:connections", -1); connections >= 0)
        wishes.connections = int(connections);
    wishes.trust = named.number("bidir:trust", 1);
    wishes.merges = named.string("render:integrator", "") == "vcm";
    if (const double radius = named.number("vcm:radius", 0); radius > 0)
        wishes.radius = float(radius);
    wishes.trustInMerging = named.number("vcm:trust", 1);
    return wishes;
}

FinalPass finalPassOf(const NamedParameters &named) {
    const std::string name = named.string("radiosity:finalpass", "fe");
    return name == "gather"      ? FinalPass::Gather
           : name == "fe+direct" ? FinalPass::Direct
                                 : FinalPass::Elements;
}

radiosity::SolverSettings solverSettings(const NamedParameters &named, std::uint32_t seed) {
    radiosity::SolverSettings solver;
    solver.seed = seed;
    solver.order = int(named.number("radiosity:order", solver.order));
    solver.epsilon = named.number("radiosity:epsilon", solver.epsilon);
    solver.contrast = named.number("radiosity:contrast", solver.contrast);
    solver.leastElement = named.number("radiosity:leastelement", solver.leastElement);
    solver.directSamples = int(named.number("radiosity:samples", solver.directSamples));
    return solver;
}

IntegratorSettings integratorSettings(const Scene &scene, const RenderSettings &settings) {
    const Options &options = scene.options();
    IntegratorSettings result;
    result.kind = scene.isClassic()         ? IntegratorKind::Classic
                  : scene.isBidirectional() ? IntegratorKind::Bidirectional
                  : scene.isSolved()        ? IntegratorKind::Radiosity
                                            : IntegratorKind::Path;
    result.finalPass = finalPassOf(options.named);
    result.solver = solverSettings(options.named, settings.seed);
    const double samples =
        std::round(double(std::max(1.0f, options.xSamples)) * std::max(1.0f, options.ySamples));
    result.lastSample = int(std::min<double>(samples, maximumSamplesPerPixel));
    result.seed = settings.seed;
    result.maxDepth = maxDepthOf(options);
    result.hemisphereOnly = settings.hemisphereOnly;
    result.bidirectional = wishesOf(options.named);
    result.crop = options.format.cropPixels();
    return result;
}

const char *nameOf(const IntegratorSettings &settings) {
    switch (settings.kind) {
    case IntegratorKind::Classic: return "classic";
    case IntegratorKind::Path: return "path";
    case IntegratorKind::Radiosity: return "radiosity";
    case IntegratorKind::Bidirectional: break;
    }
    return settings.bidirectional.merges ? "vcm" : "bidir";
}

FrameDescription describe(const Scene &scene, const IntegratorSettings &integrator,
                          const std::string &file) {
    FrameDescription description;
    description.metadata = {{"renderer", "Candela"},
                            {"scene", std::filesystem::path(file).filename().string()},
                            {"integrator", nameOf(integrator)},
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

/// What keeps a film of these settings, and `maps` bytes beside it, from being made is reported.
bool canHold(const Film::Settings &film, double maps, const Options &options,
             DiagnosticSink &diagnostics) {
    const FrameWindow &window = film.window;
    if (window.x0 >= window.x1 || window.y0 >= window.y1) {
        diagnostics.error(options.places.cropWindow,
                          "the crop window holds no pixel; the frame is not rendered");
        return false;
    }
    const double needed = (Film::bytesNeeded(film) + maps) / 1e9, there = gigabytesOfMemory();
    if (needed > there) {
        diagnostics.error(
            options.places.format,
            fmt::format("a picture of {} x {} pixels takes {:.0f} GB of memory{}, and "
                        "this machine has {:.0f}; the frame is not rendered",
                        window.columns(), window.rows(), needed,
                        maps > 0 ? " with its filters" : "", there));
        return false;
    }
    return true;
}

/// What estimators give: what a first hit tells, and what shaders leave in output parameters.
std::vector<ChannelInfo> channelsGiven(const Scene &scene) {
    std::vector<ChannelInfo> channels = firstHitChannels(), own = outputParametersOf(scene);
    channels.insert(channels.end(), own.begin(), own.end());
    return channels;
}

/// What modes of displays may name: these, and the maps that filters make.
std::vector<ChannelInfo> channelsToShow(const Scene &scene, const FilterStack &filters) {
    std::vector<ChannelInfo> channels = channelsGiven(scene);
    const std::vector<ChannelInfo> others = mapsOfEveryFilm();
    for (const MapInfo &map : filters.mapsSet())
        if (std::ranges::find(channels, map.name, &ChannelInfo::name) == channels.end() &&
            std::ranges::find(others, map.name, &ChannelInfo::name) == others.end())
            channels.push_back({map.name, map.channels});
    return channels;
}

Film::Settings filmSettings(const Scene &scene, const std::array<int, 4> &crop,
                            const PixelFilterSampler &filter, const FilterStack &filters) {
    const Options &options = scene.options();
    const std::vector<DisplayRecord> displays = displaysOf(options);
    const auto [width, height] = options.format.effectiveResolution();
    const auto [x0, x1, y0, y1] = crop;
    const std::vector<ChannelInfo> given = channelsGiven(scene);
    Film::Settings settings{{width, height, x0, x1, y0, y1},
                            wantedChannels(displays, channelsToShow(scene, filters)),
                            filter.hasNegativeLobes(),
                            wantsHalves(displays)};
    settings.splats = scene.isBidirectional();
    // Sums of splats are exact to a share of what light there is, in rooms and under the stars.
    if (const double typical = scene.lights().typicalRadiance(); settings.splats && typical > 0)
        settings.splatUnits.fill(commonSplatUnit * std::exp2(std::floor(std::log2(typical))));
    std::erase_if(settings.channels, [&](const ChannelInfo &channel) {
        return std::ranges::find(given, channel.name, &ChannelInfo::name) == given.end();
    });
    wantMaps(mapNames(filters), given, settings);
    return settings;
}

void report(const std::vector<std::string> &written, Console &console) {
    std::string summary;
    for (const std::string &name : written)
        summary += (summary.empty() ? "wrote " : ", ") + name;
    console.end(summary.empty() ? "nothing written" : summary);
}

/// Shaders that answer NaN have been named where they did; what else was not finite is said here.
void reportNonFinite(const Film &film, const Scene &scene, const TransportStatistics &transport,
                     DiagnosticSink &diagnostics) {
    if (transport.nonFiniteSamples > 0)
        return;
    if (const std::uint64_t lost = scene.lights().nonFiniteSamples(); lost > 0)
        diagnostics.warning({}, fmt::format("{} samples of lights were not finite in this frame; "
                                            "they count as 0",
                                            lost));
    const std::uint64_t found = film.nonFiniteSamples();
    if (found > 0)
        diagnostics.warning({}, fmt::format("{} values of samples were not finite in this frame; "
                                            "they count as 0",
                                            found));
}

/// The map of all samples of Ci.
constexpr const char *samplesMap = "samples";

/// What is done to a frame's pixels behind the film.
struct PictureShaders {
    FilterStack filters;
    std::optional<Imager> imager;
};

/// A frame on its way from samples to files.
struct FrameJob {
    const Scene &scene;
    const FrameListeners &listeners;
    IntegratorSettings integrator;
    FrameDescription description;
    std::vector<PlannedDisplay> displays;
    bool keepsSamples = false; ///< For filters.
};

void integrateFrame(const FrameJob &job, const PixelFilterSampler &filter, Film &film,
                    SampleSink &sink) {
    const FrameListeners &listeners = job.listeners;
    TransportStatistics transport;
    listeners.statistics.measure("render", [&] {
        integrate(job.scene, job.integrator, filter, sink, transport, listeners.diagnostics);
    });
    listeners.statistics.add(job.scene, transport);
    reportNonFinite(film, job.scene, transport, listeners.diagnostics);
}

/// Runs the filters over the maps that the film gives, beside those that are in `picture` already.
/// False if the user wants no more.
bool filterFrame(const FrameJob &job, const FilterStack &filters, const Film &film,
                 FilteredPicture &picture) {
    const FrameListeners &listeners = job.listeners;
    addMaps(film, mapNames(filters), picture.maps);
    for (const MapInfo &map : filters.mapsSet())
        picture.set.push_back(map.name);
    FilteringOutcome outcome;
    listeners.statistics.measure("filter", [&] {
        outcome = runFilters(filters, picture.maps, listeners.console, listeners.diagnostics);
    });
    picture.filters = textOf(filters.records(), outcome.done);
    if (outcome.interrupted)
        listeners.diagnostics.warning(
            {}, "filtering was interrupted: the picture is as the last whole filter left it, and "
                "no other frame is rendered");
    return !outcome.interrupted;
}

/// Renders, filters and writes; false if the user wants no more.
bool makePicture(const FrameJob &job, const PictureShaders &shaders,
                 const PixelFilterSampler &filter, Film &film) {
    Console &console = job.listeners.console;
    console.begin("rendering");
    FilteredPicture filtered;
    if (job.keepsSamples) {
        KeptSamples samples(film, job.integrator.lastSample);
        integrateFrame(job, filter, film, samples);
        filtered.maps.set(samplesMap, samples.take());
    } else {
        integrateFrame(job, filter, film, film);
    }
    const bool isFiltered = !shaders.filters.empty();
    const bool goesOn = !isFiltered || filterFrame(job, shaders.filters, film, filtered);
    DisplaySources sources(film, isFiltered ? &filtered : nullptr);
    std::optional<ImagedPicture> imaged;
    if (shaders.imager) {
        imaged = shaders.imager->run(sources, job.listeners.diagnostics);
        sources.imaged = &*imaged;
    }
    report(writeDisplays(sources, job.displays, job.scene.options(), job.description,
                         job.listeners.diagnostics),
           console);
    return goesOn;
}

/// Decides whether samples are kept: what that takes.
double bytesOfSamples(FrameJob &job, const FilterStack &filters, const FrameWindow &window) {
    const std::vector<std::string> read = filters.mapsRead();
    if (std::ranges::find(read, samplesMap) == read.end())
        return 0;
    const double bytes = KeptSamples::bytesNeeded(window, job.integrator.lastSample);
    job.keepsSamples = bytes <= mostSampleBytes;
    if (job.keepsSamples)
        return bytes;
    job.listeners.diagnostics.error(
        filters.records().front().parameters.where,
        fmt::format("a filter reads the map \"{}\", which would take {:.1f} GB for {} samples a "
                    "pixel; {:.0f} GB are the most, and it is not there",
                    samplesMap, bytes / 1e9, job.integrator.lastSample, mostSampleBytes / 1e9));
    return 0;
}

bool renderAndWrite(const Scene &scene, ShaderLibrary &library, const RenderSettings &settings,
                    const std::string &file, const FrameListeners &listeners) {
    const Options &options = scene.options();
    ErrorPolicy &diagnostics = listeners.diagnostics;
    const PictureShaders shaders{FilterStack(options.filters, library, options),
                                 Imager::of(options, library, diagnostics)};
    IntegratorSettings integrator = integratorSettings(scene, settings);
    integrator.progress = [&](double done) { listeners.console.progress(done); };
    FrameJob job{scene, listeners, integrator, describe(scene, integrator, file),
                 planDisplays(options, channelsToShow(scene, shaders.filters),
                              {settings.outputDirectory, settings.trust}, diagnostics)};
    const PixelFilterSampler filter(options.filter, diagnostics, options.places.pixelFilter);
    const Film::Settings wanted = filmSettings(scene, integrator.crop, filter, shaders.filters);
    double maps = shaders.filters.empty() ? 0 : bytesOfMaps(mapNames(shaders.filters), wanted);
    maps += bytesOfSamples(job, shaders.filters, wanted.window);
    if (job.displays.empty() || !canHold(wanted, maps, options, diagnostics) ||
        diagnostics.stopped())
        return true;
    Film film(wanted);
    return makePicture(job, shaders, filter, film);
}

} // namespace

int maxDepthOf(const Options &options) {
    constexpr int usual = 64;
    return int(options.named.number("trace:maxdepth", usual));
}

bool renderFrame(const Scene &scene, ShaderLibrary &shaders, const RenderSettings &settings,
                 const std::string &file, const FrameListeners &listeners) {
    if (scene.options().hider == "null") // RI: computes no pixels.
        return true;
    try {
        return renderAndWrite(scene, shaders, settings, file, listeners);
    } catch (const std::bad_alloc &) {
        listeners.diagnostics.error({}, "there is not enough memory for this frame; it is not "
                                        "rendered");
        return true;
    }
}

} // namespace candela
