// SPDX-License-Identifier: Apache-2.0
#include "world/rays/ray_world.h"

#include "foundation/base/hot.h"
#include "foundation/base/scratch.h"
#include "world/rays/solid_tracer.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <pmmintrin.h>

namespace candela {

namespace {

struct RayPlanes {
    const float *ox, *oy, *oz, *dx, *dy, *dz, *tMin, *tMax;
    const float *time;
};

/// A packet in memory as Embree has it, whatever its width: planes of rays, then of hits.
template <int width> struct Packet;
template <> struct Packet<16> {
    RTCRayHit16 bundle;
    void intersect(const int *valid, RTCScene scene, RTCIntersectContext *context) {
        rtcIntersect16(valid, scene, context, &bundle);
    }
    void occluded(const int *valid, RTCScene scene, RTCIntersectContext *context) {
        rtcOccluded16(valid, scene, context, &bundle.ray);
    }
};
template <> struct Packet<8> {
    RTCRayHit8 bundle;
    void intersect(const int *valid, RTCScene scene, RTCIntersectContext *context) {
        rtcIntersect8(valid, scene, context, &bundle);
    }
    void occluded(const int *valid, RTCScene scene, RTCIntersectContext *context) {
        rtcOccluded8(valid, scene, context, &bundle.ray);
    }
};
template <> struct Packet<4> {
    RTCRayHit4 bundle;
    void intersect(const int *valid, RTCScene scene, RTCIntersectContext *context) {
        rtcIntersect4(valid, scene, context, &bundle);
    }
    void occluded(const int *valid, RTCScene scene, RTCIntersectContext *context) {
        rtcOccluded4(valid, scene, context, &bundle.ray);
    }
};

/// Beyond `largest`, products of coordinates leave the range of floats.
/// valid[i] = -1 where ray i is finite, has a direction and reaches beyond its beginning. Others
/// must reach no kernel, not even masked. True if there are none.
CANDELA_HOT bool judgeRays(int count, RayPlanes from, float largest, int *__restrict valid) {
    const float *__restrict ox = from.ox, *__restrict oy = from.oy, *__restrict oz = from.oz;
    const float *__restrict dx = from.dx, *__restrict dy = from.dy, *__restrict dz = from.dz;
    const float *__restrict tMin = from.tMin, *__restrict tMax = from.tMax;
    int others = 0;
    for (int i = 0; i < count; ++i) {
        // Infinities and NaN survive the multiplication by zero as NaN.
        bool finite = (ox[i] + oy[i] + oz[i] + dx[i] + dy[i] + dz[i] + tMin[i]) * 0 == 0;
        float size = std::fabs(ox[i]) + std::fabs(oy[i]) + std::fabs(oz[i]);
        float length = std::fabs(dx[i]) + std::fabs(dy[i]) + std::fabs(dz[i]);
        bool usable = (size < largest) & (length < largest) & (length > 1 / largest);
        bool reaches = (tMin[i] >= 0) & (tMax[i] > tMin[i]);
        int sound = finite & usable & reaches;
        valid[i] = -sound;
        others |= sound ^ 1;
    }
    return others == 0;
}

/// What the ray tracer counts in.
struct RayUnits {
    float length = 1;                 ///< By which places are multiplied.
    const Shutter *shutter = nullptr; ///< Null where times do not matter.
    const std::vector<ClippingPlane> &planes;
};

/// A batch on its way into packets.
struct JudgedRays {
    JudgedRays(const RayBatch &rays, const RayUnits &units)
        : count(rays.count),
          units(units), from{rays.origin[0],    rays.origin[1],    rays.origin[2],
                             rays.direction[0], rays.direction[1], rays.direction[2],
                             rays.tMin,         rays.tMax,         rays.time} {
        if (!units.planes.empty())
            clipAll();
        thread_local Scratch<int> own;
        const int padded = paddedLanes(count);
        int *judged = own.get(padded);
        allValid = judgeRays(count, from, 1e18f / std::max(units.length, 1.0f), judged);
        std::fill(judged + count, judged + padded, 0);
        valid = judged;
    }
    const int count;
    const RayUnits units;
    RayPlanes from;
    const int *valid; ///< Up to whole blocks of lanes.
    bool allValid;

private:
    void clipAll() {
        thread_local Scratch<float> own;
        const int padded = paddedLanes(count);
        float *tMin = own.get(2 * padded), *tMax = tMin + padded;
        for (int i = 0; i < count; ++i) {
            tMin[i] = from.tMin[i], tMax[i] = from.tMax[i];
            clip(units.planes, {from.ox[i], from.oy[i], from.oz[i]},
                 {from.dx[i], from.dy[i], from.dz[i]}, tMin[i], tMax[i]);
        }
        from.tMin = tMin, from.tMax = tMax;
    }
};

/// Lanes that are not to be traced get a harmless ray that is too short.
template <int width>
void loadSome(const RayPlanes &from, int first, const int *valid, Packet<width> &packet) {
    auto &to = packet.bundle.ray;
    auto copy = [&](const float *plane, float otherwise, float *target) {
        for (int i = 0; i < width; ++i)
            target[i] = valid[i] ? plane[first + i] : otherwise;
    };
    copy(from.ox, 0, to.org_x), copy(from.oy, 0, to.org_y), copy(from.oz, 0, to.org_z);
    copy(from.dx, 1, to.dir_x), copy(from.dy, 1, to.dir_y), copy(from.dz, 1, to.dir_z);
    copy(from.tMin, 1, to.tnear), copy(from.tMax, -1, to.tfar);
}

/// Places in the ray tracer's units; t stays what it is.
template <int width> void convert(float unit, Packet<width> &packet) {
    auto &ray = packet.bundle.ray;
    for (float *plane : {ray.org_x, ray.org_y, ray.org_z, ray.dir_x, ray.dir_y, ray.dir_z})
        for (int i = 0; i < width; ++i)
            plane[i] *= unit;
}

template <int width>
void copyRays(const JudgedRays &rays, int first, Packet<width> &packet, int *valid) {
    std::memcpy(valid, rays.valid + first, width * sizeof(int));
    const RayPlanes &from = rays.from;
    if (!rays.allValid || rays.count - first < width)
        return loadSome<width>(from, first, valid, packet);
    auto &to = packet.bundle.ray;
    auto copy = [first](const float *plane, float *target) {
        std::memcpy(target, plane + first, width * sizeof(float));
    };
    copy(from.ox, to.org_x), copy(from.oy, to.org_y), copy(from.oz, to.org_z);
    copy(from.dx, to.dir_x), copy(from.dy, to.dir_y), copy(from.dz, to.dir_z);
    copy(from.tMin, to.tnear), copy(from.tMax, to.tfar);
}

/// Where something moves rays have times. Those that are too short get theirs, too.
template <int width>
void tellTimes(const JudgedRays &rays, int first, const Shutter &shutter, Packet<width> &packet) {
    const int count = std::min(width, rays.count - first);
    for (int i = 0; i < count; ++i)
        packet.bundle.ray.time[i] = shutter.share(rays.from.time[first + i]);
}

/// Fills the packet with the rays from `first` on; valid is Embree's.
template <int width>
void load(const JudgedRays &rays, int first, Packet<width> &packet, int *valid) {
    copyRays(rays, first, packet, valid);
    if (rays.units.length != 1)
        convert(rays.units.length, packet);
    if (rays.units.shutter)
        tellTimes(rays, first, *rays.units.shutter, packet);
}

/// What is the same in all packets of a call; Embree leaves it as it is.
template <int width> void prime(unsigned mask, Packet<width> &packet) {
    auto &ray = packet.bundle.ray;
    std::fill_n(ray.time, width, 0.0f);
    std::fill_n(ray.mask, width, mask);
    std::fill_n(ray.flags, width, 0u);
    for (int i = 0; i < width; ++i)
        ray.id[i] = unsigned(i);
}

template <int width> void tellKinds(const RayBatch &rays, int first, Packet<width> &packet) {
    const int count = std::min(width, rays.count - first);
    for (int i = 0; i < count; ++i)
        packet.bundle.ray.mask[i] = maskOfKinds(rays.kinds[first + i]);
}

template <int width>
void traceNearest(RTCScene scene, RTCIntersectContext &context, unsigned mask, bool tellsKinds,
                  const RayBatch &rays, const RayUnits &units, HitBatch &hits) {
    alignas(64) Packet<width> packet;
    alignas(64) int valid[width];
    prime(mask, packet);
    const JudgedRays judged(rays, units);
    auto &hit = packet.bundle.hit;
    for (int first = 0; first < rays.count; first += width) {
        load(judged, first, packet, valid);
        if (tellsKinds)
            tellKinds(rays, first, packet);
        std::fill_n(hit.geomID, width, noHit);
        std::fill_n(hit.instID[0], width, noHit);
        packet.intersect(valid, scene, &context);
        auto keep = [&](const void *from, void *to) {
            std::memcpy(static_cast<float *>(to) + first, from, width * sizeof(float));
        };
        keep(hit.geomID, hits.shape), keep(hit.primID, hits.element);
        keep(hit.instID[0], hits.instance);
        keep(packet.bundle.ray.tfar, hits.t), keep(hit.u, hits.u), keep(hit.v, hits.v);
        keep(hit.Ng_x, hits.Ng[0]), keep(hit.Ng_y, hits.Ng[1]), keep(hit.Ng_z, hits.Ng[2]);
    }
}

/// Embree tells by negative ends of rays that something stands in their way.
CANDELA_HOT void tellBlocked(int count, const int *__restrict valid, const float *__restrict end,
                             std::uint8_t *__restrict blocked) {
    for (int i = 0; i < count; ++i)
        blocked[i] = std::uint8_t(valid[i] == 0 ? 2 : end[i] < 0 ? 1 : 0);
}

template <int width>
void traceShadows(RTCScene scene, RTCIntersectContext &context, const RayBatch &rays,
                  const RayUnits &units, std::uint8_t *blocked) {
    alignas(64) Packet<width> packet;
    alignas(64) int valid[width];
    prime(opaqueBit, packet);
    const JudgedRays judged(rays, units);
    thread_local Scratch<float> own;
    float *end = own.get(paddedLanes(rays.count));
    for (int first = 0; first < rays.count; first += width) {
        load(judged, first, packet, valid);
        packet.occluded(valid, scene, &context);
        std::memcpy(end + first, packet.bundle.ray.tfar, width * sizeof(float));
    }
    tellBlocked(rays.count, judged.valid, end, blocked);
}

/// Instances carry the geometry numbers behind the world's own shapes.
CANDELA_HOT void nameInstances(int count, std::uint32_t worldShapes,
                               const std::uint32_t *__restrict firstShape,
                               std::uint32_t *__restrict instance,
                               std::uint32_t *__restrict shape) {
    for (int i = 0; i < count; ++i) {
        bool placed = instance[i] != noHit;
        std::uint32_t number = placed ? instance[i] - worldShapes : 0;
        shape[i] += placed ? firstShape[number] : 0;
        instance[i] = placed ? number : noHit;
    }
}

/// Adds the time from its making to its end. Not a thread's CPU time: to ask for that is a call of
/// the system, as long as a batch of shadow rays takes.
class Stopwatch {
public:
    explicit Stopwatch(std::atomic<std::uint64_t> &nanoseconds) : nanoseconds_(nanoseconds) {}
    ~Stopwatch() {
        const std::chrono::nanoseconds passed = Clock::now() - start_;
        nanoseconds_.fetch_add(std::uint64_t(passed.count()), std::memory_order_relaxed);
    }
    Stopwatch(const Stopwatch &) = delete;

private:
    using Clock = std::chrono::steady_clock;
    std::atomic<std::uint64_t> &nanoseconds_;
    const Clock::time_point start_ = Clock::now();
};

} // namespace

void RayShape::letGoOfElements() { positions = {}, triangles = {}, round = {}, later = {}; }

FlushDenormals::FlushDenormals() : saved_(_mm_getcsr()) {
    _mm_setcsr(saved_ | _MM_FLUSH_ZERO_ON | _MM_DENORMALS_ZERO_ON);
}

FlushDenormals::~FlushDenormals() { _mm_setcsr(saved_); }

struct RayWorld::Handles {
    EmbreeDevice device;
    RTCScene scene = nullptr;
    std::vector<RTCScene> objects;
    std::vector<std::unique_ptr<SolidTracer>> solids;
    int width = device.packetWidth();
};

/// Embree meets thin cones to within some micrometres whatever their size. So where there are tubes
/// its unit is such that they are about as wide: a power of two, which moves no triangle.
static float unitFor(const RayObject &world, std::span<const RayObject> objects) {
    double logarithms = 0, tubes = 0;
    auto add = [&](const RayObject &object) {
        for (const RayShape &shape : object)
            for (std::uint32_t first : shape.round.tubes) {
                const auto *knot = &shape.round.knots[first];
                if (const float widest = std::max(knot[0][3], knot[3][3]); widest > 0)
                    logarithms += std::log2(widest), ++tubes;
            }
    };
    add(world);
    for (const RayObject &object : objects)
        add(object);
    constexpr double most = 40; // Far from where squares leave the range of floats.
    const double power = tubes > 0 ? -std::round(logarithms / tubes) : 0;
    return float(std::exp2(std::clamp(power, -most, most)));
}

/// Geometry as SolidMember has it.
static PlacedShapes placedShapes(std::uint32_t geometry, const RayObject &world,
                                 std::span<const RayObject> objects,
                                 std::span<const RayInstance> instances) {
    if (geometry < world.size())
        return {{&world[geometry], 1}, Matrix4{}};
    const RayInstance &placed = instances[geometry - world.size()];
    return {objects[placed.object],
            placed.steps.empty() ? placed.currentFromObject : placed.steps.front()};
}

void RayWorld::numberSolids(std::span<const Solid> solids, std::size_t geometries) {
    if (solids.empty())
        return;
    solidOf_.assign(geometries, -1);
    for (std::size_t solid = 0; solid < solids.size(); ++solid)
        for (const SolidMember &member : solids[solid].members)
            solidOf_[member.geometry] = std::int32_t(solid);
}

RayWorld::RayWorld(RayObject world, std::vector<RayObject> objects,
                   std::span<const RayInstance> instances, const Shutter &shutter,
                   std::span<const Solid> solids)
    : handles_(std::make_unique<Handles>()), worldShapes_(std::uint32_t(world.size())),
      unit_(unitFor(world, objects)), shutter_(shutter) {
    FlushDenormals guard;
    auto failed = [&] { return !failure().empty(); };
    if (failed())
        return;
    const EmbreeDevice &device = handles_->device;
    unsigned mask = maskOf(world);
    const auto hides = [](const RayObject &object) {
        return std::ranges::any_of(object, [](const RayShape &s) { return s.hiddenFrom != 0; });
    };
    hidesShapes_ = hides(world) || std::ranges::any_of(objects, hides);
    const auto changes = [](const RayObject &object) {
        return std::ranges::any_of(object, &RayShape::changes);
    };
    moves_ = changes(world) || std::ranges::any_of(objects, changes) ||
             std::ranges::any_of(instances, [](const RayInstance &i) { return !i.steps.empty(); });
    const auto dissolves = [](const RayObject &object) {
        return std::ranges::any_of(object, &RayShape::isDissolved);
    };
    dissolves_ = dissolves(world) || std::ranges::any_of(objects, dissolves);
    const RayTracerUnits tracer{unit_, moves_};
    // Solids look at the elements once more.
    const auto letGo = [&](RayObject &object) {
        for (RayShape &shape : object)
            if (solids.empty())
                shape.letGoOfElements();
    };
    numberSolids(solids, world.size() + instances.size());
    std::vector<OfBodies> ofBodies(objects.size(), OfBodies::No);
    for (std::size_t i = 0; i < instances.size(); ++i)
        if (solidOf(world.size() + i) >= 0)
            ofBodies[instances[i].object] = OfBodies::Yes;
    for (std::size_t object = 0; object < objects.size(); ++object) {
        RTCScene scene = newScene(device, ofBodies[object]);
        handles_->objects.push_back(scene);
        if (failed())
            return;
        attachShapes(device, objects[object], tracer, [scene](std::size_t) { return scene; });
        letGo(objects[object]);
        rtcCommitScene(scene);
    }
    handles_->scene = newScene(device, OfBodies::No);
    std::vector<RTCScene> bodies;
    for (std::size_t solid = 0; solid < solids.size(); ++solid)
        bodies.push_back(newScene(device, OfBodies::Yes));
    if (failed())
        return;
    const auto sceneOf = [&](std::size_t geometry) {
        const std::int32_t solid = solidOf(geometry);
        return solid < 0 ? handles_->scene : bodies[std::size_t(solid)];
    };
    attachShapes(device, world, tracer, sceneOf);
    letGo(world);
    firstShapeOfInstance_.reserve(instances.size());
    for (const RayInstance &instance : instances) {
        const unsigned own = maskOf(objects[instance.object]);
        const auto geometry = worldShapes_ + unsigned(firstShapeOfInstance_.size());
        attachInstance(device, sceneOf(geometry), geometry, handles_->objects[instance.object], own,
                       instance, unit_);
        firstShapeOfInstance_.push_back(instance.firstShape);
        mask |= own;
    }
    hasTransparent_ = mask & transparentBit;
    for (std::size_t solid = 0; solid < solids.size() && !failed(); ++solid) {
        rtcCommitScene(bodies[solid]);
        std::vector<PlacedShapes> members;
        for (const SolidMember &member : solids[solid].members)
            members.push_back(placedShapes(member.geometry, world, objects, instances));
        handles_->solids.push_back(
            std::make_unique<SolidTracer>(solids[solid], bodies[solid], members, unit_));
        handles_->solids.back()->attach(device, handles_->scene);
    }
    for (std::size_t solid = handles_->solids.size(); solid < bodies.size(); ++solid)
        if (bodies[solid])
            rtcReleaseScene(bodies[solid]);
    if (!failed())
        rtcCommitScene(handles_->scene);
}

RayWorld::~RayWorld() {
    if (handles_->device.isStuck())
        return;
    if (handles_->scene)
        rtcReleaseScene(handles_->scene);
    for (RTCScene object : handles_->objects)
        if (object)
            rtcReleaseScene(object);
}

std::uint32_t RayWorld::geometryOf(std::uint32_t instance, std::uint32_t shape) const {
    return instance == noHit ? shape : worldShapes_ + instance;
}

bool RayWorld::isCut(std::uint32_t instance, std::uint32_t shape) const {
    return solidOf(geometryOf(instance, shape)) >= 0;
}

bool RayWorld::isLeftOver(std::uint32_t instance, std::uint32_t shape, Vec3 P, Vec3 normal,
                          float offset, float time) const {
    FlushDenormals guard;
    const std::uint32_t geometry = geometryOf(instance, shape);
    const SolidTracer &solid = *handles_->solids[std::size_t(solidOf(geometry))];
    const std::uint32_t first = instance == noHit ? shape : firstShapeOfInstance_[instance];
    return solid.isOnSurface(geometry, shape - first,
                             {P, normal, offset, moves_ || dissolves_ ? shutter_.share(time) : 0});
}

const std::vector<std::int32_t> &RayWorld::openNodes(std::size_t solid) const {
    return handles_->solids[solid]->openNodes();
}

std::string RayWorld::failure() const { return handles_->device.failure(); }

void RayWorld::intersect(const RayBatch &rays, HitBatch &hits, Which which, bool coherent) const {
    FlushDenormals guard;
    const Stopwatch stopwatch(nanoseconds_);
    RayContext own;
    own.fromLights = rays.fromLights;
    RTCIntersectContext &context = own.embree;
    rtcInitIntersectContext(&context);
    context.flags =
        coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
    const bool tellsKinds = which == Which::All && hidesShapes_ && rays.kinds;
    const unsigned mask =
        which == Which::All ? maskOfKinds(ray_kind::diffuse | ray_kind::specular) : transparentBit;
    RTCScene scene = handles_->scene;
    const RayUnits units{unit_, moves_ || dissolves_ ? &shutter_ : nullptr, planes_};
    switch (handles_->width) {
    case 16: traceNearest<16>(scene, context, mask, tellsKinds, rays, units, hits); break;
    case 8: traceNearest<8>(scene, context, mask, tellsKinds, rays, units, hits); break;
    default: traceNearest<4>(scene, context, mask, tellsKinds, rays, units, hits);
    }
    if (!firstShapeOfInstance_.empty())
        nameInstances(rays.count, worldShapes_, firstShapeOfInstance_.data(), hits.instance,
                      hits.shape);
}

void RayWorld::occluded(const RayBatch &rays, std::uint8_t *blocked) const {
    FlushDenormals guard;
    const Stopwatch stopwatch(nanoseconds_);
    RayContext own;
    own.fromLights = rays.fromLights;
    RTCIntersectContext &context = own.embree;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
    RTCScene scene = handles_->scene;
    const RayUnits units{unit_, moves_ || dissolves_ ? &shutter_ : nullptr, planes_};
    switch (handles_->width) {
    case 16: traceShadows<16>(scene, context, rays, units, blocked); break;
    case 8: traceShadows<8>(scene, context, rays, units, blocked); break;
    default: traceShadows<4>(scene, context, rays, units, blocked);
    }
}

} // namespace candela
