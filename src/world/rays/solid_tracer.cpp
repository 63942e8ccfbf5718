// SPDX-License-Identifier: Apache-2.0
#include "world/rays/solid_tracer.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace candela {

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

/// What a ray meets of a solid's bodies, on its way into crossings.
struct Collecting {
    RayContext context; ///< The first member, so that the filter finds the rest.
    std::vector<SolidCrossing> *crossings = nullptr;
};

float largest(Vec3 v) { return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}); }

std::vector<SolidCrossing> &crossingsOfThread() {
    thread_local std::vector<SolidCrossing> own;
    own.clear();
    return own;
}

SolidExpression::State &stateOfThread() {
    thread_local SolidExpression::State own;
    return own;
}

} // namespace

SolidTracer::SolidTracer(const Solid &solid, RTCScene bodies, std::span<const PlacedShapes> members,
                         float unit)
    : expression_(solid.nodes), bodies_(bodies), unit_(unit) {
    for (std::size_t k = 0; k < solid.members.size(); ++k) {
        const SolidMember &member = solid.members[k];
        members_.push_back({member.geometry, std::int32_t(parts_.size())});
        for (std::size_t shape = 0; shape < member.nodes.size(); ++shape) {
            const RayShape &of = members[k].shapes[shape];
            parts_.push_back({member.nodes[shape], maskOf(of), of.frontSign, of.isStroke});
            mask_ |= maskOf(of);
        }
    }
    std::ranges::sort(members_, {}, &Member::geometry);
    openNodes_ = findOpenNodes(members);
    for (SolidPart &part : parts_)
        part.isSheet |= std::ranges::binary_search(openNodes_, part.node);
}

SolidTracer::~SolidTracer() { rtcReleaseScene(bodies_); }

void SolidTracer::attach(const EmbreeDevice &device, RTCScene world) const {
    RTCGeometry geometry = rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_USER);
    if (!geometry || members_.empty())
        return;
    rtcSetGeometryUserPrimitiveCount(geometry, 1);
    rtcSetGeometryUserData(geometry, const_cast<SolidTracer *>(this));
    rtcSetGeometryBoundsFunction(geometry, bounds, nullptr);
    rtcSetGeometryIntersectFunction(geometry, intersect);
    rtcSetGeometryOccludedFunction(geometry, occluded);
    rtcSetGeometryMask(geometry, mask_ & ~bodyBit);
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(world, geometry, members_.front().geometry);
    rtcReleaseGeometry(geometry);
}

std::int32_t SolidTracer::partOf(std::uint32_t geometry, std::uint32_t shape) const {
    const auto member = std::ranges::lower_bound(members_, geometry, {}, &Member::geometry);
    return member->firstPart + std::int32_t(shape);
}

// ---- Embree's questions ----

void SolidTracer::bounds(const RTCBoundsFunctionArguments *args) {
    const auto *solid = static_cast<const SolidTracer *>(args->geometryUserPtr);
    RTCLinearBounds swept;
    rtcGetSceneLinearBounds(solid->bodies_, &swept);
    RTCBounds &to = *args->bounds_o;
    const RTCBounds &a = swept.bounds0, &b = swept.bounds1;
    to.lower_x = std::min(a.lower_x, b.lower_x), to.upper_x = std::max(a.upper_x, b.upper_x);
    to.lower_y = std::min(a.lower_y, b.lower_y), to.upper_y = std::max(a.upper_y, b.upper_y);
    to.lower_z = std::min(a.lower_z, b.lower_z), to.upper_z = std::max(a.upper_z, b.upper_z);
}

/// Notes what the ray meets, and lets it go on.
void SolidTracer::collect(const RTCFilterFunctionNArguments *args) {
    if (!args->valid[0])
        return;
    args->valid[0] = 0;
    RTCHitN *hit = args->hit;
    const Vec3 Ng{RTCHitN_Ng_x(hit, 1, 0), RTCHitN_Ng_y(hit, 1, 0), RTCHitN_Ng_z(hit, 1, 0)};
    RTCRayN *ray = args->ray;
    const Vec3 direction{RTCRayN_dir_x(ray, 1, 0), RTCRayN_dir_y(ray, 1, 0),
                         RTCRayN_dir_z(ray, 1, 0)};
    const float along = dot(Ng, direction);
    SolidCrossing crossing;
    crossing.t = RTCRayN_tfar(ray, 1, 0);
    crossing.slack = std::fabs(along) / (length(Ng) * length(direction)); // As yet the cosine.
    crossing.againstNormal = along < 0;
    crossing.geometry = RTCHitN_geomID(hit, 1, 0);
    crossing.instance = RTCHitN_instID(hit, 1, 0, 0);
    crossing.element = RTCHitN_primID(hit, 1, 0);
    crossing.u = RTCHitN_u(hit, 1, 0), crossing.v = RTCHitN_v(hit, 1, 0);
    crossing.Ng = Ng;
    reinterpret_cast<Collecting *>(args->context)->crossings->push_back(crossing);
}

void SolidTracer::findCrossings(const Ray &ray, std::vector<SolidCrossing> &crossings) const {
    Collecting collecting;
    collecting.crossings = &crossings;
    RTCIntersectContext &context = collecting.context.embree;
    rtcInitIntersectContext(&context);
    context.filter = collect;
    collecting.context.collects = true;
    alignas(16) RTCRayHit asked{};
    asked.ray.org_x = ray.origin.x, asked.ray.org_y = ray.origin.y, asked.ray.org_z = ray.origin.z;
    asked.ray.dir_x = ray.direction.x, asked.ray.dir_y = ray.direction.y;
    asked.ray.dir_z = ray.direction.z;
    asked.ray.tnear = ray.tMin, asked.ray.tfar = infinity, asked.ray.time = ray.time;
    asked.ray.mask = bodyBit;
    asked.hit.geomID = asked.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(bodies_, &context, &asked);

    constexpr float leastCosine = 1 / 64.0f;
    const float speed = length(ray.direction), from = largest(ray.origin);
    for (SolidCrossing &crossing : crossings) {
        const bool placed = crossing.instance != RTC_INVALID_GEOMETRY_ID;
        crossing.part =
            partOf(placed ? crossing.instance : crossing.geometry, placed ? crossing.geometry : 0);
        const float at = largest(ray.origin + ray.direction * crossing.t);
        const float rounding = (6 * at + 4 * from + 4 * crossing.t * speed) * 0x1p-24f;
        crossing.slack = rounding / (std::max(crossing.slack, leastCosine) * speed);
    }
}

bool SolidTracer::stops(const SolidCrossing &crossing, unsigned mask, bool fromLights) const {
    const SolidPart &part = parts_[std::size_t(crossing.part)];
    if (!(part.mask & mask))
        return false;
    const bool fromBehind = crossing.againstNormal ? part.frontSign < 0 : part.frontSign > 0;
    return !fromBehind || (fromLights && !part.isSheet);
}

/// Lane i of what Embree asks about.
template <class RayOfLane> static auto rayOfLane(RTCRayN *ray, unsigned n, unsigned i) {
    return RayOfLane{{RTCRayN_org_x(ray, n, i), RTCRayN_org_y(ray, n, i), RTCRayN_org_z(ray, n, i)},
                     {RTCRayN_dir_x(ray, n, i), RTCRayN_dir_y(ray, n, i), RTCRayN_dir_z(ray, n, i)},
                     RTCRayN_tnear(ray, n, i),
                     RTCRayN_time(ray, n, i)};
}

void SolidTracer::intersect(const RTCIntersectFunctionNArguments *args) {
    const auto &solid = *static_cast<const SolidTracer *>(args->geometryUserPtr);
    const bool fromLights = reinterpret_cast<const RayContext *>(args->context)->fromLights;
    const unsigned n = args->N;
    RTCRayN *ray = RTCRayHitN_RayN(args->rayhit, n);
    RTCHitN *hit = RTCRayHitN_HitN(args->rayhit, n);
    for (unsigned i = 0; i < n; ++i) {
        if (!args->valid[i])
            continue;
        std::vector<SolidCrossing> &crossings = crossingsOfThread();
        solid.findCrossings(rayOfLane<Ray>(ray, n, i), crossings);
        const unsigned mask = RTCRayN_mask(ray, n, i);
        const float end = RTCRayN_tfar(ray, n, i);
        passAll(solid.expression_, solid.parts_, crossings, stateOfThread(),
                [&](const SolidCrossing &met, float t) {
                    if (t > end || !solid.stops(met, mask, fromLights))
                        return;
                    RTCRayN_tfar(ray, n, i) = t;
                    RTCHitN_geomID(hit, n, i) = met.geometry;
                    RTCHitN_instID(hit, n, i, 0) = met.instance;
                    RTCHitN_primID(hit, n, i) = met.element;
                    RTCHitN_u(hit, n, i) = met.u, RTCHitN_v(hit, n, i) = met.v;
                    RTCHitN_Ng_x(hit, n, i) = met.Ng.x;
                    RTCHitN_Ng_y(hit, n, i) = met.Ng.y;
                    RTCHitN_Ng_z(hit, n, i) = met.Ng.z;
                });
    }
}

void SolidTracer::occluded(const RTCOccludedFunctionNArguments *args) {
    const auto &solid = *static_cast<const SolidTracer *>(args->geometryUserPtr);
    const bool fromLights = reinterpret_cast<const RayContext *>(args->context)->fromLights;
    const unsigned n = args->N;
    for (unsigned i = 0; i < n; ++i) {
        if (!args->valid[i])
            continue;
        std::vector<SolidCrossing> &crossings = crossingsOfThread();
        solid.findCrossings(rayOfLane<Ray>(args->ray, n, i), crossings);
        const unsigned mask = RTCRayN_mask(args->ray, n, i);
        const float end = RTCRayN_tfar(args->ray, n, i);
        bool blocked = false;
        passAll(solid.expression_, solid.parts_, crossings, stateOfThread(),
                [&](const SolidCrossing &met, float t) {
                    blocked |= t <= end && solid.stops(met, mask, fromLights);
                });
        if (blocked)
            RTCRayN_tfar(args->ray, n, i) = -infinity;
    }
}

// ---- Our own ----

bool SolidTracer::isOnSurface(std::uint32_t geometry, std::uint32_t shape,
                              const PointOnSolid &point) const {
    const float size = length(point.normal);
    if (!(size > 0))
        return false;
    const Vec3 outward = point.normal * (1 / size);
    const float away = (point.away + 64 * 0x1p-24f * largest(point.P)) * unit_;
    std::vector<SolidCrossing> &crossings = crossingsOfThread();
    findCrossings({point.P * unit_ + outward * away, outward * -1.0f, 0, point.share}, crossings);
    const std::int32_t part = partOf(geometry, shape);
    bool found = false;
    passAll(expression_, parts_, crossings, stateOfThread(), [&](const SolidCrossing &met, float) {
        found |= met.part == part && std::fabs(met.t - away) < away / 2;
    });
    return found;
}

} // namespace candela
