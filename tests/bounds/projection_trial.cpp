// SPDX-License-Identifier: Apache-2.0
// Projections by bounds against plain refinement, at the same true error:
//
//     projection_trial FOLDER/SHADER.sl...
//
// prints, of each shader over the unit square and of tolerances of the mean of its reflectance, the
// true error (against 4096 x 4096 samples), what bounds cost to get there and what n x n samples
// cost that come as near and stay so for all larger n.
#include "world/shading/shader_library.h"
#include "world/shading/shader_projection.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace candela {
namespace {

void place(BoxBounds &boxes, int lane, const ParameterBox &box) {
    const auto u = float(box.u), v = float(box.v);
    boxes.set(ShaderInput::P, lane, {2 * u - 1, 1 - 2 * v, 0});
    for (ShaderInput normal : {ShaderInput::N, ShaderInput::Ng, ShaderInput::fieldAxis})
        boxes.set(normal, lane, {0, 0, -1});
    boxes.set(ShaderInput::I, lane, {0, 0, 1});
    boxes.set(ShaderInput::dPdu, lane, {2, 0, 0});
    boxes.set(ShaderInput::dPdv, lane, {0, -2, 0});
    boxes.set(ShaderInput::u, lane, {u}), boxes.set(ShaderInput::s, lane, {u});
    boxes.set(ShaderInput::v, lane, {v}), boxes.set(ShaderInput::t, lane, {v});
    boxes.set(ShaderInput::dsdu, lane, {1}), boxes.set(ShaderInput::dtdv, lane, {1});
    boxes.set(ShaderInput::du, lane, {1.0f / 1024}),
        boxes.set(ShaderInput::dv, lane, {1.0f / 1024});
    boxes.set(ShaderInput::Cs, lane, {.8f, .6f, .4f}), boxes.set(ShaderInput::Os, lane, {1, 1, 1});
}

double seconds() { return double(std::clock()) / CLOCKS_PER_SEC; }

/// The mean over n x n samples, channel 0.
double mean(BoxBounds &boxes, int n, int most) {
    double sum = 0;
    for (int first = 0; first < n * n; first += most) {
        const int count = std::min(most, n * n - first);
        for (int i = 0; i < count; ++i)
            place(boxes, i, {((first + i) % n + .5) / n, ((first + i) / n + .5) / n, 0, 0});
        boxes.askValues(count);
        for (int i = 0; i < count; ++i)
            sum += double(boxes.reflectance().value[0][i]);
    }
    return sum / n / n;
}

/// Seconds that a box costs, and a point.
std::pair<double, double> costs(BoxBounds &boxes, int most) {
    constexpr int rounds = 40;
    for (int i = 0; i < most; ++i)
        place(boxes, i, {(i % 32 + .5) / 32, (i / 32 + .5) / 32, 1.0 / 32, 1.0 / 32});
    for (int i = 0; i < most; ++i)
        boxes.set(ShaderInput::Du, i, {1.0f / 32}), boxes.set(ShaderInput::Dv, i, {1.0f / 32});
    const double start = seconds();
    for (int n = 0; n < rounds; ++n)
        boxes.ask(most);
    const double between = seconds();
    for (int n = 0; n < rounds; ++n)
        boxes.askValues(most);
    const double asked = double(rounds) * most;
    return {(between - start) / asked, (seconds() - between) / asked};
}

void tryShader(const std::filesystem::path &file) {
    DiagnosticList diagnostics;
    ShaderLibrarySettings settings;
    settings.folders = {file.parent_path().string()};
    ShaderLibrary library(settings, diagnostics);
    ShaderRecord record;
    record.name = file.stem().string();
    const auto instance =
        library.instance(ShaderKind::Surface, record, Options(), ir::LightRule::Path, {});
    if (!instance)
        return void(std::printf("%s\n", diagnostics.text().c_str()));
    instance->code->bindSpaces({}, diagnostics);
    constexpr int most = 512, finest = 4096;
    BoxBounds boxes(*instance, most);
    const auto [box, point] = costs(boxes, most);
    std::printf("%-16s a box costs %.3f us, a point %.3f\n", record.name.c_str(), 1e6 * box,
                1e6 * point);
    const double reference = mean(boxes, finest, most);
    struct Plain {
        int n;
        double error, time;
    };
    std::vector<Plain> plain;
    for (int n = 2; n <= 2048; n *= 2) {
        const double start = seconds(), value = mean(boxes, n, most);
        plain.push_back({n, std::abs(value - reference), seconds() - start});
    }
    for (float tolerance : {3e-2f, 1e-2f, 3e-3f, 1e-3f}) {
        ProjectionSettings wanted;
        wanted.tolerance = tolerance;
        wanted.mostBoxes = 1 << 20;
        const double start = seconds();
        const Projection found = project(*instance, place, {}, wanted);
        const double time = seconds() - start;
        const double error = std::abs(found.reflectance[0][0] - reference);
        auto same = plain.end();
        while (same != plain.begin() && (same - 1)->error <= std::max(error, 1e-7))
            --same;
        std::printf("%-16s tolerance %-6g certified %.2e true %.2e: %8ld boxes %8.2f ms; ",
                    record.name.c_str(), double(tolerance), found.error, error, found.boundCalls,
                    1e3 * time);
        if (same == plain.end())
            std::printf("plain: not within 2048 x 2048, %.0f ms\n", 1e3 * plain.back().time);
        else
            std::printf("plain %d x %d %8.2f ms, %.2f of it\n", same->n, same->n, 1e3 * same->time,
                        time / same->time);
    }
}

} // namespace
} // namespace candela

int main(int count, char **words) {
    for (int k = 1; k < count; ++k)
        candela::tryShader(words[k]);
    return 0;
}
