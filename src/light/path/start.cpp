// SPDX-License-Identifier: Apache-2.0
// Where the paths of a wave begin.
#include "foundation/base/lanes.h"
#include "light/path/stages.h"
#include "light/path/steps.h"
#include "light/sampling/sobol.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace candela {

namespace {

/// Slots for every `step`th sample of a pixel.
void takeSlots(PathWave &wave, int x, int y, int first, int last, int step) {
    PathResults &results = wave.results;
    const int slot = wave.slots, samples = (last - first + step - 1) / step;
    std::fill_n(results.x + slot, samples, x);
    std::fill_n(results.y + slot, samples, y);
    std::fill_n(results.keys[0] + slot, samples, pixelKey(x, y, wave.frame.settings.seed));
    for (int i = 0; i < samples; ++i)
        results.sampleIndex[slot + i] = first + i * step;
    wave.slots += samples;
}

/// Slots for all samples, with nothing gathered.
void takeSlots(PathWave &wave, const CameraSamples &camera) {
    PathResults &results = wave.results;
    wave.slots = 0;
    for (int i = 0; i < camera.pixels; ++i) {
        const Halves halves = camera.halves ? camera.halves[i] : Halves::Both;
        takeSlots(wave, camera.x[i], camera.y[i], camera.first + (halves == Halves::Odd),
                  camera.last, halves == Halves::Both ? 1 : 2);
    }
    if (camera.halves)
        for (int i = 0; i < wave.slots; ++i)
            if (results.sampleIndex[i] % 2 != 0)
                results.keys[0][i] = keyOfOddHalf(results.keys[0][i]);
    for (int c = 0; c < colorSamples; ++c) {
        std::fill_n(results.radiance[c], wave.slots, 0.0f);
        std::fill_n(results.opacity[c], wave.slots, 0.0f);
    }
    for (int plane = 0; plane < results.channels.planes(); ++plane)
        std::fill_n(results.channels[plane], wave.slots, wave.frame.firstHit[plane].background);
}

/// Active paths without a history, one for each slot. Of halves an even and an odd sample share a
/// number.
void takePaths(PathWave &wave, bool areHalves) {
    ActivePaths &active = wave.active;
    active.rays.count = active.count = wave.slots;
    active.rays.shares = nullptr;
    for (int c = 0; c < colorSamples; ++c)
        lanes::fill(wave.slots, 1.0f, active.throughput[c]);
    std::fill_n(active.left.pdf, wave.slots, 0.0f);
    for (int c = 0; c < 3; ++c)
        std::fill_n(active.left.N[c], wave.slots, 0.0f);
    std::fill_n(active.left.lightSet, wave.slots, -1);
    std::fill_n(active.left.code, wave.slots, -1);
    std::iota(active.slot, active.slot + wave.slots, 0);
    std::fill_n(active.depth, wave.slots, 0);
    lanes::fill(wave.slots, 1, active.seen);
    for (int i = 0; i < wave.slots; ++i)
        active.sampleIndex[i] = std::uint32_t(wave.results.sampleIndex[i]) >> int(areHalves);
    if (wave.frame.scene.hasVolumes())
        beginMedia(wave.slots, active.media);
}

/// Each of a pixel's samples stands for a share of it: what they show is averaged, and what they
/// look up need not be blurred once more. The share depends on the pass, not on passes to come.
void shareFootprints(int samples, RayBatch &rays) {
    const float share = 1 / std::sqrt(float(std::max(1, samples)));
    for (int i = 0; i < rays.count; ++i)
        rays.width[i] *= share, rays.spread[i] *= share;
}

} // namespace

void startCamera(PathWave &wave, const CameraSamples &samples) {
    const bool areHalves = samples.halves != nullptr;
    takeSlots(wave, samples);
    takePaths(wave, areHalves);
    const int ofSequence = samples.last >> int(areHalves);
    const Camera &camera = wave.frame.scene.camera();
    PathResults &results = wave.results;
    std::array<float *, 2 * cameraPairs> numbers;
    for (int pair = 0; pair < cameraPairs; ++pair) {
        numbers[2 * pair] = wave.cameraNumbers[2 * pair];
        numbers[2 * pair + 1] = wave.cameraNumbers[2 * pair + 1];
        if (pair == filterPair || (pair == lensPair && camera.hasLens()) ||
            (pair == timePair && camera.hasShutterInterval()))
            sobolPairs(wave.slots, results.keys[0], wave.active.sampleIndex, pair,
                       numbers[2 * pair], numbers[2 * pair + 1]);
    }
    float *rasterX = numbers[2 * filterPair], *rasterY = numbers[2 * filterPair + 1];
    float *weight = results.weight[0];
    const bool shares = wave.frame.scene.readsFootprints();
    if (shares)
        wave.shares.prepare(wave.frame.filter, ofSequence);
    for (int i = 0; i < wave.slots; ++i) {
        FilterSample at = wave.frame.filter.sample(rasterX[i], rasterY[i]);
        if (shares && wave.shares.areKnown())
            wave.shares.set(i, rasterX[i], rasterY[i], at.dx, at.dy);
        rasterX[i] = float(results.x[i]) + 0.5f + at.dx;
        rasterY[i] = float(results.y[i]) + 0.5f + at.dy;
        weight[i] = at.weight;
    }
    camera.rays(wave.slots, rasterX, rasterY, numbers[2 * lensPair], numbers[2 * lensPair + 1],
                numbers[2 * timePair], wave.active.rays);
    wave.active.rays.count = wave.slots;
    shareFootprints(ofSequence, wave.active.rays);
    wave.active.rays.shares = shares ? wave.shares.shares() : nullptr;
    if (wave.subpaths)
        beginHistory(wave);
    wave.frame.statistics.paths += wave.slots;
    wave.frame.statistics.cameraRays += wave.slots;
}

void startGathering(PathWave &wave, int count, const int *lane, const GatheringRays &from) {
    wave.slots = count;
    PathResults &results = wave.results;
    for (int c = 0; c < colorSamples; ++c)
        std::fill_n(results.radiance[c], count, 0.0f);
    lanes::take(count, lane,
                {{from.x, results.x},
                 {from.y, results.y},
                 {reinterpret_cast<const int *>(from.sampleIndex), results.sampleIndex},
                 {from.pixelKey, results.keys[0]}});
    takePaths(wave, false);

    ActivePaths &active = wave.active;
    RayBatch &rays = active.rays;
    RayOrigins &left = active.left;
    lanes::take(count, lane,
                {{from.origin[0], rays.origin[0]},
                 {from.origin[1], rays.origin[1]},
                 {from.origin[2], rays.origin[2]},
                 {from.direction[0], rays.direction[0]},
                 {from.direction[1], rays.direction[1]},
                 {from.direction[2], rays.direction[2]},
                 {from.N[0], left.N[0]},
                 {from.N[1], left.N[1]},
                 {from.N[2], left.N[2]},
                 {from.time, rays.time},
                 {from.width, rays.width},
                 {from.spread, rays.spread},
                 {from.pdf, left.pdf},
                 {from.lightSet, left.lightSet},
                 {from.depth, active.depth}});
    if (from.around)
        for (int word = 0; word < 2; ++word)
            lanes::take(count, lane, {{(*from.around)[word], active.media.around[word]}});
    std::fill_n(rays.tMin, count, 0.0f);
    lanes::fill(count, INFINITY, rays.tMax);
    lanes::fill(count, from.code, left.code);
    std::fill_n(active.seen, count, 0);
    for (int i = 0; i < count; ++i)
        ++active.depth[i];
    if (wave.subpaths)
        beginHistoryAtPoints(wave);
    wave.frame.statistics.bounceRays += count;
}

} // namespace candela
