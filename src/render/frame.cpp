// SPDX-License-Identifier: Apache-2.0
#include "render/frame.h"

#include "image/disk_space.h"
#include "image/displays.h"
#include "image/film_maps.h"
#include "image/imager.h"
#include "image/kept_samples.h"
#include "light/frame/adaptive_sampling.h"
#include "light/frame/darkness.h"
#include "light/frame/light_warnings.h"
#include "render/filtering.h"
#include "render/frame_film.h"
#include "render/frame_settings.h"
#include "render/interrupt.h"
#include "render/solution_keeping.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fmt/format.h>
#include <new>

namespace candela {

namespace {

void report(const std::vector<std::string> &written, std::span<const PlannedDisplay> displays,
            Console &console) {
    const bool taken = std::ranges::any_of(displays, &PlannedDisplay::isTaken);
    std::string summary;
    for (const std::string &name : written)
        summary += (summary.empty() ? "wrote " : ", ") + name;
    console.end(!summary.empty() ? summary : taken ? "done" : "nothing written");
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
    const FrameKeeping &keeping;
    IntegratorSettings integrator;
    FrameDescription description;
    std::vector<PlannedDisplay> displays;
    DisplayTaker *taker;       ///< Null = nobody.
    bool keepsSamples = false; ///< For filters.
};

void integrateFrame(const FrameJob &job, const PixelFilterSampler &filter, Film &film,
                    SampleSink &sink, FrameProgress &progress) {
    const FrameListeners &listeners = job.listeners;
    TransportStatistics transport;
    listeners.statistics.measure("render", [&] {
        integrate(job.scene, job.integrator, filter, sink, progress, transport,
                  listeners.diagnostics);
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

std::string rangeOf(const SampleCounts &counts) {
    return counts.least == counts.most ? std::to_string(counts.most)
                                       : fmt::format("{} to {}", counts.least, counts.most);
}

/// Has a frame's files say what samples there are, and says how far it has come if it has been
/// ended. False if that is nowhere.
bool tellOfEnd(const FrameJob &job, FrameEnd end, const FrameProgress &progress, const Film &film,
               FrameDescription &description) {
    const SampleCounts counts = film.sampleCounts();
    const int wanted = job.integrator.lastSample;
    description.metadata["spp"] = fmt::format("{:.6g}", counts.mean);
    if (counts.least < counts.most)
        description.metadata["sppRange"] = rangeOf(counts);
    if (end == FrameEnd::Whole || progress.firstSample() >= wanted)
        return true;
    const std::string why = end == FrameEnd::OutOfTime ? "the time is up" : "interrupted";
    DiagnosticSink &diagnostics = job.listeners.diagnostics;
    if (counts.most == 0) {
        diagnostics.error({}, why + " before there was any sample: no picture is written");
        return false;
    }
    const bool isFile = std::ranges::any_of(job.displays, &PlannedDisplay::isFile);
    diagnostics.warning({},
                        fmt::format("{} after {} of {} samples a pixel: the picture is {} as it "
                                    "is{}",
                                    why, rangeOf(counts), wanted, isFile ? "written" : "left",
                                    counts.least == 0 ? ", black where there are none" : ""));
    return true;
}

/// A black picture says why.
void explainBlack(const FrameJob &job, const Film &film) {
    constexpr int color = 0, opacity = 1; // Of every film's channels.
    const bool shows = std::ranges::any_of(
        job.displays, [](const PlannedDisplay &display) { return !holdsDepths(display.record); });
    if (!shows || film.sampleCounts().least == 0 || film.nonFiniteSamples() > 0 ||
        !film.isZero(color))
        return;
    const std::string why = whyBlack(job.scene, job.integrator.crop, film.isZero(opacity));
    if (!why.empty())
        job.listeners.diagnostics.warning({}, "the picture is black: " + why);
}

void writePictures(const FrameJob &job, const PictureShaders &shaders,
                   const FrameDescription &description, const Film &film,
                   const FilteredPicture *filtered) {
    DisplaySources sources(film, filtered);
    std::optional<ImagedPicture> imaged;
    if (shaders.imager) {
        imaged = shaders.imager->run(sources, job.listeners.diagnostics);
        sources.imaged = &*imaged;
    }
    if (lightsCastNoShadows(job.scene))
        job.listeners.console.remark(
            "lights cast no shadows under the integrator \"classic\", unless Attribute \"light\" "
            "\"string shadows\" \"on\" stands before them or their shaders look them up; "
            "--integrator path casts them all");
    if (job.taker)
        handOver(sources, job.displays, job.scene.options(), description, *job.taker, true);
    report(writeDisplays(sources, job.displays, job.scene.options(), description,
                         job.listeners.diagnostics),
           job.displays, job.listeners.console);
}

/// Shows whoever watches the frame what there is; empty if nobody does.
std::function<void()> lookAt(const FrameJob &job, const Film &film) {
    if (!job.taker || !job.taker->wantsUnfinished() ||
        std::ranges::none_of(job.displays, &PlannedDisplay::isTaken))
        return {};
    return [&] {
        if (job.taker->wantsUnfinished())
            handOver(DisplaySources(film), job.displays, job.scene.options(), job.description,
                     *job.taker, false);
    };
}

/// Writes what there is, without filters, and ends the program: threads are still at work that
/// cannot be called back.
[[noreturn]] void writeAndEnd(const FrameJob &job, const PictureShaders &shaders,
                              const FrameProgress &progress, const Film &film, FrameEnd end) {
    FrameDescription description = job.description;
    if (tellOfEnd(job, end, progress, film, description)) {
        if (!shaders.filters.empty())
            job.listeners.diagnostics.warning({}, "the filters have not been run");
        writePictures(job, shaders, description, film, nullptr);
    }
    std::fflush(nullptr);
    std::_Exit(exitStatusOf(end, job.listeners.console));
}

/// What the samples go into: the film, or what keeps them for filters and hands them on to it.
struct FrameSinks {
    FrameSinks(const Film::Settings &wanted, const FrameJob &job) : film(wanted) {
        if (job.keepsSamples)
            samples.emplace(film, job.integrator.lastSample);
    }
    ResumableSink &first() { return samples ? static_cast<ResumableSink &>(*samples) : film; }

    Film film;
    std::optional<KeptSamples> samples;
};

/// Renders, filters and writes.
FrameEnd makePicture(const FrameJob &job, const PictureShaders &shaders,
                     const PixelFilterSampler &filter, FrameSinks &sinks) {
    const FrameKeeping &keeping = job.keeping;
    DiagnosticSink &diagnostics = job.listeners.diagnostics;
    const Film &film = sinks.film;
    if (keeping.from) {
        std::string_view saved = keeping.from->samples;
        std::string problem = differenceOf(keeping.from->identity, keeping.identity);
        if (problem.empty() && !sinks.first().restore(saved))
            problem = "it holds another film";
        if (!problem.empty()) {
            diagnostics.error({}, "the checkpoint is not of this render: " + problem);
            return FrameEnd::Refused;
        }
    }
    FrameProgress progress(keeping.from ? keeping.from->position : FramePosition());
    FrameEnd end = FrameEnd::Whole;
    job.listeners.console.begin("rendering");
    {
        std::optional<Interrupt> interrupt;
        if (keeping.heedsSignals)
            interrupt.emplace();
        FrameKeeper keeper(keeping, progress, sinks.first(),
                           {[&] {
                                return (interrupt && interrupt->asked()) ||
                                       (job.taker && job.taker->wantsEnd());
                            },
                            lookAt(job, film),
                            [&](FrameEnd why) { writeAndEnd(job, shaders, progress, film, why); }},
                           diagnostics);
        integrateFrame(job, filter, sinks.film, sinks.first(), progress);
        keeper.leave();
        end = keeper.end();
        if (end != FrameEnd::Whole && !keeping.checkpointFile.empty())
            keeper.save();
    }
    FrameDescription description = job.description;
    if (!tellOfEnd(job, end, progress, film, description))
        return end;
    explainBlack(job, film);
    FilteredPicture filtered;
    if (sinks.samples)
        filtered.maps.set(samplesMap, sinks.samples->take());
    const bool isFiltered = !shaders.filters.empty();
    if (isFiltered && !filterFrame(job, shaders.filters, film, filtered))
        end = FrameEnd::Interrupted;
    writePictures(job, shaders, description, film, isFiltered ? &filtered : nullptr);
    return end;
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

/// Decides whether pixels may differ in their numbers of samples.
void settleVariance(FrameJob &job) {
    double &variance = job.integrator.variance;
    if (job.keepsSamples)
        variance = 0;
    const float asked = job.scene.options().pixelVariance.value_or(0);
    if (variance > 0)
        job.description.metadata["pixelVariance"] = fmt::format("{:g}", asked);
    else if (asked > 0)
        job.listeners.diagnostics.warning(
            {}, fmt::format("PixelVariance does nothing {}: all pixels take as many samples as "
                            "PixelSamples says",
                            job.keepsSamples ? "for filters that read every sample"
                                             : "under the integrator \"bidir\" or \"vcm\""));
}

FrameEnd renderAndWrite(const Scene &scene, ShaderLibrary &library, const RenderSettings &settings,
                        const std::string &file, const FrameListeners &listeners,
                        const FrameKeeping &keeping) {
    const Options &options = scene.options();
    ErrorPolicy &diagnostics = listeners.diagnostics;
    const PictureShaders shaders{FilterStack(options.filters, library, options),
                                 Imager::of(options, library, diagnostics)};
    IntegratorSettings integrator = integratorSettings(scene, settings);
    integrator.progress = [&](double done) { listeners.console.progress(done); };
    if (!keepSolution(scene, settings, keeping.solution, integrator, diagnostics))
        return FrameEnd::Refused;
    FrameJob job{
        scene,
        listeners,
        keeping,
        integrator,
        describeFrame(scene, integrator, file),
        planDisplays(
            options, channelsToShow(scene, shaders.filters),
            {{settings.outputDirectory, settings.trust}, settings.outputFile, settings.taker},
            diagnostics),
        settings.taker};
    const PixelFilterSampler filter(options.filter, diagnostics, options.places.pixelFilter);
    Film::Settings wanted = filmSettings(scene, integrator.crop, filter, shaders.filters);
    double maps = shaders.filters.empty() ? 0 : bytesOfMaps(mapNames(shaders.filters), wanted);
    maps += bytesOfSamples(job, shaders.filters, wanted.window);
    settleVariance(job);
    wanted.pairsHalves = AdaptiveSampling(job.integrator).isOn();
    if (job.displays.empty() || !canHold(wanted, maps, options, diagnostics) ||
        diagnostics.stopped())
        return FrameEnd::Whole;
    warnOfSmallDisks(job.displays, double(wanted.window.pixels()), diagnostics);
    FrameSinks sinks(wanted, job);
    return makePicture(job, shaders, filter, sinks);
}

} // namespace

int exitStatusOf(FrameEnd end, const Console &console) {
    return end == FrameEnd::Interrupted ? statusOfInterrupt : console.failed() ? 1 : 0;
}

FrameEnd renderFrame(const Scene &scene, ShaderLibrary &shaders, const RenderSettings &settings,
                     const std::string &file, const FrameListeners &listeners,
                     const FrameKeeping &keeping) {
    if (scene.options().hider == "null") // RI: computes no pixels.
        return FrameEnd::Whole;
    try {
        return renderAndWrite(scene, shaders, settings, file, listeners, keeping);
    } catch (const std::bad_alloc &) {
        listeners.diagnostics.error({}, "there is not enough memory for this frame; it is not "
                                        "rendered");
        return FrameEnd::Whole;
    }
}

} // namespace candela
