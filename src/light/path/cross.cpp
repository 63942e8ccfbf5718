// SPDX-License-Identifier: Apache-2.0
// The segments that have led to the vertices, as the volumes see them that they lie in.
#include "foundation/base/lanes.h"
#include "light/path/light_in_volumes.h"
#include "light/path/stages.h"
#include "light/path/steps.h"
#include "light/sampling/sobol.h"

#include <algorithm>
#include <cmath>

namespace candela {

namespace {

/// Apart from the numbers that the surfaces' own random() has.
constexpr std::uint32_t ofVolumes = 0x80000000;

/// From where the ray began, or passed straight on, to the vertex.
void layOut(const PathWave &wave, int i, Segments &segments) {
    const int ray = wave.chunk.rays[i];
    const RayBatch &rays = wave.active.rays;
    const bool fromCamera = wave.vertex == 0 && wave.purpose == Purpose::Camera;
    const float length = wave.hits.t[ray] - (fromCamera ? 0 : rays.tMin[ray]);
    for (int c = 0; c < 3; ++c)
        segments.input(ShaderInput::I, c)[i] = length * rays.direction[c][ray];
}

/// Finds the volumes that the segments lie in. False if all are clear.
bool findSegments(PathWave &wave, Crossing &crossing) {
    SurfaceVertices &vertices = wave.chunk.vertices;
    Segments &segments = crossing.segments;
    segments.count = vertices.count();
    bool any = false;
    for (int i = 0; i < vertices.count(); ++i) {
        const SurfaceMedia &surface = vertices.mediaOf(i);
        MediaAround around(vertices.around()[0][i], vertices.around()[1][i]);
        const std::int32_t medium = around.towards(surface, vertices.isMetFromInside(i));
        segments.medium[i] = medium;
        if (medium == 0)
            continue;
        any = true;
        layOut(wave, i, segments);
        if (around.towardsAir(medium) != medium) // It began in the body.
            around = around.beyond({.interior = medium}, false, true);
        crossing.around[0][i] = around.inner(), crossing.around[1][i] = around.outer();
        crossing.atmosphere[0][i] = medium; // Where the ray is in nothing else.
    }
    return any;
}

void askAmbient(PathWave &wave, Crossing &crossing) {
    SurfaceVertices &vertices = wave.chunk.vertices;
    thread_local std::vector<std::int32_t> lightSet;
    thread_local std::array<float *, colorSamples> ambient;
    lightSet.clear();
    for (int i = 0; i < vertices.count(); ++i)
        lightSet.push_back(vertices.mediaOf(i).lightSet);
    for (int c = 0; c < colorSamples; ++c)
        std::fill_n(ambient[c] = crossing.ambient[c], vertices.count(), 0.0f);
    LightQuery query;
    query.count = vertices.count(), query.Ps = vertices.P(), query.lightSet = lightSet.data();
    wave.frame.scene.lights().ambient(query, ambient.data());
    crossing.segments.ambient = ambient.data();
}

/// Output parameters that displays show.
void seeParameters(PathWave &wave, const Segments::Group &group, const Segments &segments) {
    if (wave.purpose != Purpose::Camera)
        return;
    for (const ShaderChannelPlane &shown : wave.frame.shaderChannels.ofVolume(*group.code))
        addSeen(wave, shown, segments.outputs()[std::size_t(shown.output)], group.active.data());
}

void askVolumes(PathWave &wave, Crossing &crossing) {
    const Scene &scene = wave.frame.scene;
    VertexChunk &chunk = wave.chunk;
    Segments &segments = crossing.segments;
    ShaderArgs args;
    scene.bind(chunk.code, chunk.vertices.points, args);
    segments.endAt(chunk.vertices.points, args.objectMatrices);
    randomBits(chunk.count(), chunk.paths.pixelKey, chunk.paths.sampleIndex,
               std::uint32_t(wave.vertex) ^ ofVolumes,
               reinterpret_cast<std::uint32_t *>(segments.input(ShaderInput::seed)));
    for (const Segments::Group &group : segments.begin(scene)) {
        const ir::VolumeFacts &facts = group.code->volumeFacts();
        segments.ambient = nullptr;
        if (facts.readsAmbient && scene.lights().hasAmbient())
            askAmbient(wave, crossing);
        if (facts.asksForLight)
            askLit(wave, crossing, group);
        else
            segments.ask(group, nullptr, true);
        seeParameters(wave, group, segments);
    }
}

/// What is not finite is reported, and black.
void dropNonFinite(PathWave &wave, Crossing &crossing) {
    const Segments::Answers &answers = crossing.segments.answers();
    const int count = wave.chunk.count();
    const auto isFinite = [&](const std::array<float *, colorSamples> &planes) {
        return std::ranges::all_of(planes,
                                   [&](const float *p) { return lanes::allFinite(count, p); });
    };
    if (isFinite(answers.Ci) && isFinite(answers.Oi) && isFinite(answers.CiOfCi) &&
        isFinite(answers.CiOfOi) && isFinite(answers.OiOfOi))
        return;
    for (int i = 0; i < count; ++i) {
        bool finite = true;
        for (std::size_t c = 0; c < colorSamples; ++c)
            finite &= std::isfinite(answers.Ci[c][i]) && std::isfinite(answers.Oi[c][i]) &&
                      std::isfinite(answers.CiOfCi[c][i]) && std::isfinite(answers.CiOfOi[c][i]) &&
                      std::isfinite(answers.OiOfOi[c][i]);
        if (finite)
            continue;
        reportNonFinite(wave, i, wave.frame.scene.medium(crossing.segments.medium[i]).code->name());
        for (std::size_t c = 0; c < colorSamples; ++c) {
            answers.Ci[c][i] = answers.CiOfCi[c][i] = answers.CiOfOi[c][i] = 0;
            answers.OiOfOi[c][i] = 0, answers.Oi[c][i] = 1;
        }
    }
}

/// What the volumes send and hide joins what the samples have; what comes from behind is worth what
/// they let through.
void apply(PathWave &wave, const Segments::Answers &answers) {
    PathsAtVertices &paths = wave.chunk.paths;
    for (std::size_t c = 0; c < colorSamples; ++c) {
        const int plane = int(c);
        float *throughput = paths.throughput[plane], *veil = paths.veil[plane];
        float *cover = paths.cover[plane], *light = paths.light[plane];
        float *opacity = wave.results.opacity[plane];
        for (int i = 0; i < wave.chunk.count(); ++i) {
            light[i] += throughput[i] * answers.Ci[c][i] + veil[i] * answers.Oi[c][i];
            if (paths.seen[i])
                opacity[paths.slot[i]] += cover[i] * answers.Oi[c][i];
            veil[i] = throughput[i] * answers.CiOfOi[c][i] + veil[i] * answers.OiOfOi[c][i];
            throughput[i] *= answers.CiOfCi[c][i];
            cover[i] *= answers.OiOfOi[c][i];
        }
    }
}

} // namespace

Crossing::Crossing(int capacity)
    : segments(capacity), point(capacity), around(2, capacity), atmosphere(1, capacity),
      ambient(colorSamples, capacity) {}

Crossing &crossingOf(PathWave &wave) {
    if (!wave.crossing)
        wave.crossing = std::make_unique<Crossing>(VertexChunk::capacity);
    return *wave.crossing;
}

void cross(PathWave &wave) {
    if (!wave.frame.scene.hasVolumes())
        return;
    Crossing &crossing = crossingOf(wave);
    takeMedia(wave);
    if (!findSegments(wave, crossing))
        return;
    askVolumes(wave, crossing);
    dropNonFinite(wave, crossing);
    apply(wave, crossing.segments.answers());
}

} // namespace candela
