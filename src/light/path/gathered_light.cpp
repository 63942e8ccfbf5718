// SPDX-License-Identifier: Apache-2.0
#include "light/path/gathered_light.h"

#include "foundation/base/hash.h"
#include "foundation/base/hot.h"
#include "foundation/base/lanes.h"
#include "light/path/stages.h"
#include "light/path/steps.h"
#include "light/sampling/mis.h"
#include "light/sampling/sobol.h"

#include <algorithm>
#include <cmath>

namespace candela {

namespace {

static_assert(int(roundPairs) <= int(cameraPairs));

CANDELA_HOT void weighRow(int count, const float *__restrict value, const float *__restrict factor,
                          const std::int32_t *__restrict light, float share, float *__restrict Cl) {
    for (int i = 0; i < count; ++i)
        Cl[i] = (light[i] != 0) & (factor[i] > 0) ? value[i] * factor[i] * share : 0.0f;
}

/// Rounds are samples of a sequence that belongs to the pixel and the number of the vertex.
void address(const PathWave &wave, RoundNumbers &numbers) {
    const PathsAtVertices &paths = wave.chunk.paths;
    const std::uint64_t salt = std::uint64_t(wave.vertex + 1) << 32;
    for (int i = 0; i < wave.chunk.count(); ++i) {
        numbers.pixelKey[i] = std::uint32_t(mixBits(salt | paths.pixelKey[i]) >> 32);
        numbers.sampleIndex[i] = paths.sampleIndex[i] * std::uint32_t(GatheredLight::rounds);
    }
}

/// Who wants light, and where they are in the picture.
void begin(PathWave &wave, RoundRays &rays) {
    const VertexChunk &chunk = wave.chunk;
    const int count = chunk.count();
    rays.lanes.clear();
    for (int i = 0; i < count; ++i) {
        const bool wanted = chunk.paths.depth[i] < wave.frame.settings.maxDepth;
        rays.wanted[i] = wanted ? 1.0f : 0.0f;
        if (wanted)
            rays.lanes.push_back(i);
    }
    lanes::gather(count, chunk.paths.slot, wave.results.x, rays.x);
    lanes::gather(count, chunk.paths.slot, wave.results.y, rays.y);
    const int *ray = chunk.rays.data();
    for (int i = 0; i < count; ++i) {
        const RayBatch &from = wave.active.rays;
        rays.width[i] = from.width[ray[i]] + from.spread[ray[i]] * wave.hits.t[ray[i]];
    }
}

/// All finite cones that the shader states, and a cosine lobe. Where answers don't add up they are
/// equal parts: the importance of a cone is the answer to a unit of light, which says little there.
void stateMixture(VertexChunk &chunk, bool hemisphereOnly, GatheredLight &gathered) {
    const int count = chunk.count();
    std::vector<ConePlanes> cones;
    if (!hemisphereOnly)
        cones = chunk.vertices.prepared().cones;
    GatheringCones &stated = gathered.cones;
    if (stated.importance.planes() < int(cones.size()))
        stated.importance = Planes<float>(int(cones.size()), chunk.vertices.lanes());
    for (std::size_t k = 0; k < cones.size() && !chunk.vertices.code().facts().affine; ++k) {
        float *importance = stated.importance[int(k)];
        const ConstVec3Planes &axis = cones[k].axis;
        for (int i = 0; i < count; ++i)
            importance[i] = axis[0][i] != 0 || axis[1][i] != 0 || axis[2][i] != 0 ? 1.0f : 0.0f;
        cones[k].importance = importance;
    }
    const ConstVec3Planes facing = chunk.vertices.facingPlanes();
    cones.push_back(
        {facing, stated.hemisphere, stated.one, stated.one, stated.hemisphere, 0, true});
    gathered.mixture.state(count, cones, facing, chunk.events.transmission());
}

/// One light by chance, weighted against the chance that a direction finds it.
void addLightRow(PathWave &wave, GatheredLight &gathered, LightGroup group, float share, int row) {
    VertexChunk &chunk = wave.chunk;
    SurfaceVertices &vertices = chunk.vertices;
    RoundRays &rays = gathered.rays;
    const RoundNumbers &numbers = gathered.numbers;
    LightSamples &samples = gathered.sample.samples;
    const int count = chunk.count();
    vertices.scene().lights().sample(
        group,
        lightQuery(vertices, chunk.N, gathered.wave ? rays.wanted : nullptr,
                   {numbers.x(lightPair), numbers.x(onLightPair), numbers.y(onLightPair)}),
        samples);
    std::fill_n(rays.pdf, count, 0.0f);
    if (gathered.wave) {
        const Planes<float> &unit = rays.direction;
        unitDirections(count, samples.L[0], samples.L[1], samples.L[2], unit[0], unit[1], unit[2]);
        gathered.mixture.pdf({unit[0], unit[1], unit[2]}, rays.pdf);
        leaveToLightSampling(vertices.code(), count, samples.light, rays.pdf);
    }
    lightSampleFactors(count, samples.pdfSolidAngle, rays.pdf, rays.wanted, rays.factor);
    const MutableVec3Planes L = gathered.rows.L(row);
    for (int c = 0; c < 3; ++c)
        std::copy_n(samples.L[c], count, L[c]);
    std::copy_n(samples.light, count, gathered.rows.light(row));
    const std::array<float *, colorSamples> Cl = gathered.rows.Cl(row);
    for (int c = 0; c < colorSamples; ++c)
        weighRow(count, samples.value[c], rays.factor, samples.light, share, Cl[c]);
    const int shadowed =
        lanesInNeedOfShadowRays(count, samples, Cl.data(), rays.inShadow, rays.shadowed);
    wave.frame.statistics.shadowRays +=
        gathered.shadow.attenuate(vertices, samples, shadowed, rays.shadowed, Cl.data());
}

/// Directions of the mixture, and paths along them.
void followDirections(PathWave &wave, GatheredLight &gathered) {
    VertexChunk &chunk = wave.chunk;
    SurfaceVertices &vertices = chunk.vertices;
    RoundRays &rays = gathered.rays;
    const RoundNumbers &numbers = gathered.numbers;
    const ConstVec3Planes along{rays.direction[0], rays.direction[1], rays.direction[2]};
    const MutableVec3Planes origin{rays.origin[0], rays.origin[1], rays.origin[2]};
    gathered.mixture.sample(numbers.x(alongPair), numbers.y(alongPair),
                            {rays.direction[0], rays.direction[1], rays.direction[2]});
    gathered.mixture.pdf(along, rays.pdf);
    vertices.rayOrigins(along, origin);
    spreadOfDirections(chunk.count(), rays.pdf, rays.spread);
    const bool inMedia = wave.frame.scene.hasVolumes();
    for (int i = 0; inMedia && i < chunk.count(); ++i) {
        const MediaAround around = vertices.mediaAlong(i, along);
        rays.around[0][i] = around.inner(), rays.around[1][i] = around.outer();
    }
    startGathering(*gathered.wave, int(rays.lanes.size()), rays.lanes.data(),
                   {{origin[0], origin[1], origin[2]},
                    along,
                    chunk.N,
                    vertices.points.input(int(ShaderInput::time)),
                    rays.width,
                    rays.spread,
                    rays.pdf,
                    chunk.paths.depth,
                    vertices.points.lightSet,
                    chunk.code,
                    inMedia ? &rays.around : nullptr,
                    rays.x,
                    rays.y,
                    numbers.pixelKey,
                    numbers.sampleIndex});
    follow(*gathered.wave);
}

/// What comes along a direction of the mixture, from paths of its own.
void addDirectionRow(PathWave &wave, GatheredLight &gathered, float share, int row) {
    followDirections(wave, gathered);
    const RoundRays &rays = gathered.rays;
    const int count = wave.chunk.count();
    const MutableVec3Planes L = gathered.rows.L(row);
    for (int c = 0; c < 3; ++c)
        std::copy_n(rays.direction[c], count, L[c]);
    std::fill_n(gathered.rows.light(row), count, 0);
    const std::array<float *, colorSamples> Cl = gathered.rows.Cl(row);
    for (int c = 0; c < colorSamples; ++c) {
        const float *radiance = gathered.wave->results.radiance[c];
        std::fill_n(Cl[c], count, 0.0f);
        for (std::size_t ray = 0; ray < rays.lanes.size(); ++ray) {
            const int i = rays.lanes[ray];
            const float divisor = float(M_PI) * rays.pdf[i];
            Cl[c][i] = rays.pdf[i] > 0 ? radiance[ray] * share / divisor : 0.0f;
        }
    }
}

std::array<float *, colorSamples> shade(VertexChunk &chunk, GatheredLight &gathered, int rows,
                                        const float *const *ambient, const Planes<float> &to) {
    std::array<float *, colorSamples> Ci, Oi;
    for (int c = 0; c < colorSamples; ++c)
        Ci[c] = to[c], Oi[c] = gathered.Oi[c];
    chunk.vertices.shade(rows, gathered.rows.L(0).data(), gathered.rows.Cl(0).data(),
                         gathered.rows.light(0), ambient, Ci.data(), Oi.data());
    return Ci;
}

/// A shader's own emission is what it sends in darkness. Where it makes the surface a light, hits
/// and light samples count it.
void subtractEmission(VertexChunk &chunk, GatheredLight &gathered,
                      const std::array<float *, colorSamples> &Ci) {
    const int count = chunk.count();
    if (!chunk.vertices.code().facts().emits ||
        lanes::allEqual(count, chunk.vertices.points.light, 0))
        return;
    const std::array<float *, colorSamples> dark =
        shade(chunk, gathered, 0, nullptr, gathered.darkness);
    for (int c = 0; c < colorSamples; ++c)
        for (int i = 0; i < count; ++i)
            Ci[c][i] -= dark[c][i];
}

GatheredLight &gatheredLight(PathWave &wave) {
    if (!wave.gathered) {
        std::unique_ptr<PathWave> finder;
        if (wave.purpose == Purpose::Camera)
            finder = std::make_unique<PathWave>(wave.frame, Purpose::Gathering);
        wave.gathered = std::make_unique<GatheredLight>(VertexChunk::capacity, std::move(finder));
    }
    return *wave.gathered;
}

} // namespace

GatheredLight::GatheredLight(int capacity, std::unique_ptr<PathWave> finder)
    : wave(std::move(finder)), mixture(capacity), cones(capacity), numbers(capacity),
      rays(capacity), sample(capacity), shadow(capacity), Ci(colorSamples, capacity),
      Oi(colorSamples, capacity), darkness(colorSamples, capacity) {
    std::fill_n(cones.hemisphere, capacity, 180.0f);
    std::fill_n(cones.one, capacity, 1.0f);
    rows.reserve((1 + lightGroups) * rounds, paddedLanes(capacity));
}

GatheredLight::~GatheredLight() = default;

int gatherLight(PathWave &wave, int rounds) {
    VertexChunk &chunk = wave.chunk;
    GatheredLight &gathered = gatheredLight(wave);
    const int count = chunk.count();
    const float share = 1.0f / float(rounds);
    chunk.events.look(chunk.vertices);
    begin(wave, gathered.rays);
    stateMixture(chunk, wave.frame.settings.hemisphereOnly, gathered);
    stateLightNormals(chunk, gathered.mixture);
    address(wave, gathered.numbers);
    gathered.rowCount = 0;
    for (int round = 0; round < rounds; ++round) {
        const RoundNumbers &numbers = gathered.numbers;
        for (RoundPair pair : {onLightPair, alongPair, lightPair})
            sobolPairs(count, numbers.pixelKey, numbers.sampleIndex, pair, numbers.x(pair),
                       numbers.y(pair));
        for (LightGroup group : wave.frame.scene.lights().groupsInUse())
            addLightRow(wave, gathered, group, share, gathered.rowCount++);
        if (gathered.wave)
            addDirectionRow(wave, gathered, share, gathered.rowCount++);
        for (int i = 0; i < count; ++i)
            ++numbers.sampleIndex[i];
    }
    return gathered.rowCount;
}

void lightGathered(PathWave &wave) {
    VertexChunk &chunk = wave.chunk;
    const int rows = gatherLight(wave, GatheredLight::rounds);
    GatheredLight &gathered = *wave.gathered;
    const std::array<float *, colorSamples> Ci =
        shade(chunk, gathered, rows, chunk.ambient, gathered.Ci);
    subtractEmission(chunk, gathered, Ci);
    chunk.gather({Ci[0], Ci[1], Ci[2]});
}

} // namespace candela
