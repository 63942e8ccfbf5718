// SPDX-License-Identifier: Apache-2.0
// For tests: points that ask for light, and rays that meet it.
#pragma once

#include "world/scene/test_world.h"

#include <algorithm>
#include <random>
#include <vector>

namespace candela {

/// n light samples, all from one point.
struct Samples {
    explicit Samples(int n) : floats(15, n), integers(2, n), shadow(1, n), values(colorSamples, n) {
        query.count = n;
        query.P = {floats[0], floats[1], floats[2]};
        query.Ps = query.P;
        query.N = {floats[14], floats[14], floats[14]}; // Light from all sides counts.
        query.lightSet = integers[0];
        query.time = floats[3];
        query.choice = floats[4];
        query.position = {floats[5], floats[6]};
        out.L = {floats[7], floats[8], floats[9]};
        out.distance = floats[10], out.pdfSolidAngle = floats[11];
        out.light = integers[1], out.castsShadow = shadow[0];
        for (int c = 0; c < colorSamples; ++c)
            out.value[c] = values[c];
    }
    void draw(unsigned seed, Vec3 P) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<float> uniform(0, 1);
        for (int i = 0; i < query.count; ++i) {
            for (int c = 0; c < 3; ++c)
                floats[c][i] = P[c];
            for (int plane = 4; plane <= 6; ++plane)
                floats[plane][i] = std::min(uniform(random), 0x1.fffffep-1f);
        }
    }
    Planes<float> floats;
    Planes<std::int32_t> integers;
    Planes<std::uint8_t> shadow;
    Planes<float> values;
    LightQuery query;
    LightSamples out;
};

/// The densities, from P, of the lights that rays from there have met.
inline std::vector<float> densities(const Scene &scene, const RayBatch &rays, const HitBatch &hits,
                                    const std::vector<int> &order, ShadingPoints &points) {
    const int count = int(order.size());
    Planes<float> met(3, count), zero(1, count), pdf(1, count), from(3, count);
    Planes<std::int32_t> sets(1, count);
    const std::array<float *, 3> point{met[0], met[1], met[2]};
    scene.shadingPoints(rays, hits, order.data(), count, points);
    scene.elementPoints(rays, hits, order.data(), count, point);
    LightQuery query;
    query.count = count;
    for (int c = 0; c < 3; ++c) {
        for (int k = 0; k < count; ++k)
            from[c][k] = rays.origin[c][order[k]];
        query.P[c] = from[c];
    }
    query.N = {zero[0], zero[0], zero[0]};
    query.lightSet = sets[0];
    scene.lights().density(query, points, {met[0], met[1], met[2]}, pdf[0]);
    return {pdf[0], pdf[0] + count};
}

} // namespace candela
