// SPDX-License-Identifier: Apache-2.0
// Where the paths of a wave begin.
#include "foundation/base/lanes.h"
#include "light/transport/path_wave.h"
#include "light/transport/sobol.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace candela {

void PathWave::startCamera(int pixels, const int *x, const int *y, int first, int last) {
    const int samples = last - first;
    slots_ = pixels * samples;
    for (int pixel = 0; pixel < pixels; ++pixel) {
        const int slot = pixel * samples;
        std::fill_n(results_.x + slot, samples, x[pixel]);
        std::fill_n(results_.y + slot, samples, y[pixel]);
        std::fill_n(results_.keys[0] + slot, samples, pixelKey(x[pixel], y[pixel], settings_.seed));
        std::iota(results_.sampleIndex + slot, results_.sampleIndex + slot + samples, first);
    }
    for (int c = 0; c < colorSamples; ++c) {
        std::fill_n(results_.radiance[c], slots_, 0.0f);
        std::fill_n(results_.opacity[c], slots_, 0.0f);
        std::fill_n(active_.throughput[c], slots_, 1.0f);
    }
    for (int plane = 0; plane < results_.channels.planes(); ++plane)
        std::fill_n(results_.channels[plane], slots_, firstHit_[plane].background);

    const Camera &camera = scene_.camera();
    std::array<float *, 2 * cameraPairs> numbers;
    for (int pair = 0; pair < cameraPairs; ++pair) {
        numbers[2 * pair] = cameraNumbers_[2 * pair];
        numbers[2 * pair + 1] = cameraNumbers_[2 * pair + 1];
        if (pair == filterPair || (pair == lensPair && camera.hasLens()) ||
            (pair == timePair && camera.hasShutterInterval()))
            sobolPairs(slots_, results_.keys[0],
                       reinterpret_cast<const std::uint32_t *>(results_.sampleIndex), pair,
                       numbers[2 * pair], numbers[2 * pair + 1]);
    }
    float *rasterX = numbers[2 * filterPair], *rasterY = numbers[2 * filterPair + 1];
    float *weight = results_.weight[0];
    for (int i = 0; i < slots_; ++i) {
        FilterSample at = filter_.sample(rasterX[i], rasterY[i]);
        rasterX[i] = float(results_.x[i]) + 0.5f + at.dx;
        rasterY[i] = float(results_.y[i]) + 0.5f + at.dy;
        weight[i] = at.weight;
    }
    camera.rays(slots_, rasterX, rasterY, numbers[2 * lensPair], numbers[2 * lensPair + 1],
                numbers[2 * timePair], active_.rays);
    active_.rays.count = active_.count = slots_;
    std::fill_n(active_.lastPdf, slots_, 0.0f);
    std::fill_n(active_.travelled, slots_, 0.0f);
    std::iota(active_.slot, active_.slot + slots_, 0);
    std::fill_n(active_.depth, slots_, 0);
    std::fill_n(active_.lightSet, slots_, -1);
    std::fill_n(active_.seen, slots_, 1);
    statistics_.paths += slots_;
    statistics_.cameraRays += slots_;
}

void PathWave::startGathering(int count, const int *lane, const GatheringRays &from) {
    slots_ = active_.count = active_.rays.count = count;
    auto take = [&](const float *plane, float *to) { lanes::gather(count, lane, plane, to); };
    auto takeInts = [&](const int *plane, int *to) { lanes::gather(count, lane, plane, to); };
    for (int c = 0; c < colorSamples; ++c) {
        std::fill_n(results_.radiance[c], count, 0.0f);
        std::fill_n(active_.throughput[c], count, 1.0f);
    }
    takeInts(from.x, results_.x), takeInts(from.y, results_.y);
    takeInts(reinterpret_cast<const int *>(from.sampleIndex), results_.sampleIndex);
    takeInts(reinterpret_cast<const int *>(from.pixelKey),
             reinterpret_cast<int *>(results_.keys[0]));

    RayBatch &rays = active_.rays;
    take(from.origin[0], rays.origin[0]), take(from.origin[1], rays.origin[1]);
    take(from.origin[2], rays.origin[2]);
    take(from.direction[0], rays.direction[0]);
    take(from.direction[1], rays.direction[1]);
    take(from.direction[2], rays.direction[2]);
    take(from.time, rays.time);
    std::fill_n(rays.tMax, count, INFINITY);
    for (float *plane : {rays.tMin, rays.width, rays.spread})
        std::fill_n(plane, count, 0.0f);

    take(from.pdf, active_.lastPdf);
    takeInts(from.lightSet, active_.lightSet);
    takeInts(from.depth, active_.depth);
    std::fill_n(active_.travelled, count, 0.0f);
    std::fill_n(active_.seen, count, 0);
    for (int i = 0; i < count; ++i) {
        active_.slot[i] = i;
        ++active_.depth[i];
    }
    statistics_.bounceRays += count;
}

} // namespace candela
