// SPDX-License-Identifier: Apache-2.0
#include "image/displays.h"

#include "foundation/base/whole_file.h"
#include "foundation/units/color.h"
#include "image/exr_file.h"
#include "image/imaging.h"
#include "image/png_file.h"

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
    const Film &film;
    const Options &options;
    const FrameDescription &frame;
    const DisplayRecord &display;
    const std::vector<DisplayPlane> &planes;
    std::string problem, warning;
};

PlaneSettings planeSettings(const Job &job) {
    const auto usable = [](float value) { return value > 0 && std::isfinite(value); };
    PlaneSettings settings;
    settings.gain = job.options.exposureGain;
    settings.gamma = usable(job.options.exposureGamma) ? job.options.exposureGamma : 1;
    settings.halves = wantsHalves(job.display);
    return settings;
}

void describe(const Job &job, Picture &picture) {
    const Options &options = job.options;
    picture.pixelAspectRatio =
        options.format.pixelAspectRatio > 0 ? options.format.pixelAspectRatio : 1;
    picture.worldToCamera = job.frame.worldToCamera;
    picture.worldToNdc = job.frame.worldToNdc;
    picture.metadata = job.frame.metadata;
    picture.metadata["units"] = "W m^-2 sr^-1";
    picture.metadata["luminousEfficacy"] = shortNumber(luminousEfficacy) + " lm/W";
    picture.metadata["exposure"] =
        shortNumber(options.exposureGain) + " " + shortNumber(options.exposureGamma);
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
    Picture picture = developPicture(job.film, job.planes, settings);
    describe(job, picture);
    noteQuantize(picture, settings.color);
    return encodeExr(picture, job.problem);
}

std::optional<std::string> pngBytes(Job &job) {
    PlaneSettings settings = planeSettings(job);
    settings.quantizeAll = true;
    settings.halves = false;
    settings.color =
        job.display.quantize.value_or(job.options.colorQuantize.value_or(eightBitQuantize));
    if (settings.color.one == 0) {
        job.warning = "a PNG picture holds whole numbers only: quantised by 255 0 255 0.5";
        settings.color = eightBitQuantize;
    }
    settings.depth = depthQuantize(job.display, job.options);
    Picture picture = developPicture(job.film, job.planes, settings);
    describe(job, picture);
    noteQuantize(picture, settings.color);
    const bool depth = std::ranges::any_of(
        job.planes, [](const DisplayPlane &plane) { return plane.source == Source::Depth; });
    const float largest = std::max(settings.color.maximum, depth ? settings.depth.maximum : 0);
    return encodePng(picture, largest > 255 ? 16 : 8, settings.gamma, job.problem);
}

bool write(Job &job, const PlannedDisplay &display) {
    const auto bytes = display.format == FileFormat::Png ? pngBytes(job) : exrBytes(job);
    return bytes && writeWholeFile(display.path, *bytes, job.problem);
}

std::vector<float> rawPlane(const Film &film, const DisplayPlane &plane, FilmHalf half) {
    if (plane.source == Source::Variance)
        return film.varianceOfMean(plane.component);
    const int channel = film.channelIndex(plane.channel);
    if (plane.source != Source::Alpha)
        return film.mean(channel, plane.component, half);
    std::vector<float> alpha = film.mean(channel, 0, half);
    for (int c = 1; c < colorSamples; ++c) {
        const std::vector<float> opacity = film.mean(channel, c, half);
        for (std::size_t i = 0; i < alpha.size(); ++i)
            alpha[i] += opacity[i];
    }
    for (float &value : alpha)
        value /= colorSamples;
    return alpha;
}

void develop(std::vector<float> &values, const DisplayPlane &plane, int planeNumber,
             const FrameWindow &w, const PlaneSettings &settings) {
    const bool color = plane.source == Source::Color;
    const bool depth = plane.source == Source::Depth;
    const bool whole = color || depth || plane.source == Source::Alpha || settings.quantizeAll;
    const QuantizeRecord &quantize = depth ? settings.depth : settings.color;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (color)
            values[i] = exposed(values[i], settings.gain, settings.gamma);
        if (whole && quantize.one != 0) {
            const int x = w.x0 + int(i % w.columns()), y = w.y0 + int(i / w.columns());
            values[i] = quantized(values[i], quantize, ditherNoise(x, y, planeNumber));
        }
    }
}

} // namespace

Picture developPicture(const Film &film, const std::vector<DisplayPlane> &planes,
                       const PlaneSettings &settings) {
    Picture picture;
    picture.window = film.window();
    const auto add = [&](const std::string &layer, FilmHalf half) {
        for (std::size_t k = 0; k < planes.size(); ++k) {
            const DisplayPlane &plane = planes[k];
            const bool single = plane.source == Source::Depth || plane.source == Source::Variance;
            if (half != FilmHalf::Both && single)
                continue;
            PictureChannel channel{layer + plane.name, rawPlane(film, plane, half)};
            develop(channel.values, plane, int(k), film.window(), settings);
            picture.channels.push_back(std::move(channel));
        }
    };
    add("", FilmHalf::Both);
    if (settings.halves && film.keepsHalves()) {
        add("half0.", FilmHalf::Even);
        add("half1.", FilmHalf::Odd);
    }
    return picture;
}

std::vector<std::string> writeDisplays(const Film &film, std::span<const PlannedDisplay> displays,
                                       const Options &options, const FrameDescription &frame,
                                       DiagnosticSink &sink) {
    std::vector<std::string> written;
    for (const PlannedDisplay &display : displays) {
        Job job{film, options, frame, display.record, display.planes, {}, {}};
        const SourceLocation &where = display.record.parameters.where;
        const bool good = write(job, display);
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
