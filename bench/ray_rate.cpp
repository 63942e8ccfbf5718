// SPDX-License-Identifier: Apache-2.0
// ray_rate [threads]: rays a CPU second through Candela's ray world against bare Embree on the same
// rays: those of scene A in waves of 4096. Prints JSON; Mrays/s of a thread while all of them trace
// at once (they may share a core, as the renderer's do), the best of several rounds.
#include "cornell_box.h"
#include "world/rays/ray_world.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <functional>
#include <numeric>
#include <thread>
#include <vector>

namespace candela::bench {
namespace {

constexpr int waveSize = 4096, waves = 64, rounds = 7, packet = 16;

double cpuSeconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return double(now.tv_sec) + double(now.tv_nsec) * 1e-9;
}

void set(RayBatch &rays, int i, Vec3 origin, Vec3 direction, float end) {
    rays.origin[0][i] = origin.x, rays.origin[1][i] = origin.y, rays.origin[2][i] = origin.z;
    rays.direction[0][i] = direction.x, rays.direction[1][i] = direction.y;
    rays.direction[2][i] = direction.z, rays.tMax[i] = end, rays.time[i] = 0;
}

/// A primitive a quadrilateral, as the RIB file has it.
RayObject meshesOf(const CornellBox &box) {
    RayObject meshes;
    for (std::size_t quad = 0; quad < box.vertices.size() / 4; ++quad) {
        RayShape mesh;
        mesh.positions.assign(&box.vertices[4 * quad], &box.vertices[4 * quad] + 4);
        mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
        meshes.push_back(std::move(mesh));
    }
    return meshes;
}

/// Camera rays of 64 samples a pixel in rows of 64 pixels, then what follows from their hits.
struct Rays {
    std::vector<RayBatch> primary, bounce, shadow;

    Rays(const CornellBox &box, const RayWorld &world) {
        RandomNumbers random(1);
        HitBatch hits(waveSize);
        for (int wave = 0; wave < waves; ++wave) {
            RayBatch camera(waveSize), next(waveSize), toLamp(waveSize);
            camera.count = waveSize;
            for (int i = 0; i < waveSize; ++i) {
                float x = float(i / 64 + 64 * (wave % 8)), y = float(32 + 56 * (wave / 8));
                set(camera, i, CornellBox::eye,
                    CornellBox::cameraDirection(x + random.uniform(), y + random.uniform()),
                    INFINITY);
            }
            world.intersect(camera, hits, RayWorld::Which::All, true);
            follow(box, camera, hits, random, next, toLamp);
            primary.push_back(std::move(camera));
            bounce.push_back(std::move(next));
            shadow.push_back(std::move(toLamp));
        }
    }

private:
    static void follow(const CornellBox &box, const RayBatch &rays, const HitBatch &hits,
                       RandomNumbers &random, RayBatch &next, RayBatch &toLamp) {
        for (int i = 0; i < rays.count; ++i) {
            if (hits.shape[i] == noHit || hits.shape[i] == 0)
                continue;
            Vec3 direction{rays.direction[0][i], rays.direction[1][i], rays.direction[2][i]};
            Vec3 n = box.normals[2 * hits.shape[i]];
            n = dot(n, direction) > 0 ? -n : n;
            Vec3 P = CornellBox::eye + direction * hits.t[i] + n * 1e-4f;
            set(next, next.count++, P, cosineDirection(n, random), INFINITY);
            Vec3 L = Vec3{std::lerp(CornellBox::lampX0, CornellBox::lampX1, random.uniform()),
                          CornellBox::lampY,
                          std::lerp(CornellBox::lampZ0, CornellBox::lampZ1, random.uniform())} -
                     P;
            if (dot(L, n) > 0)
                set(toLamp, toLamp.count++, P, L, .999f);
        }
    }
};

/// The same rays straight into Embree: packets without filters, masks or hits written back.
class BareEmbree {
public:
    explicit BareEmbree(const CornellBox &box) : device_(rtcNewDevice(nullptr)) {
        scene_ = box.commit(device_);
    }
    ~BareEmbree() {
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }
    void packets(const RayBatch &rays, bool coherent, bool occlusion) const {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        if (coherent)
            context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
        alignas(64) RTCRayHit16 hit;
        alignas(64) int valid[packet];
        for (int first = 0; first < rays.count; first += packet) {
            load(rays, first, hit, valid);
            if (occlusion)
                rtcOccluded16(valid, scene_, &context, &hit.ray);
            else
                rtcIntersect16(valid, scene_, &context, &hit);
        }
    }

private:
    static void load(const RayBatch &rays, int first, RTCRayHit16 &hit, int *valid) {
        auto copy = [first](float *to, const float *from) {
            std::memcpy(to, from + first, packet * sizeof(float));
        };
        RTCRay16 &ray = hit.ray;
        copy(ray.org_x, rays.origin[0]), copy(ray.org_y, rays.origin[1]);
        copy(ray.org_z, rays.origin[2]), copy(ray.dir_x, rays.direction[0]);
        copy(ray.dir_y, rays.direction[1]), copy(ray.dir_z, rays.direction[2]);
        copy(ray.tfar, rays.tMax);
        for (int i = 0; i < packet; ++i) {
            valid[i] = first + i < rays.count ? -1 : 0;
            ray.tnear[i] = ray.time[i] = 0;
            ray.mask[i] = ~0u, ray.id[i] = 0, ray.flags[i] = 0;
            hit.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
        }
    }
    RTCDevice device_;
    RTCScene scene_;
};

/// CPU seconds of all threads together, each tracing all batches.
double secondsOfRound(int threads, const std::vector<RayBatch> &batches,
                      const std::function<void(const RayBatch &)> &trace) {
    std::vector<double> seconds(threads);
    std::vector<std::jthread> running;
    for (double &own : seconds)
        running.emplace_back([&] {
            FlushDenormals flush;
            const double start = cpuSeconds();
            std::ranges::for_each(batches, trace);
            own = cpuSeconds() - start;
        });
    running.clear();
    return std::accumulate(seconds.begin(), seconds.end(), 0.0);
}

double bestRate(int threads, const std::vector<RayBatch> &batches,
                const std::function<void(const RayBatch &)> &trace) {
    double rays = 0, best = 0;
    for (const RayBatch &batch : batches)
        rays += batch.count;
    for (int round = 0; round < rounds; ++round)
        best = std::max(best, threads * rays / secondsOfRound(threads, batches, trace) * 1e-6);
    return best;
}

void measure(int threads) {
    CornellBox box;
    RayWorld world(meshesOf(box));
    FlushDenormals flush;
    Rays rays(box, world);
    BareEmbree bare(box);
    auto intersect = [&](bool coherent) {
        return [&, coherent](const RayBatch &batch) {
            thread_local HitBatch hits(waveSize);
            world.intersect(batch, hits, RayWorld::Which::All, coherent);
        };
    };
    auto print = [&](const char *name, const std::vector<RayBatch> &batches,
                     const std::function<void(const RayBatch &)> &ours, bool coherent,
                     bool occlusion, const char *end) {
        double candela = bestRate(threads, batches, ours);
        double embree = bestRate(threads, batches, [&](const RayBatch &batch) {
            bare.packets(batch, coherent, occlusion);
        });
        std::printf("  \"%s\": {\"candela\": %.4g, \"embree\": %.4g}%s\n", name, candela, embree,
                    end);
    };
    std::printf("{\n");
    print("primary", rays.primary, intersect(true), true, false, ",");
    print("bounce", rays.bounce, intersect(false), false, false, ",");
    print(
        "shadow", rays.shadow,
        [&](const RayBatch &batch) {
            thread_local std::vector<std::uint8_t> blocked(waveSize);
            world.occluded(batch, blocked.data());
        },
        false, true, "");
    std::printf("}\n");
}

} // namespace
} // namespace candela::bench

int main(int count, char **words) {
    candela::bench::measure(count > 1 ? std::max(1, std::atoi(words[1])) : 1);
}
