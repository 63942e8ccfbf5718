// SPDX-License-Identifier: Apache-2.0
#include "image/imager.h"

#include "foundation/base/parallel.h"
#include "foundation/units/color.h"
#include "image/imaging.h"

#include <algorithm>
#include <cmath>

namespace candela {

namespace {

using Source = DisplayPlane::Source;

constexpr int batch = 512;

std::vector<float> planeOf(const DisplaySources &sources, const DisplayPlane &plane,
                           const PlaneSize &size) {
    const auto own = sizeOfPlane(sources, plane);
    if (own && *own == size)
        return sourcePlane(sources, plane).value_or(SourcePlane{}).values;
    return std::vector<float>(std::size_t(size.width) * std::size_t(size.height), 1);
}

/// What the imager is given of the picture, and gives back.
struct PixelPlanes {
    PlaneSize size;
    int x0 = 0, y0 = 0;             ///< Raster position of the first pixel.
    std::array<int, 2> frame{1, 1}; ///< Pixels of the whole frame, of which these are a window.
    /// The colour samples, then the opacity's, then alpha.
    std::vector<std::vector<float>> planes;
};

PixelPlanes exposedPixels(const DisplaySources &sources, const ExposureRecord &exposure,
                          const std::array<int, 2> &frame) {
    PixelPlanes pixels;
    pixels.size = sizeOfPlane(sources, {Source::Color, "Ci", 0, ""}).value_or(PlaneSize{});
    pixels.frame = {pixels.size.width, pixels.size.height};
    const FrameWindow &w = sources.film.window();
    if (pixels.size == PlaneSize{w.columns(), w.rows()})
        pixels.x0 = w.x0, pixels.y0 = w.y0, pixels.frame = frame;
    for (int c = 0; c < colorSamples; ++c) {
        pixels.planes.push_back(planeOf(sources, {Source::Color, "Ci", c, ""}, pixels.size));
        for (float &value : pixels.planes.back())
            value = exposed(value, exposure);
    }
    for (int c = 0; c < colorSamples; ++c)
        pixels.planes.push_back(planeOf(sources, {Source::Channel, "Oi", c, ""}, pixels.size));
    pixels.planes.push_back(planeOf(sources, {Source::Alpha, "Oi", 0, ""}, pixels.size));
    return pixels;
}

/// The planes of a batch, padded and aligned as shaders want them.
struct ImagerBatch {
    explicit ImagerBatch(const QuestionCode &question)
        : inputs(int(ShaderInput::Count), batch),
          outputs(int(question.function.outputs.size()), batch), offsets(1, batch) {
        for (int plane = 0; plane < inputs.planes(); ++plane)
            inputTable.push_back(inputs[plane]);
        for (int plane = 0; plane < outputs.planes(); ++plane)
            outputTable.push_back(outputs[plane]);
    }
    float *input(ShaderInput which, int component = 0) const {
        return inputs[int(which) + component];
    }
    Planes<float> inputs, outputs;
    Planes<std::int32_t> offsets;
    std::vector<const float *> inputTable;
    std::vector<float *> outputTable;
};

void give(const PixelPlanes &pixels, std::size_t first, int count, const ImagerBatch &to) {
    const std::size_t columns = std::size_t(pixels.size.width);
    for (int i = 0; i < count; ++i) {
        const std::size_t pixel = first + std::size_t(i);
        const float x = float(pixels.x0 + int(pixel % columns)) + 0.5f;
        const float y = float(pixels.y0 + int(pixel / columns)) + 0.5f;
        to.input(ShaderInput::P, 0)[i] = x, to.input(ShaderInput::P, 1)[i] = y;
        to.input(ShaderInput::P, 2)[i] = 0;
        for (ShaderInput across : {ShaderInput::u, ShaderInput::s})
            to.input(across)[i] = x / float(pixels.frame[0]);
        for (ShaderInput down : {ShaderInput::v, ShaderInput::t})
            to.input(down)[i] = y / float(pixels.frame[1]);
    }
    for (int c = 0; c < colorSamples; ++c) {
        std::copy_n(pixels.planes[c].data() + first, count, to.input(ShaderInput::pixelCi, c));
        std::copy_n(pixels.planes[colorSamples + c].data() + first, count,
                    to.input(ShaderInput::pixelOi, c));
    }
    std::copy_n(pixels.planes.back().data() + first, count, to.input(ShaderInput::pixelAlpha));
}

void take(const QuestionCode &question, const ImagerBatch &from, std::size_t first, int count,
          PixelPlanes &pixels) {
    const auto plane = [&](ir::OutputKind kind, int component) {
        return from.outputs[question.output(kind) + component];
    };
    for (int c = 0; c < colorSamples; ++c)
        std::copy_n(plane(ir::OutputKind::Ci, c), count, pixels.planes[c].data() + first);
    std::copy_n(plane(ir::OutputKind::alpha, 0), count, pixels.planes.back().data() + first);
}

void makeFinite(PixelPlanes &pixels, const std::string &imager, DiagnosticSink &diagnostics) {
    std::size_t bad = 0;
    for (std::vector<float> &plane : pixels.planes)
        for (float &value : plane)
            if (!std::isfinite(value))
                value = 0, ++bad;
    if (bad > 0)
        diagnostics.warning({}, std::to_string(bad) + " values of what the imager \"" + imager +
                                    "\" made are not finite (inf or nan); they count as 0");
}

} // namespace

std::optional<Imager> Imager::of(const Options &options, ShaderLibrary &library,
                                 DiagnosticSink &diagnostics) {
    if (!options.imager)
        return std::nullopt;
    auto instance =
        library.instance(ShaderKind::Imager, *options.imager, options, ir::LightRule::Path, {});
    if (!instance)
        return std::nullopt;
    library.makeReady();
    if (!instance->code->question(ir::Question::Imager).code)
        return std::nullopt;
    instance->code->bindSpaces(options.coordinateSystems, diagnostics);
    return Imager(std::move(*instance), options);
}

ImagedPicture Imager::run(const DisplaySources &sources, DiagnosticSink &diagnostics) const {
    PixelPlanes pixels = exposedPixels(sources, exposure_, frame_);
    const QuestionCode &question = instance_.code->question(ir::Question::Imager);
    const std::size_t count = pixels.planes[0].size();
    parallelFor((count + batch - 1) / batch, [&](std::size_t k) {
        const std::size_t first = k * batch;
        const int lanes = int(std::min<std::size_t>(batch, count - first));
        ImagerBatch lanesOf(question);
        give(pixels, first, lanes, lanesOf);
        std::fill_n(lanesOf.input(ShaderInput::time), lanes, time_);
        std::fill_n(lanesOf.offsets[0], lanes, instance_.parameterOffset);
        ShaderArgs args;
        args.count = lanes;
        args.inputs = lanesOf.inputTable.data();
        args.parameterOffset = lanesOf.offsets[0];
        args.outputs = lanesOf.outputTable.data();
        instance_.code->bind(args);
        question.ask(args);
        take(question, lanesOf, first, lanes, pixels);
    });
    pixels.planes.erase(pixels.planes.begin() + colorSamples, pixels.planes.end() - 1); // Oi
    makeFinite(pixels, instance_.code->name(), diagnostics);
    ImagedPicture result{pixels.size, {}, std::move(pixels.planes.back())};
    pixels.planes.resize(colorSamples);
    result.color = std::move(pixels.planes);
    return result;
}

} // namespace candela
