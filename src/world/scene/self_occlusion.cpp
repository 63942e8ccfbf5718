// SPDX-License-Identifier: Apache-2.0
#include "world/scene/self_occlusion.h"

#include <algorithm>
#include <optional>

namespace candela {

namespace {

/// Rays from the points towards their samples that something stands in the way of, compacted;
/// `lane` names their points.
struct Blocked {
    explicit Blocked(int capacity) : rays(capacity), hits(capacity), capacity(capacity) {}
    RayBatch rays;
    HitBatch hits;
    std::vector<int> lane;
    std::vector<std::uint8_t> stopped;
    int capacity;

    void begin(const LightQuery &query, const LightSamples &samples) {
        lane.clear();
        for (int i = 0; i < query.count; ++i) {
            if (samples.light[i] == 0)
                continue;
            const int k = int(lane.size());
            for (int c = 0; c < 3; ++c)
                rays.origin[c][k] = query.P[c][i], rays.direction[c][k] = samples.L[c][i];
            rays.tMin[k] = 0, rays.tMax[k] = 1 - 4 * 0x1p-23f;
            rays.time[k] = query.time[i];
            lane.push_back(i);
        }
        rays.count = int(lane.size());
        stopped.resize(lane.size());
    }
    /// Leaves those that `keep`.
    template <class Keep> void dropOthers(Keep keep) {
        int kept = 0;
        for (int k = 0; k < rays.count; ++k) {
            if (!keep(k))
                continue;
            for (int c = 0; c < 3; ++c)
                rays.origin[c][kept] = rays.origin[c][k],
                rays.direction[c][kept] = rays.direction[c][k];
            rays.tMin[kept] = rays.tMin[k], rays.tMax[kept] = rays.tMax[k];
            rays.time[kept] = rays.time[k];
            lane[kept++] = lane[k];
        }
        rays.count = kept;
    }
};

Blocked &blockedFor(int capacity) {
    thread_local std::optional<Blocked> own;
    if (!own || own->capacity < capacity)
        own.emplace(capacity);
    return *own;
}

void blacken(LightSamples &samples, int i) {
    samples.light[i] = 0, samples.pdfSolidAngle[i] = 0;
    for (float *value : samples.value)
        value[i] = 0;
}

} // namespace

void hideBehindItself(const SceneState &state, int index, const LightQuery &query,
                      LightSamples &samples) {
    const SceneLight &light = state.lights.lights[index];
    if (!light.finite() || light.castsShadow || !light.opaque || light.elements <= 1)
        return;
    Blocked &way = blockedFor(query.count);
    way.begin(query, samples);
    state.rays->occluded(way.rays, way.stopped.data());
    way.dropOthers([&](int k) { return way.stopped[k] == 1; });
    // Whatever else stands there is passed, a surface at a time.
    while (way.rays.count > 0) {
        state.rays->intersect(way.rays, way.hits, RayWorld::Which::All, false);
        way.dropOthers([&](int k) {
            if (way.hits.shape[k] == noHit)
                return false;
            const PointTables &points = state.points;
            const std::int32_t hit = points.appearanceOf(way.hits.instance[k], way.hits.shape[k]);
            if (points.appearances[hit].light == index + 1) {
                blacken(samples, way.lane[k]);
                return false;
            }
            way.rays.tMin[k] = passing(way.hits.t[k]);
            return true;
        });
    }
}

} // namespace candela
