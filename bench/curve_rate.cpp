// SPDX-License-Identifier: Apache-2.0
// curve_rate write FILE COUNT SLENDERNESS: a ball with so many hairs, cubic tubes, as binary RIB.
// curve_rate bare COUNT SLENDERNESS THREADS: the same hairs in bare Embree, seen by as many camera
// rays as the RIB asks for at 4 samples a pixel. Prints JSON: seconds to the first ray, of all
// threads with rays, and the most memory that the process has had. Slenderness is the length of a
// hair over its radius at the root.
#include "interface/rib/rib_writer.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <embree3/rtcore.h>
#include <random>
#include <sys/resource.h>
#include <thread>
#include <vector>

namespace candela::bench {
namespace {

constexpr float hairLength = .3f, eyeDistance = 4, fieldOfView = 36;
constexpr int side = 512, samples = 4, packet = 16;

using Clock = std::chrono::steady_clock;
double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Bezier points of the hairs, x, y, z one after the other.
Floats hairs(int count) {
    std::mt19937 random(1);
    const auto within = [&](float low, float high) {
        return low + (high - low) * float(random() >> 8) * 0x1p-24f;
    };
    Floats points;
    points.reserve(std::size_t(count) * 12);
    for (int i = 0; i < count; ++i) {
        const float z = within(-1, 1), around = within(0, 6.2831853f);
        const float r = std::sqrt(1 - z * z);
        const float root[] = {r * std::cos(around), r * std::sin(around), z};
        const float bend[] = {within(-.05f, .05f), within(-.05f, .05f), within(-.05f, .05f)};
        for (int k = 0; k < 4; ++k) {
            const float along = float(k) / 3;
            for (int c = 0; c < 3; ++c)
                points.push_back(root[c] * (1 + along * hairLength) + bend[c] * along * along * 2);
        }
    }
    return points;
}

void write(const char *file, int count, float slenderness) {
    std::string rib;
    const auto output = ByteOutput::toMemory(rib);
    {
        RibWriter writer(*output, RibEncoding::Binary);
        writer.format({}, side, side, 1);
        writer.pixelSamples({}, std::sqrt(float(samples)), std::sqrt(float(samples)));
        writer.pixelFilter({}, "box", 1, 1);
        writer.display({}, "hairs.exr", "openexr", "rgb", {});
        writer.projection({}, "perspective", {{{"fov", {}, {fieldOfView}, {}}}});
        writer.translate({}, 0, 0, eyeDistance);
        writer.worldBegin({});
        writer.surface({}, "constant", {});
        const float width = 2 * hairLength / slenderness;
        Floats widths;
        for (int i = 0; i < count; ++i)
            widths.insert(widths.end(), {width, width / 2});
        writer.basis({}, "bezier", 3, "bezier", 3);
        writer.curves({}, "cubic", Integers(std::size_t(count), 4), "nonperiodic",
                      {{{"P", {}, hairs(count), {}}, {"width", {}, std::move(widths), {}}}});
        writer.worldEnd({});
    }
    std::FILE *const to = std::fopen(file, "wb");
    if (!to || std::fwrite(rib.data(), 1, rib.size(), to) != rib.size() || std::fclose(to) != 0)
        std::exit(1);
}

RTCGeometry geometryOf(RTCDevice device, int count, float slenderness) {
    const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_ROUND_BEZIER_CURVE);
    auto *const knots = static_cast<float *>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, 16, 4 * std::size_t(count)));
    auto *const firsts = static_cast<unsigned *>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT, 4, std::size_t(count)));
    const Floats points = hairs(count);
    const float radius = hairLength / slenderness;
    for (std::size_t knot = 0; knot < 4 * std::size_t(count); ++knot) {
        std::copy_n(&points[3 * knot], 3, knots + 4 * knot);
        knots[4 * knot + 3] = radius * (1 - .5f * float(knot % 4) / 3);
    }
    for (int i = 0; i < count; ++i)
        firsts[i] = 4 * unsigned(i);
    rtcCommitGeometry(geometry);
    return geometry;
}

/// Rays through the rows of one thread, a packet of neighbours at a time; gives how many have met
/// something.
std::size_t trace(RTCScene scene, int first, int step) {
    const float half = std::tan(fieldOfView / 2 * 3.14159265f / 180);
    std::mt19937 random{unsigned(first)};
    std::size_t met = 0;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    alignas(64) RTCRayHit16 rays;
    alignas(64) int valid[packet];
    std::fill_n(valid, packet, -1);
    for (int row = first; row < side; row += step)
        for (int at = 0; at < side * samples; at += packet) {
            for (int i = 0; i < packet; ++i) {
                const auto within = [&] { return float(random() >> 8) * 0x1p-24f; };
                const float x = float((at + i) / samples) + within(), y = float(row) + within();
                rays.ray.org_x[i] = rays.ray.org_y[i] = 0, rays.ray.org_z[i] = -eyeDistance;
                rays.ray.dir_x[i] = (2 * x / side - 1) * half;
                rays.ray.dir_y[i] = (1 - 2 * y / side) * half, rays.ray.dir_z[i] = 1;
                rays.ray.tnear[i] = 0, rays.ray.tfar[i] = INFINITY, rays.ray.time[i] = 0;
                rays.ray.mask[i] = ~0u, rays.ray.flags[i] = 0;
                rays.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
                rays.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
            }
            rtcIntersect16(valid, scene, &context, &rays);
            for (int i = 0; i < packet; ++i)
                met += rays.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID;
        }
    return met;
}

void measureBare(int count, float slenderness, int threads) {
    const Clock::time_point start = Clock::now();
    const RTCDevice device = rtcNewDevice(("threads=" + std::to_string(threads)).c_str());
    const RTCScene scene = rtcNewScene(device);
    const RTCGeometry geometry = geometryOf(device, count, slenderness);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene);
    const double startSeconds = secondsSince(start);

    std::vector<double> seconds(std::size_t(threads), 0);
    std::vector<std::size_t> met(std::size_t(threads), 0);
    std::vector<std::thread> workers;
    for (int t = 0; t < threads; ++t)
        workers.emplace_back([&, t] {
            const Clock::time_point begin = Clock::now();
            met[std::size_t(t)] = trace(scene, t, threads);
            seconds[std::size_t(t)] = secondsSince(begin);
        });
    double sum = 0;
    std::size_t hits = 0;
    for (int t = 0; t < threads; ++t) {
        workers[std::size_t(t)].join();
        sum += seconds[std::size_t(t)], hits += met[std::size_t(t)];
    }
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    std::printf("{\"startSeconds\": %.6g, \"raySeconds\": %.6g, \"rays\": %d, \"hits\": %zu, "
                "\"peakBytes\": %.0f}\n",
                startSeconds, sum, side * side * samples, hits, double(usage.ru_maxrss) * 1024);
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
}

} // namespace
} // namespace candela::bench

int main(int count, char **words) {
    using namespace candela::bench;
    if (count == 5 && std::strcmp(words[1], "write") == 0)
        write(words[2], std::atoi(words[3]), float(std::atof(words[4])));
    else if (count == 5 && std::strcmp(words[1], "bare") == 0)
        measureBare(std::atoi(words[2]), float(std::atof(words[3])), std::atoi(words[4]));
    else
        return std::fputs("usage: curve_rate write FILE COUNT SLENDERNESS\n"
                          "       curve_rate bare COUNT SLENDERNESS THREADS\n",
                          stderr),
               2;
}
