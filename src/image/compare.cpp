// SPDX-License-Identifier: Apache-2.0
#include "image/compare.h"

#include "foundation/units/color.h"

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <limits>

namespace candela {

namespace {

/// Keeps relative errors finite where the reference is black.
constexpr double relMseFloor = 0.01;

bool isWanted(const CompareSettings &settings, const std::string &name) {
    return settings.channels.empty() ||
           std::ranges::find(settings.channels, name) != settings.channels.end();
}

/// |a - b|, 0 for equal infinities and for two NaNs, infinite if only one is a number.
double distance(float a, float b) {
    if (a == b || (std::isnan(a) && std::isnan(b)))
        return 0;
    const double d = std::abs(double(a) - double(b));
    return std::isnan(d) ? std::numeric_limits<double>::infinity() : d;
}

bool isBeyond(double distance, float a, float b, const CompareSettings &settings) {
    if (std::isinf(distance))
        return true;
    const double larger = std::max(std::abs(double(a)), std::abs(double(b)));
    return distance > settings.tolerance && !(distance <= settings.relativeTolerance * larger);
}

ChannelComparison compareChannel(const PictureChannel &a, const PictureChannel &b,
                                 const FrameWindow &w, const CompareSettings &settings) {
    ChannelComparison result;
    result.name = a.name;
    double sum = 0, squares = 0, signedSum = 0, relative = 0, peak = 0, energy = 0;
    for (std::size_t i = 0; i < a.values.size(); ++i) {
        const float u = a.values[i], v = b.values[i];
        const double d = distance(u, v);
        if (i == 0 || d > result.largest) {
            result.largest = d;
            result.x = w.x0 + int(i % w.columns()), result.y = w.y0 + int(i / w.columns());
            result.valueA = u, result.valueB = v;
        }
        result.beyond += isBeyond(d, u, v, settings);
        sum += d;
        squares += d * d;
        signedSum += d == 0 ? 0 : double(u) - v;
        relative += std::isinf(d) ? d : d * d / (double(v) * v + relMseFloor);
        if (std::isfinite(v)) {
            peak = std::max(peak, std::abs(double(v)));
            energy += double(v) * v;
        }
    }
    const double count = double(a.values.size());
    result.mean = sum / count;
    result.meanDifference = signedSum / count;
    result.relMse = relative / count;
    if (energy > 0)
        result.normalizedMse = squares / energy;
    if (squares > 0)
        result.psnr = 10 * std::log10(peak * peak * count / squares);
    return result;
}

/// The channel that holds the variance of `name` in a picture, or null if there is none or it
/// would say nothing about the channel's values.
const PictureChannel *varianceOf(const Picture &picture, const std::string &name) {
    if (name.starts_with("radiance."))
        return picture.find("variance." + name.substr(std::string("radiance.").size()));
    const auto exposure = picture.metadata.find("exposure");
    const bool linear = exposure == picture.metadata.end() || exposure->second == "1 1";
    if (!linear || picture.metadata.contains("quantize"))
        return nullptr;
    return picture.find("variance." + name);
}

std::optional<Confidence> confidenceOf(const PictureChannel &a, const PictureChannel &b,
                                       const PictureChannel *varianceA,
                                       const PictureChannel *varianceB) {
    if (!varianceA || !varianceB)
        return std::nullopt;
    Confidence result;
    double sum = 0, variances = 0;
    for (std::size_t i = 0; i < a.values.size(); ++i) {
        const double variance = double(varianceA->values[i]) + varianceB->values[i];
        const double difference = double(a.values[i]) - b.values[i];
        if (!std::isfinite(variance) || !std::isfinite(difference) || variance <= 0)
            continue;
        ++result.pixels;
        result.chiSquare += difference * difference / variance;
        sum += difference;
        variances += variance;
    }
    if (result.pixels == 0)
        return std::nullopt;
    result.reduced = result.chiSquare / double(result.pixels);
    result.zOfMean = sum / std::sqrt(variances);
    result.probability = std::erfc(std::abs(result.zOfMean) / std::sqrt(2.0));
    return result;
}

std::optional<double> luminanceError(const Picture &a, const Picture &b) {
    double sum = 0;
    const PictureChannel *planes[2][3];
    for (int c = 0; c < 3; ++c) {
        planes[0][c] = a.find(std::string(1, "RGB"[c]));
        planes[1][c] = b.find(std::string(1, "RGB"[c]));
        if (!planes[0][c] || !planes[1][c])
            return std::nullopt;
    }
    for (std::size_t i = 0; i < a.window.pixels(); ++i) {
        double y[2] = {};
        for (int k = 0; k < 2; ++k)
            for (int c = 0; c < 3; ++c)
                y[k] += double(luminanceWeights[c]) * planes[k][c]->values[i];
        sum += (y[0] - y[1]) * (y[0] - y[1]) / (y[1] * y[1] + relMseFloor);
    }
    return sum / double(a.window.pixels());
}

std::string textOf(const FrameWindow &w) {
    char text[120];
    std::snprintf(text, sizeof text, "%d x %d with the window (%d,%d)-(%d,%d)", w.width, w.height,
                  w.x0, w.y0, w.x1 - 1, w.y1 - 1);
    return text;
}

[[gnu::format(printf, 2, 3)]] void append(std::string &text, const char *format, ...) {
    char line[512];
    va_list values;
    va_start(values, format);
    std::vsnprintf(line, sizeof line, format, values);
    va_end(values);
    text += line;
}

void reportChannel(std::string &text, const ChannelComparison &c) {
    append(text, "%-12s largest %.6g at (%d, %d): %.9g and %.9g\n", c.name.c_str(), c.largest, c.x,
           c.y, double(c.valueA), double(c.valueB));
    append(text, "%-12s mean %.6g, of a - b %.6g, relMSE %.6g", "", c.mean, c.meanDifference,
           c.relMse);
    if (c.normalizedMse)
        append(text, ", normalised MSE %.6g", *c.normalizedMse);
    if (c.psnr)
        append(text, ", PSNR %.2f dB", *c.psnr);
    append(text, ", %zu pixels beyond the tolerance\n", c.beyond);
    if (c.confidence)
        append(text,
               "%-12s chi-square %.6g over %zu pixels (%.4g each); mean difference %.3g standard "
               "deviations, p = %.3g\n",
               "", c.confidence->chiSquare, c.confidence->pixels, c.confidence->reduced,
               c.confidence->zOfMean, c.confidence->probability);
}

} // namespace

Comparison comparePictures(const Picture &a, const Picture &b, const CompareSettings &settings) {
    Comparison result;
    if (a.window != b.window) {
        result.problem = "the sizes differ: " + textOf(a.window) + ", and " + textOf(b.window);
        return result;
    }
    for (const std::string &name : settings.channels)
        if (!a.find(name) && !b.find(name))
            result.problem = "neither picture has the channel \"" + name + "\"";
    for (const PictureChannel &channel : b.channels)
        if (isWanted(settings, channel.name) && !a.find(channel.name))
            result.onlyInB.push_back(channel.name);
    for (const PictureChannel &channel : a.channels) {
        if (!isWanted(settings, channel.name))
            continue;
        const PictureChannel *other = b.find(channel.name);
        if (!other) {
            result.onlyInA.push_back(channel.name);
            continue;
        }
        ChannelComparison compared = compareChannel(channel, *other, a.window, settings);
        compared.confidence =
            confidenceOf(channel, *other, varianceOf(a, channel.name), varianceOf(b, channel.name));
        result.channels.push_back(std::move(compared));
    }
    if (result.problem.empty() && result.channels.empty())
        result.problem = "the pictures have no channel in common";
    if (settings.channels.empty())
        result.relMseOfLuminance = luminanceError(a, b);
    return result;
}

int exitCodeOf(const Comparison &comparison) {
    if (!comparison.problem.empty())
        return 2;
    const bool differ =
        std::ranges::any_of(comparison.channels, [](const auto &c) { return c.beyond > 0; });
    return differ || !comparison.onlyInA.empty() || !comparison.onlyInB.empty() ? 1 : 0;
}

std::string reportOf(const Comparison &comparison) {
    if (!comparison.problem.empty())
        return "not comparable: " + comparison.problem + "\n";
    std::string text;
    for (const ChannelComparison &channel : comparison.channels)
        reportChannel(text, channel);
    if (comparison.relMseOfLuminance)
        append(text, "luminance    relMSE %.6g\n", *comparison.relMseOfLuminance);
    for (const std::string &name : comparison.onlyInA)
        text += "channel " + name + " is only in the first picture\n";
    for (const std::string &name : comparison.onlyInB)
        text += "channel " + name + " is only in the second picture\n";
    return text + (exitCodeOf(comparison) == 0 ? "the same within the tolerance\n" : "different\n");
}

} // namespace candela
