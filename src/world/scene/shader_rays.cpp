// SPDX-License-Identifier: Apache-2.0
#include "world/scene/shader_rays.h"

#include "foundation/base/vec3.h"
#include "language/runtime/hit_fields.h"
#include "world/scene/cone_samples.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace candela {

namespace {

constexpr int batchSize = 256;

/// A service's operands of one lane, one after the other.
class Operands {
public:
    Operands(const ServiceCall &call, int lane) : call_(call), lane_(lane) {}
    float number() { return call_.operand(next_++, lane_).number; }
    Vec3 vec3() {
        const float x = number(), y = number(), z = number();
        return {x, y, z};
    }

private:
    const ServiceCall &call_;
    int lane_, next_ = 0;
};

/// Where rays leave a surface.
struct Start {
    Vec3 P, Ng; ///< Ng may be 0: not known.
    float offset = 0;

    Vec3 origin(Vec3 direction) const {
        if (dot(Ng, Ng) > 0)
            return Scene::offsetOrigin(P, Ng, direction, offset);
        return P + normalize(direction) * (2 * offset);
    }
};

using Through = std::array<float, colorSamples>;

/// The rays of one lane. What they meet may depend on the packets that they are traced in, so
/// lanes never share a batch: the answer is the same whoever asks beside.
class LaneRays {
public:
    explicit LaneRays(const Scene &scene)
        : scene_(scene), rays_(batchSize), through_(colorSamples, batchSize) {
        for (int c = 0; c < colorSamples; ++c)
            planes_[c] = through_[c];
    }

    bool isFull() const { return rays_.count == batchSize; }
    void add(Vec3 origin, Vec3 direction, float tMin, float tMax, float time) {
        const int i = rays_.count++;
        for (int c = 0; c < 3; ++c)
            rays_.origin[c][i] = origin[c], rays_.direction[c][i] = direction[c];
        const bool isSound = tMax > tMin && tMin >= 0;
        rays_.tMin[i] = isSound ? tMin : 0, rays_.tMax[i] = isSound ? tMax : 0;
        rays_.time[i] = time, rays_.width[i] = rays_.spread[i] = 0;
    }
    /// Follows them and calls take(i, what part of light comes along ray i).
    template <class Take> void follow(Take take) {
        if (rays_.count == 0)
            return;
        const bool colored = scene_.transmittance(rays_, planes_.data());
        for (int i = 0; i < rays_.count; ++i) {
            Through through;
            for (int c = 0; c < colorSamples; ++c)
                through[c] = planes_[colored ? c : 0][i];
            take(i, through);
        }
        rays_.count = 0;
    }

private:
    const Scene &scene_;
    RayBatch rays_;
    Planes<float> through_;
    std::array<float *, colorSamples> planes_;
};

} // namespace

void ShaderRays::transmission(const ServiceCall &call) const {
    LaneRays rays(scene_);
    for (int lane = 0; lane < call.laneCount; ++lane) {
        if (!call.asks(lane))
            continue;
        Operands in(call, lane);
        const Vec3 from = in.vec3(), to = in.vec3(), Ng = in.vec3();
        const Start start{from, Ng, in.number()};
        const float wanted = in.number(), angle = in.number(), bias = in.number();
        const float time = in.number(), shiftX = in.number(), shiftY = in.number();
        const Vec3 way = to - from;
        const float distance = length(way);
        const int samples = angle > 0 ? sampleCount(wanted) : 1;
        const auto take = [&](int, const Through &through) {
            for (int c = 0; c < std::min(colorSamples, int(call.site->resultCount)); ++c)
                call.result(c, lane) += through[c] / float(samples);
        };
        for (int k = 0; k < samples; ++k) {
            Vec3 direction = way * (1 / distance);
            if (angle > 0) {
                const ConeSample pair = coneSample(k, shiftX, shiftY);
                direction = directionAbout(direction, cosineInCone(pair.x, angle, false), pair.y);
            }
            // The way ends before the zone of a surface that the other point may lie on.
            const float end = distance * (1 - 8 * 0x1p-24f) - 2 * start.offset;
            rays.add(start.origin(direction), direction, std::max(bias, 0.0f), end, time);
            if (rays.isFull())
                rays.follow(take);
        }
        rays.follow(take);
    }
}

namespace {

/// What occlusion() is asked, and what it has found so far.
struct Hemisphere {
    Vec3 axis, mean;
    Start start;
    int samples = 1;
    float angle = 0, bias = 0, reach = 0, time = 0, shiftX = 0, shiftY = 0, hidden = 0;
    bool weighted = false;

    explicit Hemisphere(Operands in) {
        start.P = in.vec3(), axis = in.vec3(), start.Ng = in.vec3(), start.offset = in.number();
        samples = sampleCount(in.number());
        angle = in.number(), bias = in.number(), reach = in.number();
        weighted = in.number() != 0;
        time = in.number(), shiftX = in.number(), shiftY = in.number();
    }
    Vec3 direction(int k) const {
        const ConeSample pair = coneSample(k, shiftX, shiftY);
        return directionAbout(axis, cosineInCone(pair.x, angle, weighted), pair.y);
    }
    /// Directions into the surface itself, as it turns away from the axis, are hidden.
    bool isInward(Vec3 direction) const {
        return dot(start.Ng, direction) * (dot(start.Ng, axis) < 0 ? -1.0f : 1.0f) < 0;
    }
    void count(Vec3 direction, float through) {
        hidden += (1 - through) / float(samples);
        mean = mean + direction * through;
    }
};

} // namespace

void ShaderRays::occlusion(const ServiceCall &call) const {
    LaneRays rays(scene_);
    std::vector<Vec3> followed;
    for (int lane = 0; lane < call.laneCount; ++lane) {
        if (!call.asks(lane))
            continue;
        Hemisphere asked(Operands(call, lane));
        const auto take = [&](int i, const Through &through) {
            float sum = 0;
            for (float t : through)
                sum += t;
            asked.count(followed[std::size_t(i)], sum / colorSamples);
        };
        const auto follow = [&] {
            rays.follow(take);
            followed.clear();
        };
        for (int k = 0; k < asked.samples; ++k) {
            const Vec3 direction = asked.direction(k);
            if (asked.isInward(direction)) {
                asked.count(direction, 0);
                continue;
            }
            followed.push_back(direction);
            rays.add(asked.start.origin(direction), direction, std::max(asked.bias, 0.0f),
                     asked.reach, asked.time);
            if (rays.isFull())
                follow();
        }
        follow();
        const float size = length(asked.mean);
        call.result(0, lane) = asked.hidden;
        for (int c = 0; c < 3; ++c)
            call.result(1 + c, lane) = size > 0 ? asked.mean[c] / size : 0;
    }
}

namespace {

/// Hits and the points where they are, of up to a block of lanes.
struct HitScratch {
    RayBatch one{laneBlock}, rays{laneBlock};
    HitBatch oneHit{laneBlock}, hits{laneBlock};
    ShadingPoints points{laneBlock};
    std::vector<int> lane, order;

    /// Traced alone, as LaneRays are.
    bool meets(const Scene &scene, Vec3 origin, Vec3 direction, float tMin, float tMax,
               float time) {
        one.count = 1;
        for (int c = 0; c < 3; ++c)
            one.origin[c][0] = origin[c], one.direction[c][0] = direction[c];
        one.tMin[0] = tMin, one.tMax[0] = tMax, one.time[0] = time;
        one.width[0] = one.spread[0] = 0;
        scene.intersect(one, oneHit, Coherence::Secondary);
        return oneHit.shape[0] != noHit;
    }
    /// The hit becomes row i.
    void keep(int i) {
        for (int plane = 0; plane < one.planes.planes(); ++plane)
            rays.planes[plane][i] = one.planes[plane][0];
        for (int plane = 0; plane < hits.integers.planes(); ++plane)
            hits.integers[plane][i] = oneHit.integers[plane][0];
        for (int plane = 0; plane < hits.floats.planes(); ++plane)
            hits.floats[plane][i] = oneHit.floats[plane][0];
    }
};

void tell(const ServiceCall &call, HitScratch &own) {
    for (int k = 0; k < int(own.order.size()); ++k) {
        const int i = own.order[k], lane = own.lane[i];
        const auto put = [&](int field, ShaderInput input, int numbers) {
            for (int c = 0; c < numbers; ++c)
                call.result(field + c, lane) = own.points.input(input, c)[k];
        };
        const Vec3 I{own.points.input(ShaderInput::I, 0)[k], own.points.input(ShaderInput::I, 1)[k],
                     own.points.input(ShaderInput::I, 2)[k]};
        call.result(HitField::hit, lane) = 1;
        call.result(HitField::distance, lane) = length(I);
        put(HitField::P, ShaderInput::P, 3);
        put(HitField::N, ShaderInput::N, 3);
        put(HitField::Ng, ShaderInput::Ng, 3);
        put(HitField::s, ShaderInput::s, 1);
        put(HitField::t, ShaderInput::t, 1);
        put(HitField::u, ShaderInput::u, 1);
        put(HitField::v, ShaderInput::v, 1);
        put(HitField::Cs, ShaderInput::Cs, colorSamples);
        put(HitField::Os(colorSamples), ShaderInput::Os, colorSamples);
    }
}

} // namespace

void ShaderRays::nearestHit(const ServiceCall &call) const {
    thread_local std::optional<HitScratch> scratch;
    HitScratch &own = scratch ? *scratch : scratch.emplace();
    own.lane.clear(), own.order.clear();
    RayBatch &rays = own.rays;
    int rows = 0;
    for (int lane = 0; lane < call.laneCount; ++lane) {
        if (!call.asks(lane))
            continue;
        Operands in(call, lane);
        const Vec3 P = in.vec3(), direction = in.vec3(), Ng = in.vec3();
        const Start start{P, Ng, in.number()};
        const Vec3 origin = start.origin(direction);
        const float bias = in.number(), reach = in.number(), time = in.number();
        if (!own.meets(scene_, origin, direction, std::max(bias, 0.0f), reach, time))
            continue;
        own.keep(rows++);
        own.lane.push_back(lane);
    }
    rays.count = rows;
    for (int i = 0; i < rows; ++i)
        own.order.push_back(i);
    scene_.describedPoints(rays, own.hits, own.order.data(), rows, own.points);
    tell(call, own);
}

} // namespace candela
