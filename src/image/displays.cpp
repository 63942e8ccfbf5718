// SPDX-License-Identifier: Apache-2.0
#include "image/displays.h"

#include "foundation/base/whole_file.h"
#include "foundation/units/color.h"
#include "image/exr_file.h"
#include "image/imaging.h"
#include "image/png_file.h"
#include "world/texture/module.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace candela {

namespace {

using Source = DisplayPlane::Source;

std::string shortNumber(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%g", value);
    return text;
}

/// A display on its way out.
struct Job {
    const DisplaySources &sources;
    const Options &options;
    const FrameDescription &frame;
    const DisplayRecord &display;
    bool standsIn;
    const std::vector<DisplayPlane> &planes;
    std::string problem, warning;
};

PlaneSettings planeSettings(const Job &job) {
    const auto usable = [](float value) { return value > 0 && std::isfinite(value); };
    PlaneSettings settings;
    settings.exposure = job.options.exposure.value_or(ExposureRecord{});
    if (!usable(settings.exposure.gamma))
        settings.exposure.gamma = 1;
    settings.halves = wantsHalves(job.display);
    settings.channels = job.options.channelQuantize;
    settings.own = job.display.quantize;
    return settings;
}

/// What is done with a plane; one == 0: it stays as it is.
QuantizeRecord quantizeOf(const DisplayPlane &plane, const PlaneSettings &settings) {
    switch (plane.source) {
    case Source::Depth: return settings.depth;
    case Source::Color:
    case Source::Alpha: return settings.color;
    default: break;
    }
    if (const auto named = settings.channels.find(plane.channel); named != settings.channels.end())
        return named->second;
    return settings.own.value_or(settings.quantizeAll ? settings.color : QuantizeRecord{});
}

void describe(const Job &job, Picture &picture) {
    const Options &options = job.options;
    picture.pixelAspectRatio =
        options.format.pixelAspectRatio > 0 ? options.format.pixelAspectRatio : 1;
    picture.worldToCamera = job.frame.worldToCamera;
    if (picture.window == job.sources.film.window()) // Nobody knows what other pixels show.
        picture.worldToNdc = job.frame.worldToNdc;
    picture.metadata = job.frame.metadata;
    if (std::ranges::any_of(
            job.planes, [&](const DisplayPlane &plane) { return isFiltered(job.sources, plane); }))
        picture.metadata["filters"] = job.sources.filtered->filters;
    if (options.named.string("radiometry:units", "classic") == "si") {
        picture.metadata["units"] = "W m^-2 sr^-1";
        picture.metadata["luminousEfficacy"] = shortNumber(luminousEfficacy) + " lm/W";
    } else {
        picture.metadata["units"] = "relative"; // To lights of intensity 1, as RI has them.
    }
    const ExposureRecord exposure = options.exposure.value_or(ExposureRecord{});
    picture.metadata["exposure"] = shortNumber(exposure.gain) + " " + shortNumber(exposure.gamma);
    picture.metadata["pixelFilter"] = options.filter.name + " " +
                                      shortNumber(options.filter.xWidth) + " " +
                                      shortNumber(options.filter.yWidth);
}

void noteQuantize(Picture &picture, const QuantizeRecord &q) {
    if (q.one != 0)
        picture.metadata["quantize"] = shortNumber(q.one) + " " + shortNumber(q.minimum) + " " +
                                       shortNumber(q.maximum) + " " +
                                       shortNumber(q.ditherAmplitude);
}

std::optional<std::string> exrBytes(Job &job) {
    PlaneSettings settings = planeSettings(job);
    const QuantizeRecord none;
    settings.color = job.display.quantize.value_or(job.options.colorQuantize.value_or(none));
    settings.depth = depthQuantize(job.display, job.options);
    if (job.standsIn) // Those numbers were meant for another format.
        settings.color = settings.depth = none, settings.channels.clear(), settings.own.reset();
    Picture picture = developPicture(job.sources, job.planes, settings);
    describe(job, picture);
    noteQuantize(picture, settings.color);
    if (holdsDepths(job.display)) // As world/texture reads it.
        picture.metadata["candela:texture"] = "shadow";
    return encodeExr(picture, job.problem);
}

std::optional<std::string> pngBytes(Job &job) {
    PlaneSettings settings = planeSettings(job);
    settings.quantizeAll = true;
    settings.halves = false;
    settings.straightAlpha = true;
    const auto shows = [&](Source source) {
        return std::ranges::find(job.planes, source, &DisplayPlane::source) != job.planes.end();
    };
    settings.srgbCurve = shows(Source::Color) && !job.options.exposure && !job.display.quantize &&
                         !job.options.colorQuantize;
    settings.own.reset();
    std::erase_if(settings.channels, [](const auto &named) { return named.second.one == 0; });
    settings.color =
        job.display.quantize.value_or(job.options.colorQuantize.value_or(eightBitQuantize));
    if (settings.color.one == 0) {
        job.warning += job.warning.empty() ? "" : "; ";
        job.warning += "a PNG picture holds whole numbers only: quantised by 255 0 255 0.5";
        settings.color = eightBitQuantize;
    }
    settings.depth = depthQuantize(job.display, job.options);
    Picture picture = developPicture(job.sources, job.planes, settings);
    describe(job, picture);
    noteQuantize(picture, settings.color);
    const float largest =
        std::max(settings.color.maximum, shows(Source::Depth) ? settings.depth.maximum : 0);
    const auto gamma = settings.srgbCurve ? std::nullopt : std::optional(settings.exposure.gamma);
    return encodePng(picture, largest > 255 ? 16 : 8, gamma, job.problem);
}

/// What stands in a header that knows one text alone.
std::string descriptionOf(const Picture &picture) {
    std::string text;
    for (const auto &[key, value] : picture.metadata)
        text += (text.empty() ? "" : "; ") + key + ": " + value;
    return text;
}

/// Formats of the module of pictures. Channels that are all quantised make a file of whole numbers;
/// anything else one of floats.
std::optional<std::string> libraryBytes(Job &job, PictureToEncode::Format format) {
    PlaneSettings settings = planeSettings(job);
    settings.halves = false;
    const bool isHdr = format == PictureToEncode::Format::RadianceHdr;
    if (!isHdr) {
        settings.color =
            job.display.quantize.value_or(job.options.colorQuantize.value_or(eightBitQuantize));
        settings.depth = depthQuantize(job.display, job.options);
    }
    bool whole = !isHdr;
    float most = 0;
    for (const DisplayPlane &plane : job.planes) {
        const QuantizeRecord quantize = quantizeOf(plane, settings);
        whole = whole && quantize.one != 0;
        most = std::max(most, quantize.maximum);
    }
    if (!whole)
        settings.color = settings.depth = {}, settings.channels.clear(), settings.own.reset();
    Picture picture = developPicture(job.sources, job.planes, settings);
    describe(job, picture);
    noteQuantize(picture, settings.color);
    PictureToEncode file;
    file.format = format;
    file.numbers = !whole       ? PictureToEncode::Numbers::Floats
                   : most > 255 ? PictureToEncode::Numbers::Words
                                : PictureToEncode::Numbers::Bytes;
    file.width = picture.window.columns(), file.height = picture.window.rows();
    file.description = descriptionOf(picture);
    for (const PictureChannel &channel : picture.channels)
        file.channels.push_back(channel.name);
    file.values.reserve(picture.window.pixels() * picture.channels.size());
    for (std::size_t i = 0; i < picture.window.pixels(); ++i)
        for (const PictureChannel &channel : picture.channels)
            file.values.push_back(channel.values[i]);
    std::string bytes;
    PictureLibrary *const library = pictureLibrary(job.problem);
    if (!library || !library->encode(file, bytes, job.problem))
        return std::nullopt;
    return bytes;
}

std::optional<std::string> bytesOf(Job &job, FileFormat format) {
    switch (format) {
    case FileFormat::OpenExr: return exrBytes(job);
    case FileFormat::Png: return pngBytes(job);
    case FileFormat::Tiff: return libraryBytes(job, PictureToEncode::Format::Tiff);
    case FileFormat::RadianceHdr: break;
    }
    return libraryBytes(job, PictureToEncode::Format::RadianceHdr);
}

bool write(Job &job, const PlannedDisplay &display) {
    const auto bytes = bytesOf(job, display.format);
    return bytes && writeWholeFile(display.path, *bytes, job.problem);
}

/// Light as the display has it. That which an imager has given is exposed, its share of the pixel
/// too.
float developedColor(float value, bool isExposed, float alpha, const PlaneSettings &settings) {
    if (settings.straightAlpha)
        value =
            straightColor(value, isExposed ? exposed(alpha, {1, settings.exposure.gamma}) : alpha);
    if (!isExposed)
        value = exposed(value, settings.exposure);
    return settings.srgbCurve ? srgbCurve(value) : value;
}

/// `alpha`: of all pixels, or empty.
void develop(SourcePlane &from, const DisplayPlane &plane, int planeNumber, const FrameWindow &w,
             const std::vector<float> &alpha, const PlaneSettings &settings) {
    const bool color = plane.source == Source::Color;
    const QuantizeRecord quantize = quantizeOf(plane, settings);
    std::vector<float> &values = from.values;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (color)
            values[i] =
                developedColor(values[i], from.exposed, alpha.empty() ? 1 : alpha[i], settings);
        if (quantize.one != 0) {
            const int x = w.x0 + int(i % w.columns()), y = w.y0 + int(i / w.columns());
            values[i] = quantized(values[i], quantize, ditherNoise(x, y, planeNumber));
        }
    }
}

/// Of the file's own pixels; empty if it has none, or none of their size.
std::vector<float> alphaOf(const DisplaySources &sources, const std::vector<DisplayPlane> &planes,
                           std::size_t pixels) {
    const auto alpha = std::ranges::find(planes, Source::Alpha, &DisplayPlane::source);
    if (alpha == planes.end())
        return {};
    auto from = sourcePlane(sources, *alpha, FilmHalf::Both);
    return from && from->values.size() == pixels ? std::move(from->values) : std::vector<float>();
}

/// A picture whose size a filter has changed is a frame of its own.
FrameWindow windowOf(const DisplaySources &sources, const std::vector<DisplayPlane> &planes) {
    const FrameWindow &film = sources.film.window();
    const auto size = planes.empty() ? std::nullopt : sizeOfPlane(sources, planes.front());
    if (!size || (size->width == film.columns() && size->height == film.rows()))
        return film;
    return {size->width, size->height, 0, size->width, 0, size->height};
}

std::string textOf(const PlaneSize &size) {
    return std::to_string(size.width) + " x " + std::to_string(size.height);
}

/// A file has one size: that of its first plane. What has another one is left out, with a warning.
std::vector<DisplayPlane> planesOfOneSize(const DisplaySources &sources,
                                          const std::vector<DisplayPlane> &planes,
                                          std::string &warning) {
    std::vector<DisplayPlane> kept;
    std::optional<PlaneSize> size;
    std::string missing, others;
    for (const DisplayPlane &plane : planes) {
        const auto own = sizeOfPlane(sources, plane);
        if (own && !size)
            size = own;
        if (own && *own == *size) {
            kept.push_back(plane);
            continue;
        }
        std::string &list = own ? others : missing;
        list += (list.empty() ? "" : ", ") + plane.name;
    }
    if (!missing.empty())
        warning += "there is no plane " + missing + ", which no filter has made";
    if (!others.empty())
        warning += (warning.empty() ? "" : "; ") +
                   ("filters have made the picture " + textOf(*size)) +
                   ", so that planes of another size are left out: " + others;
    return kept;
}

} // namespace

Picture developPicture(const DisplaySources &sources, const std::vector<DisplayPlane> &planes,
                       const PlaneSettings &settings) {
    Picture picture;
    picture.window = windowOf(sources, planes);
    const std::vector<float> alpha = settings.straightAlpha
                                         ? alphaOf(sources, planes, picture.window.pixels())
                                         : std::vector<float>();
    const auto add = [&](const std::string &layer, FilmHalf half) {
        for (std::size_t k = 0; k < planes.size(); ++k) {
            const DisplayPlane &plane = planes[k];
            const bool single = plane.source == Source::Depth || plane.source == Source::Variance;
            if (half != FilmHalf::Both && single)
                continue;
            std::optional<SourcePlane> from = sourcePlane(sources, plane, half);
            if (!from || from->values.size() != picture.window.pixels())
                continue;
            develop(*from, plane, int(k), picture.window, alpha, settings);
            picture.channels.push_back({layer + plane.name, std::move(from->values)});
        }
    };
    add("", FilmHalf::Both);
    if (settings.halves && sources.film.keepsHalves()) {
        add("half0.", FilmHalf::Even);
        add("half1.", FilmHalf::Odd);
    }
    return picture;
}

void handOver(const DisplaySources &sources, std::span<const PlannedDisplay> displays,
              const Options &options, const FrameDescription &frame, DisplayTaker &taker,
              bool isFinished) {
    for (const PlannedDisplay &display : displays) {
        if (!display.isTaken)
            continue;
        std::string unheard;
        const std::vector<DisplayPlane> planes = planesOfOneSize(sources, display.planes, unheard);
        const Job job{sources, options, frame, display.record, true, planes, {}, {}};
        PlaneSettings settings = planeSettings(job);
        settings.halves = false;
        settings.channels.clear(), settings.own.reset();
        Picture picture = developPicture(sources, planes, settings);
        describe(job, picture);
        taker.take(display.record.name, std::move(picture), isFinished);
    }
}

std::vector<std::string> writeDisplays(const DisplaySources &sources,
                                       std::span<const PlannedDisplay> displays,
                                       const Options &options, const FrameDescription &frame,
                                       DiagnosticSink &sink) {
    std::vector<std::string> written;
    for (const PlannedDisplay &display : displays) {
        if (!display.isFile)
            continue;
        std::string warning;
        const std::vector<DisplayPlane> planes = planesOfOneSize(sources, display.planes, warning);
        Job job{sources,          options, frame, display.record,
                display.standsIn, planes,  {},    std::move(warning)};
        if (planes.empty())
            job.problem = "there is nothing to write";
        const SourceLocation &where = display.record.parameters.where;
        const bool good = !planes.empty() && write(job, display);
        const std::string about = "Display \"" + display.record.name + "\": ";
        if (!job.warning.empty())
            sink.warning(where, about + job.warning);
        if (good)
            written.push_back(display.path);
        else
            sink.error(where, about + job.problem);
    }
    return written;
}

} // namespace candela
