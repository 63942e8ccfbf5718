// SPDX-License-Identifier: Apache-2.0
// What comes through along shadow rays. Opaque surfaces end the matter at once; transparent ones
// are walked through from front to back, all rays together, a surface each at a time.
#include "foundation/base/hash.h"
#include "foundation/base/hot.h"
#include "foundation/base/scratch.h"
#include "world/scene/opacity.h"
#include "world/scene/scene.h"
#include "world/scene/scene_state.h"
#include "world/scene/segments.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
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
    const ShadowMedia *media = nullptr; ///< Null: nobody asks for volumes.
    bool fromOrigins = false;           ///< Of the segments of this layer.
    std::vector<MediaAround> around;    ///< What the rays are in, if media are given.
    std::optional<Segments> segments;   ///< Of this layer.

    /// Takes the rays that no opaque surface stops.
    void begin(const RayBatch &from, const std::uint8_t *blocked, const ShadowMedia *given) {
        lane.clear(), around.clear();
        media = given;
        if (media && !segments)
            segments.emplace(capacity);
        for (int i = 0; i < from.count; ++i)
            if (blocked[i] == 0) {
                copyRay(int(lane.size()), from, i);
                lane.push_back(i);
                if (media)
                    around.emplace_back(media->inner[i], media->outer[i]);
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
                if (media)
                    around[kept] = around[i];
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

/// The segment of ray i up to t: nothing is known of its end but where it is.
void takeSegment(Walk &walk, int i, float t, std::int32_t medium) {
    Segments &segments = *walk.segments;
    segments.medium[i] = medium;
    std::uint64_t bits = 0;
    const float length = walk.fromOrigins ? t : t - walk.rays.tMin[i];
    for (int c = 0; c < 3; ++c) {
        const float along = walk.rays.direction[c][i];
        segments.input(ShaderInput::P, c)[i] = walk.rays.origin[c][i] + t * along;
        segments.input(ShaderInput::I, c)[i] = length * along;
        bits = mixBits(bits ^ std::bit_cast<std::uint32_t>(walk.rays.origin[c][i]) ^
                       (std::uint64_t(std::bit_cast<std::uint32_t>(along)) << 32));
    }
    segments.input(ShaderInput::time)[i] = walk.rays.time[i];
    segments.input(ShaderInput::seed)[i] = std::bit_cast<float>(std::uint32_t(bits >> 32));
}

/// The segment to the k-th of the points, and what lies behind.
void enterSegment(const Scene &scene, Walk &walk, int k) {
    const int i = walk.order[k];
    const SurfaceMedia &surface = scene.mediaOf(walk.points.instance[k], walk.points.shape[k]);
    float side = 0;
    for (int c = 0; c < 3; ++c)
        side += walk.points.input(ShaderInput::Ng, c)[k] * walk.points.input(ShaderInput::I, c)[k];
    const bool fromInside = side > 0;
    takeSegment(walk, i, walk.hits.t[i], walk.around[i].towards(surface, fromInside));
    walk.around[i] = walk.around[i].beyond(surface, fromInside, !fromInside);
}

/// The segments of rays that meet nothing any more; those of endless rays have no volume.
void takeLastSegments(Walk &walk) {
    for (int i = 0; i < walk.rays.count; ++i)
        if (walk.hits.shape[i] == noHit) {
            const float t = walk.rays.tMax[i];
            const std::int32_t atmosphere = walk.media->atmosphere[walk.lane[i]];
            takeSegment(walk, i, t, std::isfinite(t) ? walk.around[i].towardsAir(atmosphere) : 0);
        }
}

void attenuateByVolumes(const Scene &scene, const SceneState &state, Walk &walk,
                        float *const *transmittance) {
    Segments &segments = *walk.segments;
    segments.count = walk.rays.count;
    segments.endAnywhere(state.points.shapeMatrices.data());
    for (const Segments::Group &group : segments.begin(scene))
        segments.askTransmission(group);
    for (int c = 0; c < colorSamples; ++c)
        for (int i = 0; i < walk.rays.count; ++i) {
            const float factor = segments.answers().CiOfCi[c][i];
            transmittance[c][walk.lane[i]] *= std::isfinite(factor) ? factor : 0.0f;
        }
}

/// Multiplies by what the transparent surfaces and the volumes let through.
void walkThrough(const Scene &scene, const SceneState &state, const RayBatch &rays,
                 const std::uint8_t *blocked, const ShadowMedia *media,
                 float *const *transmittance) {
    // A surface's opacity may depend on transmission(): within that, what is not opaque is clear.
    thread_local bool isUnderWay = false;
    if (isUnderWay)
        return;
    isUnderWay = true;
    Walk &walk = walkFor(rays.count);
    walk.begin(rays, blocked, media);
    for (int layer = 0; layer < layersAtMost && !walk.lane.empty(); ++layer) {
        if (state.rays->hasTransparent())
            state.rays->intersect(walk.rays, walk.hits, RayWorld::Which::Transparent, false);
        else
            std::fill_n(walk.hits.shape, walk.rays.count, noHit);
        walk.fromOrigins = media && media->fromOrigins && layer == 0;
        if (media)
            takeLastSegments(walk);
        walk.keep.assign(walk.lane.size(), 0);
        for (int code = 0; code < scene.codeCount(); ++code) {
            walk.takeHitsOf(scene, code);
            if (walk.order.empty())
                continue;
            askOpacity(scene, code, walk);
            for (int k = 0; k < walk.points.count; ++k) {
                if (media)
                    enterSegment(scene, walk, k);
                passSurface(walk, k, transmittance);
            }
        }
        if (media)
            attenuateByVolumes(scene, state, walk, transmittance);
        walk.dropTheRest();
    }
    for (int lane : walk.lane)
        for (int c = 0; c < colorSamples; ++c)
            transmittance[c][lane] = 0;
    isUnderWay = false;
}

} // namespace

bool Scene::transmittance(const RayBatch &rays, float *const *transmittance,
                          const ShadowMedia *media) const {
    thread_local Scratch<std::uint8_t> blockedScratch;
    std::uint8_t *blocked = blockedScratch.get(rays.count);
    state_->rays->occluded(rays, blocked);
    const bool colored = state_->rays->hasTransparent() || media;
    for (int c = 0; c < (colored ? colorSamples : 1); ++c)
        passUnblocked(rays.count, blocked, transmittance[c]);
    if (colored)
        walkThrough(*this, *state_, rays, blocked, media, transmittance);
    return colored;
}

} // namespace candela
