// SPDX-License-Identifier: Apache-2.0
#include "light/vertex/shadow_rays.h"

#include "foundation/base/hot.h"
#include "foundation/base/lanes.h"

#include <algorithm>
#include <cmath>

namespace candela {

namespace {

/// A component of the way from the shifted origin to the same end as L from P: the receiver's
/// offset must not carry the ray's end into the light. Distant light is away from everywhere.
CANDELA_HOT void towardsLight(int count, const float *__restrict P, const float *__restrict origin,
                              const float *__restrict L, const float *__restrict distance,
                              float *__restrict direction, float *__restrict end) {
    for (int i = 0; i < count; ++i) {
        bool distant = distance[i] == INFINITY;
        direction[i] = distant ? L[i] : L[i] + (P[i] - origin[i]);
        end[i] = distant ? INFINITY : shadowRayEnd;
    }
}

} // namespace

ShadowRays::ShadowRays(int capacity)
    : rays_(capacity), origin_(3, capacity), direction_(1, capacity), end_(1, capacity),
      factor_(1, capacity), transmittance_(colorSamples, capacity) {}

int ShadowRays::attenuate(SurfaceVertices &vertices, const LightSamples &samples, int count,
                          const int *lanes, float *const *light) {
    const int all = vertices.count();
    ConstVec3Planes L{samples.L[0], samples.L[1], samples.L[2]}, P = vertices.P();
    MutableVec3Planes origin{origin_[0], origin_[1], origin_[2]};
    float *direction = direction_[0], *end = end_[0];
    vertices.rayOrigins(L, origin);
    rays_.count = count;
    float *origins[3] = {rays_.origin[0], rays_.origin[1], rays_.origin[2]};
    float *directions[3] = {rays_.direction[0], rays_.direction[1], rays_.direction[2]};
    for (int c = 0; c < 3; ++c) {
        towardsLight(all, P[c], origin[c], L[c], samples.distance, direction, end);
        lanes::take(count, lanes, origin[c], origins[c]);
        lanes::take(count, lanes, direction, directions[c]);
    }
    std::fill_n(rays_.tMin, count, 0.0f);
    lanes::take(count, lanes, end, rays_.tMax);
    lanes::take(count, lanes, vertices.points.input(int(ShaderInput::time)), rays_.time);

    std::array<float *, colorSamples> transmittance;
    for (int c = 0; c < colorSamples; ++c)
        transmittance[c] = transmittance_[c];
    const bool colored = vertices.scene().transmittance(rays_, transmittance.data());
    float *factor = factor_[0];
    std::fill_n(factor, all, 1.0f);
    for (int c = 0; c < colorSamples; ++c) {
        if (c == 0 || colored)
            for (int ray = 0; ray < count; ++ray)
                factor[lanes[ray]] = transmittance[c][ray];
        lanes::multiply(all, factor, light[c]);
    }
    return count;
}

} // namespace candela
