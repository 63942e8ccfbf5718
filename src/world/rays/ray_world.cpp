// SPDX-License-Identifier: Apache-2.0
#include "world/rays/ray_world.h"

#include "foundation/base/hot.h"
#include "foundation/base/instruction_set.h"
#include "foundation/base/parallel.h"
#include "world/rays/native_packets.h"
#include "world/rays/sealed_triangles.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>
#include <pmmintrin.h>

namespace candela {

namespace {

constexpr int packet = laneBlock;
/// Origins and directions beyond it make Embree's kernels end the process (its FLT_LARGE).
constexpr float largest = 1.8e18f;
constexpr unsigned opaqueBit = 1, transparentBit = 2;

bool fromBehind(const RTCFilterFunctionNArguments *args, unsigned i, int frontSign) {
    unsigned n = args->N;
    float along = RTCRayN_dir_x(args->ray, n, i) * RTCHitN_Ng_x(args->hit, n, i) +
                  RTCRayN_dir_y(args->ray, n, i) * RTCHitN_Ng_y(args->hit, n, i) +
                  RTCRayN_dir_z(args->ray, n, i) * RTCHitN_Ng_z(args->hit, n, i);
    return along * float(frontSign) > 0;
}

int frontSignOf(const RTCFilterFunctionNArguments *args) {
    return int(reinterpret_cast<std::intptr_t>(args->geometryUserPtr));
}

void refuseFromBehind(const RTCFilterFunctionNArguments *args) {
    int frontSign = frontSignOf(args);
    for (unsigned i = 0; i < args->N; ++i)
        if (args->valid[i] && fromBehind(args, i, frontSign))
            args->valid[i] = 0;
}

struct RayPlanes {
    const float *ox, *oy, *oz, *dx, *dy, *dz, *tMin, *tMax;
};

/// Copies 16 rays in; valid[i] = -1 where ray i is within Embree's range, has a direction and ends
/// beyond its origin. Of the others Embree's kernels get harmless numbers: some look at them all
/// the same.
CANDELA_HOT void copyPacket(RayPlanes from, int first, RTCRay16 &__restrict out,
                            int *__restrict valid) {
    const float *ox = from.ox + first, *oy = from.oy + first, *oz = from.oz + first;
    const float *dx = from.dx + first, *dy = from.dy + first, *dz = from.dz + first;
    const float *tMin = from.tMin + first, *tMax = from.tMax + first;
    for (int i = 0; i < packet; ++i) {
        // NaN is below nothing.
        bool finite = (std::abs(ox[i]) <= largest) & (std::abs(oy[i]) <= largest) &
                      (std::abs(oz[i]) <= largest) & (std::abs(dx[i]) <= largest) &
                      (std::abs(dy[i]) <= largest) & (std::abs(dz[i]) <= largest) &
                      (tMin[i] <= largest);
        bool directed = (dx[i] != 0) | (dy[i] != 0) | (dz[i] != 0);
        const bool good = finite & directed & (tMin[i] >= 0) & (tMax[i] > tMin[i]);
        valid[i] = good ? -1 : 0;
        out.org_x[i] = good ? ox[i] : 0, out.org_y[i] = good ? oy[i] : 0;
        out.org_z[i] = good ? oz[i] : 0, out.dir_x[i] = good ? dx[i] : 0;
        out.dir_y[i] = good ? dy[i] : 0, out.dir_z[i] = good ? dz[i] : 1;
        out.tnear[i] = good ? tMin[i] : 0, out.tfar[i] = good ? tMax[i] : -1;
    }
}

/// What is the same in all packets of a call; Embree leaves it as it is.
void prime(unsigned mask, RTCRay16 &out) {
    for (int i = 0; i < packet; ++i) {
        out.time[i] = 0;
        out.mask[i] = mask, out.id[i] = unsigned(i), out.flags[i] = 0;
    }
}

void load(const RayBatch &rays, int first, RTCRay16 &out, int *valid) {
    copyPacket({rays.origin[0], rays.origin[1], rays.origin[2], rays.direction[0],
                rays.direction[1], rays.direction[2], rays.tMin, rays.tMax},
               first, out, valid);
    for (int i = std::max(rays.count - first, 0); i < packet; ++i)
        valid[i] = 0, out.tfar[i] = -1;
}

RTCDevice newDevice() {
    switch (instructionSet()) {
    case InstructionSet::V2: return rtcNewDevice("set_affinity=0,start_threads=0,isa=sse4.2");
    case InstructionSet::V3: return rtcNewDevice("set_affinity=0,start_threads=0,isa=avx2");
    case InstructionSet::V4: break;
    }
    return rtcNewDevice("set_affinity=0,start_threads=0,isa=avx512");
}

RTCGeometry makeGeometry(RTCDevice device, const RayMesh &mesh) {
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto *corners = static_cast<Vec3 *>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
                                                                RTC_FORMAT_FLOAT3, sizeof(Vec3),
                                                                3 * mesh.triangles.size()));
    auto *indices = static_cast<std::uint32_t *>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                3 * sizeof(std::uint32_t), mesh.triangles.size()));
    sealTriangles(mesh.positions, mesh.triangles, corners);
    std::iota(indices, indices + 3 * mesh.triangles.size(), 0u);
    rtcSetGeometryMask(geometry, mesh.opaque ? opaqueBit : transparentBit);
    rtcSetGeometryUserData(geometry, reinterpret_cast<void *>(std::intptr_t(mesh.frontSign)));
    // Filters more than double the time of a ray: only one-sided surfaces have them.
    if (mesh.frontSign != 0) {
        rtcSetGeometryIntersectFilterFunction(geometry, refuseFromBehind);
        rtcSetGeometryOccludedFilterFunction(geometry, refuseFromBehind);
    }
    rtcCommitGeometry(geometry);
    return geometry;
}

} // namespace

FlushDenormals::FlushDenormals() : saved_(_mm_getcsr()) {
    _mm_setcsr(saved_ | _MM_FLUSH_ZERO_ON | _MM_DENORMALS_ZERO_ON);
}

FlushDenormals::~FlushDenormals() { _mm_setcsr(saved_); }

struct RayWorld::Handles {
    RTCDevice device = nullptr;
    int width = packet; ///< Rays of a packet that its kernels take whole.
    RTCScene scene = nullptr;
};

RayWorld::RayWorld(const std::vector<RayMesh> &meshes) : handles_(std::make_unique<Handles>()) {
    handles_->device = newDevice();
    handles_->width = nativeWidth(handles_->device);
    RTCScene scene = handles_->scene = rtcNewScene(handles_->device);
    rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_MEDIUM);
    std::vector<RTCGeometry> geometries(meshes.size());
    parallelFor(meshes.size(), [&](std::size_t i) {
        FlushDenormals guard;
        if (!meshes[i].triangles.empty())
            geometries[i] = makeGeometry(handles_->device, meshes[i]);
    });
    for (std::size_t i = 0; i < meshes.size(); ++i) {
        if (!geometries[i])
            continue;
        rtcAttachGeometryByID(scene, geometries[i], unsigned(i));
        rtcReleaseGeometry(geometries[i]);
        hasTransparent_ |= !meshes[i].opaque;
    }
    FlushDenormals guard;
    rtcCommitScene(scene);
}

RayWorld::~RayWorld() {
    rtcReleaseScene(handles_->scene);
    rtcReleaseDevice(handles_->device);
}

void RayWorld::intersect(const RayBatch &rays, HitBatch &hits, Which which, bool coherent) const {
    FlushDenormals guard;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags =
        coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
    unsigned mask = which == Which::All ? opaqueBit | transparentBit : transparentBit;
    alignas(64) RTCRayHit16 bundle;
    alignas(64) int valid[packet];
    prime(mask, bundle.ray);
    std::fill_n(bundle.hit.instID[0], packet, noHit);
    for (int first = 0; first < rays.count; first += packet) {
        load(rays, first, bundle.ray, valid);
        std::fill_n(bundle.hit.geomID, packet, noHit);
        intersectPackets(handles_->width, valid, handles_->scene, context, bundle);
        std::size_t bytes = packet * sizeof(float);
        std::memcpy(hits.shape + first, bundle.hit.geomID, bytes);
        std::memcpy(hits.instance + first, bundle.hit.instID[0], bytes);
        std::memcpy(hits.Ng[0] + first, bundle.hit.Ng_x, bytes);
        std::memcpy(hits.Ng[1] + first, bundle.hit.Ng_y, bytes);
        std::memcpy(hits.Ng[2] + first, bundle.hit.Ng_z, bytes);
        std::memcpy(hits.element + first, bundle.hit.primID, bytes);
        std::memcpy(hits.t + first, bundle.ray.tfar, bytes);
        std::memcpy(hits.u + first, bundle.hit.u, bytes);
        std::memcpy(hits.v + first, bundle.hit.v, bytes);
    }
}

void RayWorld::occluded(const RayBatch &rays, std::uint8_t *blocked) const {
    FlushDenormals guard;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
    alignas(64) RTCRay16 bundle;
    alignas(64) int valid[packet];
    prime(opaqueBit, bundle);
    for (int first = 0; first < rays.count; first += packet) {
        load(rays, first, bundle, valid);
        occludedPackets(handles_->width, valid, handles_->scene, context, bundle);
        int last = std::min(packet, rays.count - first);
        for (int i = 0; i < last; ++i)
            blocked[first + i] = !valid[i] ? 2 : bundle.tfar[i] < 0 ? 1 : 0;
    }
}

} // namespace candela
