// SPDX-License-Identifier: Apache-2.0
#include "foundation/base/hot.h"
#include "foundation/base/lanes.h"
#include "light/path/roulette.h"
#include "light/path/solution_light.h"
#include "light/path/split.h"
#include "light/path/stages.h"
#include "light/path/steps.h"

#include <algorithm>
#include <cmath>

namespace candela {

namespace {

constexpr float pi = float(M_PI);

/// What the events make of a unit of light: 1/(pi pdf) for finite lobes, else 1; and the density
/// that the direction carries, 0 for events without a choice of direction. Several `directions` are
/// as many times as dense.
CANDELA_HOT void eventScales(int count, const std::int32_t *__restrict event,
                             const float *__restrict mixturePdf, float directions,
                             const int *__restrict depth, int maxDepth, float *__restrict scale,
                             float *__restrict pdf) {
    for (int i = 0; i < count; ++i) {
        const float drawn = mixturePdf[i] * directions;
        const bool finite = event[i] == finiteRequests, through = event[i] == straightThrough;
        const bool goesOn = (event[i] != pathEnds) & (through | (depth[i] < maxDepth));
        const float density = drawn > 0 ? drawn : 0.0f;
        const float worth = 1 / (pi * (drawn > 0 ? drawn : 1.0f)), some = drawn > 0 ? worth : 0.0f;
        pdf[i] = finite ? density : 0.0f;
        scale[i] = goesOn ? (finite ? some : 1.0f) : 0.0f;
    }
}

/// The throughput after the event in all channels, and the largest of them (NaN stays).
CANDELA_HOT void nextThroughput(int count, const std::array<const float *, colorSamples> &from,
                                const std::array<const float *, colorSamples> &response,
                                const std::array<const float *, colorSamples> &opacity,
                                const std::int32_t *__restrict event, const float *__restrict scale,
                                const std::array<float *, colorSamples> &to,
                                float *__restrict brightest) {
    static_assert(colorSamples == 3);
    const float *__restrict f0 = from[0], *__restrict f1 = from[1], *__restrict f2 = from[2];
    const float *__restrict g0 = response[0], *__restrict g1 = response[1];
    const float *__restrict g2 = response[2];
    const float *__restrict o0 = opacity[0], *__restrict o1 = opacity[1];
    const float *__restrict o2 = opacity[2];
    float *__restrict t0 = to[0], *__restrict t1 = to[1], *__restrict t2 = to[2];
#pragma GCC ivdep // Planes are apart; there are too many to compare.
    for (int i = 0; i < count; ++i) {
        bool through = event[i] == straightThrough, goesOn = scale[i] > 0;
        float red = goesOn ? f0[i] * (through ? 1 - o0[i] : g0[i]) * scale[i] : 0.0f;
        float green = goesOn ? f1[i] * (through ? 1 - o1[i] : g1[i]) * scale[i] : 0.0f;
        float blue = goesOn ? f2[i] * (through ? 1 - o2[i] : g2[i]) * scale[i] : 0.0f;
        float largest = std::fabs(red);
        largest = !(std::fabs(green) <= largest) ? std::fabs(green) : largest;
        largest = !(std::fabs(blue) <= largest) ? std::fabs(blue) : largest;
        t0[i] = red, t1[i] = green, t2[i] = blue;
        brightest[i] = largest;
    }
}

/// Directions of finite lobes, and their density.
ConstVec3Planes sampleDirections(VertexChunk &chunk) {
    const Planes<float> &sampled = chunk.way.sampled;
    chunk.mixture.sample(chunk.numbers.x(directionPair), chunk.numbers.y(directionPair),
                         {sampled[0], sampled[1], sampled[2]});
    const ConstVec3Planes direction{sampled[0], sampled[1], sampled[2]};
    chunk.mixture.pdf(direction, chunk.way.mixturePdf);
    return direction;
}

/// way.throughput and way.brightest, 0 for those that end.
void respond(PathWave &wave, const ConstVec3Planes &direction) {
    VertexChunk &chunk = wave.chunk;
    ScatterPlanes &way = chunk.way;
    SurfaceVertices &vertices = chunk.vertices;
    const int count = chunk.count();
    float *g[colorSamples];
    for (int c = 0; c < colorSamples; ++c)
        g[c] = way.response[c];
    vertices.scatter(direction, chunk.events.event(), nullptr, g);
    eventScales(count, chunk.events.event(), way.mixturePdf, float(directionsAt(wave)),
                chunk.paths.depth, wave.frame.settings.maxDepth, way.scale, way.pdf);
    const Planes<float> &before = chunk.paths.throughput, &after = way.throughput;
    nextThroughput(
        count, {before[0], before[1], before[2]}, {g[0], g[1], g[2]},
        {vertices.prepared().Oi[0], vertices.prepared().Oi[1], vertices.prepared().Oi[2]},
        chunk.events.event(), way.scale, {after[0], after[1], after[2]}, way.brightest);
    if (wave.frame.scene.hasVolumes() && !chunk.events.finite())
        weighOpacityBehind(wave);
    if (wave.frame.scene.hasMatte()) // They pass on what is behind, and nothing else.
        for (int i = 0; i < count; ++i)
            if (chunk.paths.heldOut[i] && chunk.events.event()[i] != straightThrough)
                way.brightest[i] = 0;
    if (lanes::allFinite(count, way.brightest))
        return;
    for (int i = 0; i < count; ++i)
        if (!std::isfinite(way.brightest[i])) {
            reportNonFinite(wave, i, vertices.code().name());
            way.brightest[i] = 0;
        }
}

/// Another uniform number for the next kind of event.
CANDELA_HOT void turnNumbers(int count, float *__restrict numbers) {
    constexpr float goldenSection = 0.618034f;
    for (int i = 0; i < count; ++i) {
        const float turned = numbers[i] + goldenSection;
        numbers[i] = turned < 1 ? turned : turned - 1;
    }
}

/// The paths go on along chunk.events, of these directions.
void goOn(PathWave &wave, const ConstVec3Planes &direction, RouletteThresholds thresholds) {
    VertexChunk &chunk = wave.chunk;
    ScatterPlanes &way = chunk.way;
    respond(wave, direction);
    if (wave.subpaths)
        lookBack(wave, direction);
    playRoulette(chunk.count(), way.brightest, chunk.paths.depth, thresholds,
                 chunk.numbers.roulette(), way.survives, way.gain);
    if (wave.vertex >= thresholds.splittingVertices && chunk.events.kinds() > 0)
        shareOnePath(chunk.count(), chunk.events.share(), chunk.numbers.roulette(), way.survives,
                     way.gain);
    const int count = lanes::compactUnequal(chunk.count(), way.survives, 0, way.lane);
    append(wave, direction, count);
}

CANDELA_HOT void numberDirections(int count, const std::uint32_t *__restrict sample, int k,
                                  std::uint32_t *__restrict number) {
    for (int i = 0; i < count; ++i)
        number[i] = directionNumber(sample[i], k);
}

/// The paths go on along directions of the finite lobes.
void followDirections(PathWave &wave, RouletteThresholds thresholds) {
    VertexChunk &chunk = wave.chunk;
    if (!chunk.events.takeFinite(chunk.count(), followedTotal(wave)))
        return;
    const int directions = directionsAt(wave);
    for (int k = 0; k < directions; ++k) {
        if (directions > 1) {
            numberDirections(chunk.count(), chunk.way.sample[0], k, chunk.paths.sampleIndex);
            drawNumbers(wave, directionPair);
        }
        goOn(wave, sampleDirections(chunk), thresholds);
    }
}

/// Of camera paths the directions carry shares; it is the path whose weight counts.
RouletteThresholds thresholdsOf(const PathWave &wave) {
    const float below =
        wave.purpose == Purpose::Camera ? rouletteBelow / cameraDirections : rouletteBelow;
    return {below, wave.chunk.events.kinds() > 0 ? below * firstRouletteShare : 0};
}

} // namespace

CANDELA_HOT void playRoulette(int count, const float *__restrict brightest,
                              const int *__restrict depth, RouletteThresholds thresholds,
                              const float *__restrict chance, int *__restrict survives,
                              float *__restrict gain) {
    const float perLater = 1 / thresholds.later, perFirst = 1 / thresholds.first;
    for (int i = 0; i < count; ++i) {
        const float per = depth[i] + 1 >= rouletteDepth ? perLater : perFirst;
        const float root = std::sqrt((brightest[i] > 0 ? brightest[i] : 0.0f) * per);
        const float odds = root < 1 ? root : 1.0f; // Also where nobody plays: below 0.
        survives[i] = (brightest[i] > 0) & (chance[i] < odds);
        gain[i] = 1 / (odds > 0 ? odds : 1.0f);
    }
}

void shareOnePath(int count, const float *share, const float *chance, int *survives, float *gain) {
    for (int i = 0; i < count; ++i) {
        const float odds = share[i] / gain[i];
        survives[i] &= chance[i] < odds;
        gain[i] = 1 / (odds > 0 ? odds : 1.0f);
    }
}

void beginEvents(PathWave &wave, const float *finiteTotal) {
    VertexChunk &chunk = wave.chunk;
    std::copy_n(chunk.paths.sampleIndex, chunk.count(), chunk.way.sample[0]);
    if (chunk.events.kinds() == 0)
        return;
    chunk.events.weigh(chunk.vertices, finiteTotal);
    if (!drawsLightChoice(wave))
        drawNumbers(wave, lightChoicePair);
}

void numberKind(PathWave &wave, int kind) {
    VertexChunk &chunk = wave.chunk;
    for (int i = 0; i < chunk.count(); ++i)
        chunk.paths.sampleIndex[i] = eventNumber(chunk.way.sample[0][i], wave.vertex, kind);
    turnNumbers(chunk.count(), chunk.numbers.roulette());
}

void followEvents(PathWave &wave, RouletteThresholds thresholds) {
    VertexChunk &chunk = wave.chunk;
    ScatteringEvents &events = chunk.events;
    for (int kind = 0; kind < events.kinds(); ++kind) {
        if (!events.takeKind(chunk.vertices, kind))
            continue;
        numberKind(wave, kind);
        const MutableVec3Planes direction = events.direction();
        goOn(wave, {direction[0], direction[1], direction[2]}, thresholds);
    }
}

void scatter(PathWave &wave) {
    beginEvents(wave, followedTotal(wave));
    const RouletteThresholds thresholds = thresholdsOf(wave);
    followDirections(wave, thresholds);
    followEvents(wave, thresholds);
}

void scatterBesidesFiniteLobes(PathWave &wave) {
    beginEvents(wave, nullptr);
    followEvents(wave, thresholdsOf(wave));
}

} // namespace candela
