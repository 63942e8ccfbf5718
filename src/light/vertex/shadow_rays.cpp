// SPDX-License-Identifier: Apache-2.0
#include "light/vertex/shadow_rays.h"

#include "foundation/base/hot.h"
#include "foundation/base/lanes.h"

#include <algorithm>
#include <cmath>

namespace candela {

namespace {

/// The way from the shifted origin to the same end as L from P: the receiver's offset must not
/// carry the ray's end into the light.
CANDELA_HOT void towardsLight(int count, const ConstVec3Planes &P, const ConstVec3Planes &origin,
                              const ConstVec3Planes &L, const float *__restrict distance,
                              const MutableVec3Planes &direction, float *__restrict end) {
    const float *__restrict px = P[0], *__restrict py = P[1], *__restrict pz = P[2];
    const float *__restrict ox = origin[0], *__restrict oy = origin[1], *__restrict oz = origin[2];
    const float *__restrict lx = L[0], *__restrict ly = L[1], *__restrict lz = L[2];
    float *__restrict dx = direction[0], *__restrict dy = direction[1];
    float *__restrict dz = direction[2];
#pragma GCC ivdep // Planes are apart; there are too many to compare.
    for (int i = 0; i < count; ++i) {
        const bool distant = distance[i] == INFINITY;
        dx[i] = distant ? lx[i] : lx[i] + (px[i] - ox[i]);
        dy[i] = distant ? ly[i] : ly[i] + (py[i] - oy[i]);
        dz[i] = distant ? lz[i] : lz[i] + (pz[i] - oz[i]);
        end[i] = shadowRayEndFor(distance[i]);
    }
}

} // namespace

ShadowRays::ShadowRays(int capacity)
    : rays_(capacity), origin_(3, capacity), direction_(3, capacity), end_(1, capacity),
      factor_(1, capacity), transmittance_(colorSamples, capacity), around_(2, capacity),
      atmosphere_(1, capacity) {}

int ShadowRays::attenuate(SurfaceVertices &vertices, const LightSamples &samples, int count,
                          const int *lanes, float *const *light) {
    const int all = vertices.count();
    const ConstVec3Planes L{samples.L[0], samples.L[1], samples.L[2]};
    const MutableVec3Planes origin{origin_[0], origin_[1], origin_[2]};
    vertices.rayOrigins(L, origin);
    towardsLight(all, vertices.litPoints(), {origin[0], origin[1], origin[2]}, L, samples.distance,
                 {direction_[0], direction_[1], direction_[2]}, end_[0]);
    take(count, lanes, vertices.points.input(int(ShaderInput::time)));
    const Scene &scene = vertices.scene();
    const bool inMedia = scene.hasVolumes() && !scene.isClassic();
    for (int ray = 0; inMedia && ray < count; ++ray) {
        const int i = lanes[ray];
        enter(ray, vertices.mediaAlong(i, L), scene, samples, i, vertices.mediaOf(i).atmosphere);
    }
    multiply(scene, all, count, lanes, inMedia, light);
    return count;
}

int ShadowRays::attenuate(const FreePoints &points, const LightSamples &samples, int count,
                          const int *lanes, float *const *light) {
    const int all = points.count;
    for (int c = 0; c < 3; ++c)
        std::copy_n(points.P[c], all, origin_[c]);
    towardsLight(all, points.P, points.P, {samples.L[0], samples.L[1], samples.L[2]},
                 samples.distance, {direction_[0], direction_[1], direction_[2]}, end_[0]);
    take(count, lanes, points.time);
    const bool inMedia = !points.scene.isClassic();
    for (int ray = 0; inMedia && ray < count; ++ray) {
        const int i = lanes[ray];
        enter(ray, {points.inner[i], points.outer[i]}, points.scene, samples, i,
              points.atmosphere[i]);
    }
    multiply(points.scene, all, count, lanes, inMedia, light);
    return count;
}

void ShadowRays::take(int count, const int *lanes, const float *time) {
    rays_.count = count; // tMin is 0 ever since it was made.
    lanes::take(count, lanes,
                {{origin_[0], rays_.origin[0]},
                 {origin_[1], rays_.origin[1]},
                 {origin_[2], rays_.origin[2]},
                 {direction_[0], rays_.direction[0]},
                 {direction_[1], rays_.direction[1]},
                 {direction_[2], rays_.direction[2]},
                 {end_[0], rays_.tMax},
                 {time, rays_.time}});
}

/// A lamp's own atmosphere counts, as where a ray meets it; of lights that no ray can meet, that of
/// what is lit.
void ShadowRays::enter(int ray, MediaAround around, const Scene &scene, const LightSamples &samples,
                       int i, std::int32_t atmosphere) {
    around_[0][ray] = around.inner(), around_[1][ray] = around.outer();
    atmosphere_[0][ray] =
        samples.pdfSolidAngle[i] > 0 ? scene.mediumOfLight(samples.light[i]) : atmosphere;
}

void ShadowRays::multiply(const Scene &scene, int all, int count, const int *lanes, bool inMedia,
                          float *const *light) {
    std::array<float *, colorSamples> transmittance;
    for (int c = 0; c < colorSamples; ++c)
        transmittance[c] = transmittance_[c];
    const ShadowMedia media{around_[0], around_[1], atmosphere_[0]};
    const bool colored =
        scene.transmittance(rays_, transmittance.data(), inMedia ? &media : nullptr);
    float *factor = factor_[0];
    lanes::fill(all, 1.0f, factor);
    for (int c = 0; c < colorSamples; ++c) {
        if (c == 0 || colored)
            for (int ray = 0; ray < count; ++ray)
                factor[lanes[ray]] = transmittance[c][ray];
        lanes::multiply(all, factor, light[c]);
    }
}

} // namespace candela
