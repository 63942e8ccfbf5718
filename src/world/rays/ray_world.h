// SPDX-License-Identifier: Apache-2.0
// What rays meet, and the meeting. This room is the one door to Embree.
#pragma once

#include "foundation/base/matrix4.h"
#include "foundation/base/round_elements.h"
#include "foundation/base/shutter.h"
#include "world/rays/ray_batch.h"
#include "world/rays/ray_limits.h"
#include "world/rays/solid.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace candela {

/// One shape as rays see it: triangles, or what is round as it is.
struct RayShape {
    std::vector<Vec3> positions;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    RoundElements round; ///< Where there are any, there are no triangles.
    /// It changes its shape: positions at later even steps over the shutter's interval. Else empty.
    std::vector<std::vector<Vec3>> later;
    bool opaque = true;
    bool stopsLight = true;      ///< False: rays see it and shadow rays pass through.
    std::uint8_t hiddenFrom = 0; ///< Bits of ray_kind.
    /// Not zero: only rays that come against this sign times the normal are stopped; the normal is
    /// (p1 - p0) x (p2 - p0), of what is round the outward one.
    int frontSign = 0;
    /// Rays that run against the eye's are stopped from the front alone, too.
    bool isStroke = false;
    /// Paths whose choiceOf() lies in [presentFrom, presentUntil) meet it.
    float presentFrom = 0, presentUntil = 1;

    /// What it is made of goes; how rays meet it stays.
    void letGoOfElements();
    bool empty() const { return triangles.empty() && round.size() == 0; }
    bool changes() const { return !later.empty() || !round.later.empty(); }
    bool isDissolved() const { return presentFrom > 0 || presentUntil < 1; }
};

/// Shapes that instances place together.
using RayObject = std::vector<RayShape>;

struct RayInstance {
    std::uint32_t object = 0;     ///< Index into the objects.
    std::uint32_t firstShape = 0; ///< HitBatch::shape of the object's first shape.
    Matrix4 currentFromObject;
    /// It moves: its matrices at even steps over the shutter's interval. Else empty.
    std::span<const Matrix4> steps;
};

/// Flush-to-zero and denormals-are-zero for as long as it lives, as Embree wants them.
class FlushDenormals {
public:
    FlushDenormals();
    ~FlushDenormals();
    FlushDenormals(const FlushDenormals &) = delete;

private:
    unsigned saved_;
};

class RayWorld {
public:
    /// world[i] is shape i of the scene, in current space. Shapes go as the ray tracer has
    /// taken them; nothing of what is given is needed afterwards.
    RayWorld(RayObject world, std::vector<RayObject> objects,
             std::span<const RayInstance> instances, const Shutter & = {},
             std::span<const Solid> solids = {});
    explicit RayWorld(RayObject world) : RayWorld(std::move(world), {}, {}) {}
    ~RayWorld();
    RayWorld(const RayWorld &) = delete;

    /// Rays meet nothing behind these.
    void clipBy(std::vector<ClippingPlane> planes) { planes_ = std::move(planes); }
    const std::vector<ClippingPlane> &clippingPlanes() const { return planes_; }
    /// See choiceOf().
    bool moves() const { return moves_; }

    bool hasSolids() const { return !solidOf_.empty(); }
    bool hasTransparent() const { return hasTransparent_; }
    /// Some shapes are hidden from some kinds of rays: RayBatch::kinds matters.
    bool hidesShapes() const { return hidesShapes_; }
    /// The shape belongs to a solid, which may have cut it.
    bool isCut(std::uint32_t instance, std::uint32_t shape) const;
    /// A point of such a shape is on the solid's surface. Current space, but for normals, which are
    /// along (p1 - p0) x (p2 - p0) there; how far around it nothing counts.
    bool isLeftOver(std::uint32_t instance, std::uint32_t shape, Vec3 P, Vec3 normal, float offset,
                    float time) const;
    /// What belongs to a solid, by its number, and bounds no body.
    const std::vector<std::int32_t> &openNodes(std::size_t solid) const;
    /// What went wrong while it was built, for the user ("out of memory"); empty if nothing did.
    std::string failure() const;

    enum class Which { All, Transparent };
    /// Nearest hits, see Scene::intersect.
    void intersect(const RayBatch &, HitBatch &, Which, bool coherent) const;
    /// blocked[i] = 1 if an opaque shape stands in ray i's way (or it is not to be traced, 2).
    void occluded(const RayBatch &, std::uint8_t *blocked) const;
    /// Seconds of all threads in these two, packing of packets included.
    double secondsTracing() const { return double(nanoseconds_) * 1e-9; }

private:
    struct Handles;
    /// By geometryOf(); -1: it is of none.
    std::int32_t solidOf(std::size_t geometry) const {
        return solidOf_.empty() ? -1 : solidOf_[geometry];
    }
    void numberSolids(std::span<const Solid>, std::size_t geometries);
    /// As SolidMember has it.
    std::uint32_t geometryOf(std::uint32_t instance, std::uint32_t shape) const;
    std::unique_ptr<Handles> handles_;
    std::vector<std::uint32_t> firstShapeOfInstance_;
    std::vector<std::int32_t> solidOf_; ///< By geometryOf(); empty: there are no solids.
    std::uint32_t worldShapes_ = 0;
    float unit_ = 1; ///< Of the ray tracer: what it is given is so many times as large.
    bool hasTransparent_ = false, hidesShapes_ = false;
    bool moves_ = false, dissolves_ = false;
    std::vector<ClippingPlane> planes_;
    Shutter shutter_;
    mutable std::atomic<std::uint64_t> nanoseconds_{0};
};

} // namespace candela
