// SPDX-License-Identifier: Apache-2.0
// Paths from lights cross volumes: a segment lets through what it would for the eye that looks
// against it. What volumes send themselves camera paths find, so they ask for no light here.
#include "foundation/base/hash.h"
#include "light/bidir/light_wave.h"
#include "light/path/steps.h"
#include "light/vertex/vectors.h"

#include <bit>
#include <cmath>

namespace candela {

namespace {

/// The air before a light that is no surface is that of what it shines on.
constexpr std::int32_t airOfTheLit = -1;

/// The segment that ends, for the eye, where the ray has begun.
void layOut(const RayBatch &rays, float t, int ray, int i, Segments &segments) {
    std::uint64_t bits = 0;
    for (int c = 0; c < 3; ++c) {
        const float origin = rays.origin[c][ray], along = rays.direction[c][ray];
        segments.input(ShaderInput::P, c)[i] = origin + rays.tMin[ray] * along;
        segments.input(ShaderInput::I, c)[i] = (rays.tMin[ray] - t) * along;
        bits = mixBits(bits ^ std::bit_cast<std::uint32_t>(origin) ^
                       (std::uint64_t(std::bit_cast<std::uint32_t>(along)) << 32));
    }
    segments.input(ShaderInput::time)[i] = rays.time[ray];
    segments.input(ShaderInput::seed)[i] = std::bit_cast<float>(std::uint32_t(bits >> 32));
}

/// False if all segments are clear.
bool findSegments(LightWave &wave, Segments &segments) {
    SurfaceVertices &vertices = wave.chunk.vertices;
    const PathMedia &media = wave.active.media;
    segments.count = vertices.count();
    bool some = false;
    for (int i = 0; i < vertices.count(); ++i) {
        const int ray = wave.chunk.rays[i];
        SurfaceMedia near = vertices.mediaOf(i);
        if (media.air[ray] != airOfTheLit)
            near.atmosphere = media.air[ray];
        const MediaAround around(vertices.around()[0][i], vertices.around()[1][i]);
        const std::int32_t entered = media.entered[ray];
        segments.medium[i] =
            entered != 0 ? entered : around.towards(near, vertices.isMetFromInside(i));
        if (segments.medium[i] == 0)
            continue;
        some = true;
        layOut(wave.active.rays, wave.hits.t[ray], ray, i, segments);
    }
    return some;
}

} // namespace

void enterMedia(LightWave &wave) {
    const Scene &scene = wave.frame.scene;
    const int count = wave.active.count;
    PathMedia &media = wave.active.media;
    beginMedia(count, media);
    for (int i = 0; i < count; ++i) {
        const int slot = wave.active.slot[i];
        const std::int32_t light = wave.starts.light[slot];
        const bool isSurface = wave.starts.element[slot] >= 0;
        media.air[i] = isSurface                         ? scene.mediumOfLight(light)
                       : scene.lights().isDistant(light) ? 0
                                                         : airOfTheLit;
        media.entered[i] = 0;
    }
    if (!scene.hasInteriors())
        return;
    std::vector<MediaAround> around(static_cast<std::size_t>(count));
    scene.bodiesAround(wave.active.rays, around.data());
    for (int i = 0; i < count; ++i)
        media.around[0][i] = around[std::size_t(i)].inner(),
        media.around[1][i] = around[std::size_t(i)].outer();
}

void crossAgainstLight(PathWave &path) {
    LightWave &wave = static_cast<LightWave &>(path);
    const Scene &scene = wave.frame.scene;
    if (!scene.hasVolumes())
        return;
    VertexChunk &chunk = wave.chunk;
    takeMedia(wave);
    Segments &segments = crossingOf(wave).segments;
    if (!findSegments(wave, segments))
        return;
    ShaderArgs args;
    scene.bind(chunk.code, chunk.vertices.points, args);
    segments.endAnywhere(args.objectMatrices);
    for (const Segments::Group &group : segments.begin(scene))
        segments.askTransmission(group);
    for (int c = 0; c < colorSamples; ++c)
        for (int i = 0; i < chunk.count(); ++i) {
            const float factor = segments.answers().CiOfCi[std::size_t(c)][i];
            const float passes = std::isfinite(factor) ? factor : 0.0f;
            chunk.paths.throughput[c][i] *= passes;
            wave.active.throughput[c][chunk.rays[i]] *= passes; // What passes straight on.
        }
}

} // namespace candela
