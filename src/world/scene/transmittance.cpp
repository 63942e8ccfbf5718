// SPDX-License-Identifier: Apache-2.0
// What comes through along shadow rays. Opaque surfaces end the matter at once; transparent ones
// are walked through from front to back, all rays together, a surface each at a time.
#include "world/scene/scene.h"
#include "world/scene/scene_state.h"

#include <algorithm>
#include <optional>

namespace candela {

namespace {

/// A ray that has met this many transparent surfaces counts as stopped.
constexpr int layersAtMost = 4096;

/// The rays that are still under way, compacted; `lane` names them in the caller's batch.
struct Walk {
    explicit Walk(int capacity)
        : rays(capacity), hits(capacity), points(capacity), opacity(colorSamples, capacity),
          capacity(capacity) {}
    RayBatch rays;
    HitBatch hits;
    ShadingPoints points;
    Planes<float> opacity;
    std::vector<int> lane, order;
    std::vector<std::uint8_t> keep;
    int capacity;

    void copyRay(int to, const RayBatch &from, int i) {
        rays.originX[to] = from.originX[i], rays.originY[to] = from.originY[i];
        rays.originZ[to] = from.originZ[i], rays.directionX[to] = from.directionX[i];
        rays.directionY[to] = from.directionY[i], rays.directionZ[to] = from.directionZ[i];
        rays.tMax[to] = from.tMax[i], rays.time[to] = from.time[i];
    }
};

Walk &walkFor(int capacity) {
    thread_local std::optional<Walk> own;
    if (!own || own->capacity < capacity)
        own.emplace(capacity);
    return *own;
}

/// Starts ray i anew behind the surface it has met.
void stepBehind(RayBatch &rays, int i, const ShadingPoints &points, int k) {
    auto vec3 = [&](ShaderInput input) {
        float *const *planes = points.inputTable.data() + int(input);
        return Vec3{planes[0][k], planes[1][k], planes[2][k]};
    };
    Vec3 direction{rays.directionX[i], rays.directionY[i], rays.directionZ[i]};
    Vec3 origin{rays.originX[i], rays.originY[i], rays.originZ[i]};
    Vec3 next = Scene::offsetOrigin(vec3(ShaderInput::P), vec3(ShaderInput::Ng), direction,
                                    points.offset[k]);
    float step = dot(next - origin, direction) / dot(direction, direction);
    rays.originX[i] = next.x, rays.originY[i] = next.y, rays.originZ[i] = next.z;
    rays.tMax[i] -= step;
}

} // namespace

bool Scene::transmittance(const RayBatch &rays, float *const *transmittance) const {
    thread_local Scratch<std::uint8_t> blockedScratch;
    std::uint8_t *blocked = blockedScratch.get(rays.count);
    state_->rays->occluded(rays, blocked);
    const bool colored = state_->rays->hasTransparent();
    for (int c = 0; c < (colored ? colorSamples : 1); ++c)
        for (int i = 0; i < rays.count; ++i)
            transmittance[c][i] = blocked[i] == 1 ? 0 : 1;
    if (colored)
        walkThroughTransparent(rays, blocked, transmittance);
    return colored;
}

/// Multiplies by what the transparent surfaces let through.
void Scene::walkThroughTransparent(const RayBatch &rays, const std::uint8_t *blocked,
                                   float *const *transmittance) const {
    Walk &walk = walkFor(rays.count);
    walk.lane.clear();
    for (int i = 0; i < rays.count; ++i)
        if (blocked[i] == 0) {
            walk.copyRay(int(walk.lane.size()), rays, i);
            walk.lane.push_back(i);
        }
    for (int layer = 0; layer < layersAtMost && !walk.lane.empty(); ++layer) {
        int count = walk.rays.count = int(walk.lane.size());
        state_->rays->intersect(walk.rays, walk.hits, RayWorld::Which::Transparent, false);
        walk.keep.assign(count, 0);
        for (int code = 0; code < codeCount(); ++code) {
            walk.order.clear();
            for (int i = 0; i < count; ++i)
                if (walk.hits.primitive[i] != noHit && codeOf(walk.hits.primitive[i]) == code)
                    walk.order.push_back(i);
            if (walk.order.empty())
                continue;
            const QuestionCode &question = this->code(code).question(ir::Question::Opacity);
            int hitCount = int(walk.order.size());
            shadingPoints(walk.rays, walk.hits, walk.order.data(), hitCount, walk.points);
            float *outputs[64] = {};
            int Oi = question.output("Oi");
            for (int c = 0; c < colorSamples; ++c) {
                std::fill_n(walk.opacity[c], hitCount, 1.0f);
                if (Oi >= 0)
                    outputs[Oi + c] = walk.opacity[c];
            }
            ShaderArgs args;
            bind(code, walk.points, args);
            args.outputs = outputs;
            if (question.code && Oi >= 0)
                question.code(&args);
            for (int k = 0; k < hitCount; ++k) {
                int i = walk.order[k], lane = walk.lane[i];
                bool open = false;
                for (int c = 0; c < colorSamples; ++c) {
                    float through = 1 - std::clamp(walk.opacity[c][k], 0.0f, 1.0f);
                    transmittance[c][lane] *= through;
                    open |= transmittance[c][lane] > 0;
                }
                stepBehind(walk.rays, i, walk.points, k);
                walk.keep[i] = open;
            }
        }
        int kept = 0;
        for (int i = 0; i < count; ++i)
            if (walk.keep[i]) {
                walk.copyRay(kept, walk.rays, i);
                walk.lane[kept++] = walk.lane[i];
            }
        walk.lane.resize(kept);
    }
    for (int lane : walk.lane)
        for (int c = 0; c < colorSamples; ++c)
            transmittance[c][lane] = 0;
}

} // namespace candela
