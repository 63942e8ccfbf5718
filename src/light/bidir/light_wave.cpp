// SPDX-License-Identifier: Apache-2.0
#include "light/bidir/light_wave.h"

#include "foundation/base/lanes.h"
#include "light/path/stages.h"
#include "light/path/steps.h"
#include "light/sampling/sobol.h"
#include "light/vertex/vectors.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace candela {

namespace {

constexpr Stage lightStages[] = {meet,    arrive, crossAgainstLight, askAgainstLight,
                                 receive, keep,   showToCamera,      scatterLight};
/// Shaders that are not affine in the light take none from paths that begin on lights.
constexpr Stage passingStages[] = {meet, arrive, crossAgainstLight, askAgainstLight, scatterLight};

/// The dimension pairs of a start; those of vertices come behind, as in camera paths.
enum StartPair { placePair, wayPair, choicePair };

/// Paths are addressed as if each 2^16 of them were the samples of a pixel beyond the frame.
constexpr int pathsOfKey = 1 << 16;

/// Directions that differ by no more (radians) are the same but for rounding.
constexpr float mostTurn = 1e-2f;

} // namespace

LightWave::LightWave(FrameContext &frame, const TechniqueCounts &counts, SampleSink &sink)
    : PathWave(frame, Purpose::Light, stagesOfLight, counts), sink(sink), starts(capacity),
      brightness(1, capacity), image(VertexChunk::capacity), tilted(VertexChunk::capacity),
      arrival(VertexChunk::capacity), pixels(frame.filter.record()) {}

LightArrival::LightArrival(int capacity)
    : floats(8, capacity), integers(4, capacity), given(capacity) {
    place = {floats[0], floats[1], floats[2]};
    choice = floats[3], u = floats[4], v = floats[5], pdf = floats[6], scattered = floats[7];
    light = integers[0], source = integers[1], element = integers[2];
    withoutExtent = integers[3];
}

std::span<const Stage> stagesOfLight(const PathWave &, const ShaderCode &code) {
    return code.facts().affine ? std::span<const Stage>(lightStages) : passingStages;
}

void startLight(LightWave &wave, std::int64_t first, int count) {
    wave.slots = count;
    wave.kept.clear();
    wave.image.x.clear(), wave.image.y.clear();
    for (std::vector<float> &plane : wave.image.splats)
        plane.clear();
    PathResults &results = wave.results;
    for (int i = 0; i < count; ++i) {
        const std::int64_t number = first + i;
        results.x[i] = results.y[i] = -1;
        results.sampleIndex[i] = int(number % pathsOfKey);
        results.keys[0][i] = pixelKey(-2 - int(number / pathsOfKey), -2, wave.frame.settings.seed);
    }
    for (int c = 0; c < colorSamples; ++c)
        std::fill_n(results.radiance[c], count, 0.0f);
    const std::uint32_t *sample = reinterpret_cast<const std::uint32_t *>(results.sampleIndex);
    Planes<float> &numbers = wave.cameraNumbers;
    static_assert(int(choicePair) < int(cameraPairs));
    for (int pair : {placePair, wayPair, choicePair})
        sobolPairs(count, results.keys[0], sample, std::uint32_t(pair), numbers[2 * pair],
                   numbers[2 * pair + 1]);
    wave.frame.scene.lights().start(count,
                                    {numbers[2 * choicePair],
                                     {numbers[2 * placePair], numbers[2 * placePair + 1]},
                                     {numbers[2 * wayPair], numbers[2 * wayPair + 1]}},
                                    wave.frame.guide, wave.starts);

    ActivePaths &active = wave.active;
    float *pdf = numbers[2 * choicePair]; // Of the directions; its numbers have been taken.
    int paths = 0;
    for (int i = 0; i < count; ++i) {
        const LightStarts &from = wave.starts;
        if (from.light[i] == 0 || !(from.directionPdf[i] > 0) ||
            (from.flux[0][i] == 0 && from.flux[1][i] == 0 && from.flux[2][i] == 0))
            continue;
        const int at = paths++;
        const Vec3 direction{from.direction[0][i], from.direction[1][i], from.direction[2][i]};
        const Vec3 normal{from.normal[0][i], from.normal[1][i], from.normal[2][i]};
        for (int c = 0; c < 3; ++c) {
            active.rays.origin[c][at] = from.origin[c][i];
            active.rays.direction[c][at] = direction[c];
            active.left.N[c][at] = 0;
        }
        active.rays.tMin[at] = 0, active.rays.tMax[at] = INFINITY;
        active.rays.time[at] = wave.frame.scene.camera().shutterOpen();
        active.rays.width[at] = 0;
        active.left.pdf[at] = 0, active.left.lightSet[at] = -1, active.left.code[at] = -1;
        for (int c = 0; c < colorSamples; ++c)
            active.throughput[c][at] = from.flux[c][i];
        active.slot[at] = i, active.depth[at] = 0, active.seen[at] = 0;
        active.sampleIndex[at] = sample[i];
        pdf[at] = from.directionPdf[i];
        active.history[at] = edgeOfLight({from.positionPdf[i], from.directionPdf[i],
                                          wave.frame.scene.lights().isDistant(from.light[i]),
                                          std::fabs(dot(direction, normal)), from.skyPdf[i]});
    }
    active.count = active.rays.count = paths;
    active.rays.shares = nullptr;
    if (wave.frame.scene.hasVolumes())
        enterMedia(wave);
    spreadOfDirections(paths, pdf, active.rays.spread);
    wave.chunk.vertices.speak(false);
    wave.frame.statistics.lightPaths += count;
}

namespace {

/// Of the vertices that light meets first, its light and place; false if there are none.
bool findLights(LightWave &wave) {
    const VertexChunk &chunk = wave.chunk;
    LightArrival &arrival = wave.arrival;
    const LightStarts &starts = wave.starts;
    const bool alike = chunk.vertices.code().categories().hearsAllAsIndirect();
    bool some = false;
    for (int i = 0; i < chunk.count(); ++i) {
        const int slot = chunk.paths.slot[i];
        const bool isFirst = chunk.paths.depth[i] == 0;
        arrival.light[i] = isFirst ? starts.light[slot] : 0;
        arrival.source[i] = isFirst ? starts.source[slot] : -1;
        arrival.element[i] = isFirst ? starts.element[slot] : -1;
        arrival.withoutExtent[i] = isFirst && starts.element[slot] < 0 ? starts.light[slot] : 0;
        arrival.choice[i] = 0;
        arrival.u[i] = starts.lightSample[0][slot], arrival.v[i] = starts.lightSample[1][slot];
        put(arrival.place, i, at(constant(starts.origin), slot));
        arrival.scattered[i] = alike && chunk.mixture.total()[i] > 0 ? 1.0f : 0.0f;
        some |= isFirst;
    }
    return some;
}

/// What the light of vertex i, which has no extent, is worth there over what the path carries; none
/// if its shader lights the point from elsewhere, which is left to light samples.
std::array<float, colorSamples> worthOfGiven(LightWave &wave, int i) {
    const LightSamples &given = wave.arrival.given.samples;
    const Vec3 L{given.L[0][i], given.L[1][i], given.L[2][i]};
    const Vec3 apart = normalize(L) - at(constant(wave.subpaths->toPrevious), i);
    std::array<float, colorSamples> worth{};
    if (given.light[i] == 0 || !(dot(apart, apart) < mostTurn * mostTurn))
        return worth;
    const double distance = wave.hits.t[wave.chunk.rays[i]];
    const bool isDistant = wave.frame.scene.lights().isDistant(wave.arrival.light[i]);
    const double pdf = given.pdfSolidAngle[i]; // Of a sky: what is given is radiance.
    const double unit = pdf > 0 ? 1 / pdf : std::numbers::pi;
    for (int c = 0; c < colorSamples; ++c)
        worth[c] = float(unit * (isDistant ? 1 : square(distance)) * given.value[c][i]);
    return worth;
}

} // namespace

void receive(PathWave &path) {
    LightWave &wave = static_cast<LightWave &>(path); // Stages of light serve light waves alone.
    if (!findLights(wave))
        return;
    VertexChunk &chunk = wave.chunk;
    LightArrival &arrival = wave.arrival;
    Subpaths &ends = *wave.subpaths;
    const Lights lights = wave.frame.scene.lights();
    const LightQuery query = lightQuery(chunk.vertices, chunk.N, arrival.scattered,
                                        {arrival.choice, arrival.u, arrival.v});
    lights.densityOf(query, arrival.source, arrival.element, constant(arrival.place), arrival.pdf);
    if (!lanes::allEqual(chunk.count(), arrival.withoutExtent, 0))
        lights.sampleGiven(arrival.withoutExtent, query, arrival.given.samples);
    for (int i = 0; i < chunk.count(); ++i) {
        if (arrival.light[i] == 0)
            continue;
        const bool hasExtent = arrival.withoutExtent[i] == 0;
        ends.vertices[i].last = lastOfLit(ends.vertices[i], arrival.pdf[i], hasExtent);
        std::array<float, colorSamples> worth{1, 1, 1};
        if (!hasExtent)
            worth = worthOfGiven(wave, i);
        if (!lights.isOn(chunk.vertices.points.lightSet[i], arrival.light[i]))
            worth = {};
        float brightest = 0;
        for (int c = 0; c < colorSamples; ++c) {
            float &flux = chunk.paths.throughput[c][i];
            flux = worth[c] != 0 ? flux * worth[c] : 0.0f;
            brightest = std::max(brightest, std::fabs(flux));
        }
        wave.brightness[0][chunk.paths.slot[i]] = brightest;
    }
}

void keep(PathWave &path) {
    LightWave &wave = static_cast<LightWave &>(path);
    VertexChunk &chunk = wave.chunk;
    const Subpaths &ends = *wave.subpaths;
    const bool merges = ends.counts.merging > 0;
    if (!wave.keeps || !(merges || ends.counts.connections > 0) ||
        !chunk.vertices.code().facts().hasLoops)
        return;
    /// Where a camera path takes over, it scatters at the vertex itself, or at its own before.
    const int scatterings = merges ? 1 : 2;
    const ConstVec3Planes P = chunk.vertices.P(), Ng = chunk.vertices.input(ShaderInput::Ng);
    const float *time = chunk.vertices.points.input(int(ShaderInput::time));
    for (int i = 0; i < chunk.count(); ++i) {
        LightVertex vertex;
        bool bright = false, sound = true;
        for (int c = 0; c < colorSamples; ++c) {
            vertex.flux[c] = chunk.paths.throughput[c][i];
            bright |= vertex.flux[c] != 0, sound &= bool(std::isfinite(vertex.flux[c]));
        }
        if (!bright || !sound || chunk.paths.depth[i] + scatterings > wave.frame.settings.maxDepth)
            continue;
        const int ray = chunk.rays[i];
        const HitBatch &hits = wave.hits;
        vertex.shape = hits.shape[ray], vertex.element = hits.element[ray];
        vertex.instance = hits.instance[ray], vertex.u = hits.u[ray], vertex.v = hits.v[ray];
        vertex.elementNormal = {hits.Ng[0][ray], hits.Ng[1][ray], hits.Ng[2][ray]};
        vertex.P = at(P, i), vertex.Ng = at(Ng, i);
        vertex.toPrevious = at(constant(ends.toPrevious), i);
        vertex.distance = hits.t[ray];
        vertex.time = time[i];
        vertex.width = wave.active.rays.width[ray] + wave.active.rays.spread[ray] * hits.t[ray];
        vertex.ofPath = ends.vertices[i];
        vertex.depth = chunk.paths.depth[i];
        vertex.light = wave.arrival.light[i];
        vertex.code = chunk.code;
        wave.kept.push_back(vertex);
    }
}

} // namespace candela
