// SPDX-License-Identifier: Apache-2.0
// Where the paths of a wave begin.
#include "light/transport/lanes.h"
#include "light/transport/path_wave.h"
#include "light/transport/sobol.h"

#include <algorithm>
#include <cmath>

namespace candela {

void PathWave::startCamera(int pixels, const int *x, const int *y, int first, int last) {
    slots_ = 0;
    for (int pixel = 0; pixel < pixels; ++pixel) {
        std::uint32_t key = pixelKey(x[pixel], y[pixel], settings_.seed);
        for (int sample = first; sample < last; ++sample, ++slots_) {
            results_.x[slots_] = x[pixel], results_.y[slots_] = y[pixel];
            results_.sampleIndex[slots_] = sample;
            results_.keys[0][slots_] = key;
        }
    }
    for (int c = 0; c < colorSamples; ++c) {
        std::fill_n(results_.radiance[c], slots_, 0.0f);
        std::fill_n(results_.opacity[c], slots_, 0.0f);
    }
    for (int plane = 0; plane < results_.channels.planes(); ++plane)
        std::fill_n(results_.channels[plane], slots_, firstHit_[plane].background);

    Planes<float> numbers(8, slots_);
    const std::uint32_t *samples = reinterpret_cast<const std::uint32_t *>(results_.sampleIndex);
    for (int pair = 0; pair < cameraPairs; ++pair)
        sobolPairs(slots_, results_.keys[0], samples, pair, numbers[2 * pair],
                   numbers[2 * pair + 1]);
    float *rasterX = numbers[6], *rasterY = numbers[7];
    for (int i = 0; i < slots_; ++i) {
        FilterSample at = filter_.sample(numbers[0][i], numbers[1][i]);
        rasterX[i] = float(results_.x[i]) + 0.5f + at.dx;
        rasterY[i] = float(results_.y[i]) + 0.5f + at.dy;
        results_.weight[0][i] = at.weight;
    }
    scene_.camera().rays(slots_, rasterX, rasterY, numbers[2], numbers[3], numbers[4],
                         active_.rays);
    active_.rays.count = active_.count = slots_;
    for (int i = 0; i < slots_; ++i) {
        for (int c = 0; c < colorSamples; ++c)
            active_.throughput[c][i] = 1;
        active_.lastPdf[i] = active_.travelled[i] = 0;
        active_.slot[i] = i;
        active_.depth[i] = 0;
        active_.lightSet[i] = -1;
        active_.seen[i] = 1;
    }
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
    take(from.origin[0], rays.originX), take(from.origin[1], rays.originY);
    take(from.origin[2], rays.originZ);
    take(from.direction[0], rays.directionX);
    take(from.direction[1], rays.directionY);
    take(from.direction[2], rays.directionZ);
    take(from.time, rays.time);
    std::fill_n(static_cast<float *>(rays.tMax), count, INFINITY);

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
