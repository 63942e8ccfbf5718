// SPDX-License-Identifier: Apache-2.0
#include "world/rays/embree_scene.h"

#include "foundation/base/instruction_set.h"
#include "foundation/base/parallel.h"
#include "world/rays/sealed_triangles.h"

#include <algorithm>
#include <functional>
#include <numeric>

namespace candela {

namespace {

/// What the filter of a shape must know, as the user pointer of its geometry.
struct Refusal {
    int frontSign;
    bool moves;
    float from, until; ///< RayShape::presentFrom and presentUntil, to 24 bits.

    static void *pack(const RayShape &shape, bool moves) {
        static_assert(sizeof(void *) == 8);
        const auto bits = [](float share) { return std::uint64_t(share * float(1 << 24)); };
        return reinterpret_cast<void *>(std::uint64_t(shape.frontSign + 1) |
                                        std::uint64_t(moves) << 2 | bits(shape.presentFrom) << 8 |
                                        bits(shape.presentUntil) << 36);
    }
    static Refusal unpack(const void *packed) {
        const auto value = reinterpret_cast<std::uint64_t>(packed);
        const auto share = [&](int at) { return float(value >> at & 0x1ffffff) * 0x1p-24f; };
        return {int(value & 3) - 1, (value >> 2 & 1) != 0, share(8), share(36)};
    }
    bool isAbsent(float share) const {
        const float choice = choiceOf(share, moves);
        return !(choice >= from && choice < until);
    }
};

bool fromBehind(const RTCFilterFunctionNArguments *args, unsigned i, int frontSign) {
    unsigned n = args->N;
    float along = RTCRayN_dir_x(args->ray, n, i) * RTCHitN_Ng_x(args->hit, n, i) +
                  RTCRayN_dir_y(args->ray, n, i) * RTCHitN_Ng_y(args->hit, n, i) +
                  RTCRayN_dir_z(args->ray, n, i) * RTCHitN_Ng_z(args->hit, n, i);
    return along * float(frontSign) > 0;
}

const RayContext &contextOf(const RTCFilterFunctionNArguments *args) {
    return *reinterpret_cast<const RayContext *>(args->context);
}

void refuseAnyFromBehind(const RTCFilterFunctionNArguments *args) {
    if (contextOf(args).collects)
        return;
    const int frontSign = Refusal::unpack(args->geometryUserPtr).frontSign;
    for (unsigned i = 0; i < args->N; ++i)
        if (args->valid[i] && fromBehind(args, i, frontSign))
            args->valid[i] = 0;
}

/// Rays from lights run against the eye's, and are stopped on both sides.
void refuseSeenFromBehind(const RTCFilterFunctionNArguments *args) {
    if (!contextOf(args).fromLights)
        refuseAnyFromBehind(args);
}

void refuseWhereAbsent(const RTCFilterFunctionNArguments *args) {
    const Refusal refusal = Refusal::unpack(args->geometryUserPtr);
    for (unsigned i = 0; i < args->N; ++i)
        if (args->valid[i] && refusal.isAbsent(RTCRayN_time(args->ray, args->N, i)))
            args->valid[i] = 0;
}

/// Both of what two filters refuse.
template <RTCFilterFunctionN other> void refuseOrAbsent(const RTCFilterFunctionNArguments *args) {
    refuseWhereAbsent(args);
    other(args);
}

RTCFilterFunctionN filterOf(const RayShape &shape) {
    if (shape.frontSign == 0)
        return shape.isDissolved() ? refuseWhereAbsent : nullptr;
    if (shape.isDissolved())
        return shape.isStroke ? refuseOrAbsent<refuseAnyFromBehind>
                              : refuseOrAbsent<refuseSeenFromBehind>;
    return shape.isStroke ? refuseAnyFromBehind : refuseSeenFromBehind;
}

RTCGeometry makeTriangles(RTCDevice device, const RayShape &shape, float unit) {
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    const std::size_t count = shape.triangles.size();
    if (!geometry)
        return nullptr;
    rtcSetGeometryTimeStepCount(geometry, unsigned(1 + shape.later.size()));
    for (std::size_t step = 0; step <= shape.later.size(); ++step) {
        auto *corners = static_cast<Vec3 *>(
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, unsigned(step),
                                    RTC_FORMAT_FLOAT3, sizeof(Vec3), 3 * count));
        if (!corners) // The device has been told of it.
            return geometry;
        sealTriangles(step == 0 ? shape.positions : shape.later[step - 1], shape.triangles,
                      corners);
        if (unit != 1)
            std::for_each_n(corners, 3 * count, [unit](Vec3 &corner) { corner *= unit; });
    }
    auto *indices = static_cast<std::uint32_t *>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), count));
    if (!indices)
        return geometry;
    std::iota(indices, indices + 3 * count, 0u);
    return geometry;
}

/// Copies what is made of the values into a buffer of the geometry's own.
template <class Value, class Made>
void fillBuffer(RTCGeometry geometry, RTCBufferType type, unsigned slot, RTCFormat format,
                const std::vector<Value> &values, Made made) {
    auto *to = static_cast<Value *>(
        rtcSetNewGeometryBuffer(geometry, type, slot, format, sizeof(Value), values.size()));
    if (to) // Else the device has been told of it.
        std::ranges::transform(values, to, made);
}

RTCGeometry makeRound(RTCDevice device, const RoundElements &round, float unit) {
    const bool areTubes = !round.tubes.empty();
    RTCGeometry geometry = rtcNewGeometry(device, areTubes ? RTC_GEOMETRY_TYPE_ROUND_BEZIER_CURVE
                                                           : RTC_GEOMETRY_TYPE_SPHERE_POINT);
    if (!geometry)
        return nullptr;
    rtcSetGeometryTimeStepCount(geometry, unsigned(1 + round.later.size()));
    unsigned step = 0;
    round.forSteps([&](const std::vector<std::array<float, 4>> &knots) {
        fillBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, step++, RTC_FORMAT_FLOAT4, knots,
                   [unit](std::array<float, 4> knot) {
                       for (float &value : knot)
                           value *= unit;
                       return knot;
                   });
    });
    if (areTubes)
        fillBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT, round.tubes,
                   std::identity());
    return geometry;
}

RTCGeometry makeGeometry(RTCDevice device, const RayShape &shape, const RayTracerUnits &units) {
    RTCGeometry geometry = shape.round.size() > 0 ? makeRound(device, shape.round, units.length)
                                                  : makeTriangles(device, shape, units.length);
    if (!geometry)
        return nullptr;
    rtcSetGeometryMask(geometry, maskOf(shape));
    rtcSetGeometryUserData(geometry, Refusal::pack(shape, units.moves));
    // Filters more than double the time of a ray: only one-sided and dissolved surfaces have them.
    if (const RTCFilterFunctionN refuse = filterOf(shape)) {
        rtcSetGeometryIntersectFilterFunction(geometry, refuse);
        rtcSetGeometryOccludedFilterFunction(geometry, refuse);
    }
    rtcCommitGeometry(geometry);
    return geometry;
}

} // namespace

/// Kernels of the instruction set in force, and no others.
static RTCDevice newDevice() {
    switch (instructionSet()) {
    case InstructionSet::V2: return rtcNewDevice("set_affinity=0,start_threads=0,isa=sse4.2");
    case InstructionSet::V3: return rtcNewDevice("set_affinity=0,start_threads=0,isa=avx2");
    case InstructionSet::V4: break;
    }
    return rtcNewDevice("set_affinity=0,start_threads=0,isa=avx512");
}

EmbreeDevice::EmbreeDevice() : device_(newDevice()) {
    if (device_)
        rtcSetDeviceErrorFunction(device_, takeError, this);
    else
        takeError(this, rtcGetDeviceError(nullptr), nullptr);
}

EmbreeDevice::~EmbreeDevice() {
    if (device_ && !isStuck_)
        rtcReleaseDevice(device_);
}

void EmbreeDevice::takeError(void *self, RTCError error, const char *text) {
    auto *device = static_cast<EmbreeDevice *>(self);
    if (!device->failure_.empty())
        return;
    device->isStuck_ = error == RTC_ERROR_UNKNOWN;
    device->failure_ = error == RTC_ERROR_OUT_OF_MEMORY
                           ? "there is not enough memory for what rays are to meet"
                           : "the ray tracer reports: " + std::string(text ? text : "an error");
}

int EmbreeDevice::packetWidth() const {
    if (!device_)
        return 4;
    if (rtcGetDeviceProperty(device_, RTC_DEVICE_PROPERTY_NATIVE_RAY16_SUPPORTED))
        return 16;
    return rtcGetDeviceProperty(device_, RTC_DEVICE_PROPERTY_NATIVE_RAY8_SUPPORTED) ? 8 : 4;
}

unsigned maskOf(const RayShape &shape) {
    const unsigned seen = bodyBit | maskOfKinds(std::uint8_t(allKinds & ~shape.hiddenFrom));
    return !shape.stopsLight ? seen : seen | (shape.opaque ? opaqueBit : transparentBit);
}

unsigned maskOf(const RayObject &object) {
    unsigned mask = 0;
    for (const RayShape &shape : object)
        mask |= maskOf(shape);
    return mask;
}

RTCScene newScene(const EmbreeDevice &device, OfBodies ofBodies) {
    RTCScene scene = rtcNewScene(device.get());
    if (!scene) // The device has been told of it.
        return nullptr;
    rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_MEDIUM);
    if (ofBodies == OfBodies::Yes)
        rtcSetSceneFlags(scene, RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION);
    return scene;
}

void attachShapes(const EmbreeDevice &device, const RayObject &object, const RayTracerUnits &units,
                  const std::function<RTCScene(std::size_t)> &sceneOf) {
    std::vector<RTCGeometry> geometries(object.size());
    parallelFor(object.size(), [&](std::size_t i) {
        FlushDenormals guard;
        if (!object[i].empty())
            geometries[i] = makeGeometry(device.get(), object[i], units);
    });
    for (std::size_t i = 0; i < geometries.size(); ++i)
        if (geometries[i]) {
            rtcAttachGeometryByID(sceneOf(i), geometries[i], unsigned(i));
            rtcReleaseGeometry(geometries[i]);
        }
}

void attachInstance(const EmbreeDevice &device, RTCScene world, unsigned id, RTCScene object,
                    unsigned mask, const RayInstance &placed, float unit) {
    RTCGeometry geometry = rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_INSTANCE);
    if (!geometry)
        return;
    rtcSetGeometryInstancedScene(geometry, object);
    rtcSetGeometryMask(geometry, mask);
    const std::span<const Matrix4> steps =
        placed.steps.empty() ? std::span(&placed.currentFromObject, 1) : placed.steps;
    rtcSetGeometryTimeStepCount(geometry, unsigned(steps.size()));
    // Rows of ours are the columns of theirs: points are row vectors here.
    for (std::size_t step = 0; step < steps.size(); ++step) {
        Matrix4 matrix = steps[step];
        for (int axis = 0; axis < 3; ++axis)
            matrix.m[12 + axis] *= unit;
        rtcSetGeometryTransform(geometry, unsigned(step), RTC_FORMAT_FLOAT4X4_COLUMN_MAJOR,
                                matrix.m.data());
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(world, geometry, id);
    rtcReleaseGeometry(geometry);
}

} // namespace candela
