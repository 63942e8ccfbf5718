// SPDX-License-Identifier: Apache-2.0
// What comes through along shadow rays. Opaque surfaces end the matter at once; transparent ones
// are walked through from front to back, all rays together, a surface each at a time.
#include "foundation/base/hot.h"
#include "foundation/base/scratch.h"
#include "world/scene/opacity.h"
#include "world/scene/scene.h"
#include "world/scene/scene_state.h"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

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

    /// Takes the rays that no opaque surface stops.
    void begin(const RayBatch &from, const std::uint8_t *blocked) {
        lane.clear();
        for (int i = 0; i < from.count; ++i)
            if (blocked[i] == 0) {
                copyRay(int(lane.size()), from, i);
                lane.push_back(i);
            }
        rays.count = int(lane.size());
    }
    /// `order` becomes the rays that have hit surfaces of one code.
    void takeHitsOf(const Scene &scene, int code) {
        order.clear();
        for (int i = 0; i < rays.count; ++i)
            if (hits.shape[i] != noHit && scene.codeOf(hits, i) == code)
                order.push_back(i);
    }
    void dropTheRest() {
        int kept = 0;
        for (int i = 0; i < rays.count; ++i)
            if (keep[i]) {
                copyRay(kept, rays, i);
                lane[kept++] = lane[i];
            }
        lane.resize(kept);
        rays.count = kept;
    }
    void copyRay(int to, const RayBatch &from, int i) {
        rays.origin[0][to] = from.origin[0][i], rays.origin[1][to] = from.origin[1][i];
        rays.origin[2][to] = from.origin[2][i], rays.direction[0][to] = from.direction[0][i];
        rays.direction[1][to] = from.direction[1][i], rays.direction[2][to] = from.direction[2][i];
        rays.tMin[to] = from.tMin[i], rays.tMax[to] = from.tMax[i], rays.time[to] = from.time[i];
    }
};

Walk &walkFor(int capacity) {
    thread_local std::optional<Walk> own;
    if (!own || own->capacity < capacity)
        own.emplace(capacity);
    return *own;
}

/// Opacities at the hits of `order`: walk.points and walk.opacity.
void askOpacity(const Scene &scene, int code, Walk &walk) {
    const QuestionCode &question = scene.code(code).question(ir::Question::Opacity);
    const int count = int(walk.order.size());
    scene.shadingPoints(walk.rays, walk.hits, walk.order.data(), count, walk.points);
    std::array<float *, colorSamples> opacity;
    for (int c = 0; c < colorSamples; ++c) {
        opacity[c] = walk.opacity[c];
        std::fill_n(opacity[c], count, 1.0f);
    }
    thread_local std::vector<float *> outputs;
    outputs.clear();
    question.place(ir::OutputKind::Oi, opacity.data(), outputs);
    ShaderArgs args;
    scene.bind(code, walk.points, args);
    args.outputs = outputs.data();
    if (question.code)
        question.code(&args);
}

CANDELA_HOT void passUnblocked(int count, const std::uint8_t *__restrict blocked,
                               float *__restrict transmittance) {
    for (int i = 0; i < count; ++i)
        transmittance[i] = blocked[i] == 1 ? 0.0f : 1.0f;
}

/// The k-th ray of `order` loses what the surface keeps and goes on behind it.
void passSurface(Walk &walk, int k, float *const *transmittance) {
    const int i = walk.order[k], lane = walk.lane[i];
    bool open = false;
    for (int c = 0; c < colorSamples; ++c) {
        transmittance[c][lane] *= 1 - clampedOpacity(walk.opacity[c][k]);
        open |= transmittance[c][lane] > 0;
    }
    walk.rays.tMin[i] = passing(walk.hits.t[i]);
    walk.keep[i] = open;
}

/// Multiplies by what the transparent surfaces let through.
void walkThroughTransparent(const Scene &scene, const RayWorld &world, const RayBatch &rays,
                            const std::uint8_t *blocked, float *const *transmittance) {
    // A surface's opacity may depend on transmission(): within that, what is not opaque is clear.
    thread_local bool isUnderWay = false;
    if (isUnderWay)
        return;
    isUnderWay = true;
    Walk &walk = walkFor(rays.count);
    walk.begin(rays, blocked);
    for (int layer = 0; layer < layersAtMost && !walk.lane.empty(); ++layer) {
        world.intersect(walk.rays, walk.hits, RayWorld::Which::Transparent, false);
        walk.keep.assign(walk.lane.size(), 0);
        for (int code = 0; code < scene.codeCount(); ++code) {
            walk.takeHitsOf(scene, code);
            if (walk.order.empty())
                continue;
            askOpacity(scene, code, walk);
            for (int k = 0; k < walk.points.count; ++k)
                passSurface(walk, k, transmittance);
        }
        walk.dropTheRest();
    }
    for (int lane : walk.lane)
        for (int c = 0; c < colorSamples; ++c)
            transmittance[c][lane] = 0;
    isUnderWay = false;
}

} // namespace

bool Scene::transmittance(const RayBatch &rays, float *const *transmittance) const {
    thread_local Scratch<std::uint8_t> blockedScratch;
    std::uint8_t *blocked = blockedScratch.get(rays.count);
    state_->rays->occluded(rays, blocked);
    const bool colored = state_->rays->hasTransparent();
    for (int c = 0; c < (colored ? colorSamples : 1); ++c)
        passUnblocked(rays.count, blocked, transmittance[c]);
    if (colored)
        walkThroughTransparent(*this, *state_->rays, rays, blocked, transmittance);
    return colored;
}

} // namespace candela
