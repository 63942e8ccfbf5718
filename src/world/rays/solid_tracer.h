// SPDX-License-Identifier: Apache-2.0
// A solid among what rays meet: one thing to Embree, which finds all crossings of a ray with the
// solid's bodies and answers with the surfaces that are the solid's own.
#pragma once

#include "world/rays/embree_scene.h"
#include "world/rays/solid_surface.h"

namespace candela {

/// A point on a shape that belongs to a solid, and the time.
struct PointOnSolid {
    Vec3 P, normal;  ///< Of any length; what is asked is where the normal leads to.
    float away = 0;  ///< How far from the surface it is left alone.
    float share = 0; ///< How much of the shutter's interval has passed.
};

/// The shapes of a solid's member, where they are when the shutter opens.
struct PlacedShapes {
    std::span<const RayShape> shapes;
    Matrix4 currentFromObject;
};

class SolidTracer {
public:
    /// `bodies`: the committed scene of all members, under their numbers; it is released here.
    SolidTracer(const Solid &, RTCScene bodies, std::span<const PlacedShapes> members, float unit);
    ~SolidTracer();
    SolidTracer(const SolidTracer &) = delete;

    /// What stands for the solid in a scene.
    void attach(const EmbreeDevice &, RTCScene world) const;
    /// The point of that shape of a member is on the solid's surface.
    bool isOnSurface(std::uint32_t geometry, std::uint32_t shape, const PointOnSolid &) const;

    /// Nodes whose shapes bound no body, as some rays enter it and never leave.
    const std::vector<std::int32_t> &openNodes() const { return openNodes_; }

private:
    /// In the units of the ray tracer.
    struct Ray {
        Vec3 origin, direction;
        float tMin = 0, time = 0;
    };
    static void bounds(const RTCBoundsFunctionArguments *);
    static void intersect(const RTCIntersectFunctionNArguments *);
    static void occluded(const RTCOccludedFunctionNArguments *);
    static void collect(const RTCFilterFunctionNArguments *);

    void findCrossings(const Ray &, std::vector<SolidCrossing> &) const;
    bool stops(const SolidCrossing &, unsigned mask, bool fromLights) const;
    std::int32_t partOf(std::uint32_t geometry, std::uint32_t shape) const;
    std::vector<std::int32_t> findOpenNodes(std::span<const PlacedShapes>) const;

    SolidExpression expression_;
    RTCScene bodies_;
    std::vector<SolidPart> parts_;
    struct Member {
        std::uint32_t geometry;
        std::int32_t firstPart;
    };
    std::vector<Member> members_; ///< By geometry.
    std::vector<std::int32_t> openNodes_;
    float unit_;
    unsigned mask_ = 0;
};

} // namespace candela
