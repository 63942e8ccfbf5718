// SPDX-License-Identifier: Apache-2.0
// What Candela is measured by: a minimal path tracer on bare Embree for scene A in greys. Scalar,
// one ray at a time, light sampling only, independent random numbers, no shading system.
//   yardstick OUTPUT.exr [--spp N] [--seed N] [--threads N]
#include "cornell_box.h"
#include "image/exr_file.h"

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <pmmintrin.h>
#include <stdexcept>
#include <string>
#include <thread>

namespace candela::bench {
namespace {

constexpr int deepest = 64, rouletteDepth = 3;
constexpr float rayStart = 1e-4f;

struct Settings {
    std::string file;
    int samples = 64;
    unsigned seed = 0, threads = std::max(1u, std::thread::hardware_concurrency());
};

class PathTracer {
public:
    explicit PathTracer(const CornellBox &box) : box_(box), device_(rtcNewDevice(nullptr)) {
        scene_ = box.commit(device_);
    }
    ~PathTracer() {
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }

    /// Radiance along one path from the camera.
    float radiance(Vec3 direction, RandomNumbers &random) const {
        Vec3 origin = CornellBox::eye;
        float throughput = 1, sum = 0;
        for (int depth = 0; depth <= deepest; ++depth) {
            RTCRayHit hit = rayAlong(origin, direction);
            RTCIntersectContext context;
            rtcInitIntersectContext(&context);
            rtcIntersect1(scene_, &context, &hit);
            if (hit.hit.geomID == RTC_INVALID_GEOMETRY_ID)
                break;
            std::uint32_t triangle = hit.hit.primID;
            if (triangle < CornellBox::lampTriangles)
                // Light sampling has seen to it already, but for the camera.
                return depth == 0 ? CornellBox::lampRadiance : sum;
            Vec3 P = origin + direction * hit.ray.tfar, n = box_.normals[triangle];
            if (dot(n, direction) > 0)
                n = -n;
            throughput *= box_.albedos[triangle];
            sum += throughput * lampLight(P, n, random);
            if (depth + 1 >= rouletteDepth) {
                float survival = std::sqrt(throughput);
                if (random.uniform() >= survival)
                    break;
                throughput /= survival;
            }
            origin = P;
            direction = cosineDirection(n, random);
        }
        return sum;
    }

private:
    static RTCRayHit rayAlong(Vec3 origin, Vec3 direction, float end = INFINITY) {
        RTCRayHit hit;
        hit.ray.org_x = origin.x, hit.ray.org_y = origin.y, hit.ray.org_z = origin.z;
        hit.ray.dir_x = direction.x, hit.ray.dir_y = direction.y, hit.ray.dir_z = direction.z;
        hit.ray.tnear = rayStart, hit.ray.tfar = end;
        hit.ray.time = 0, hit.ray.mask = ~0u, hit.ray.id = 0, hit.ray.flags = 0;
        hit.hit.geomID = hit.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
        return hit;
    }

    /// Irradiance of the lamp over pi, from one point on it.
    float lampLight(Vec3 P, Vec3 n, RandomNumbers &random) const {
        Vec3 on{std::lerp(CornellBox::lampX0, CornellBox::lampX1, random.uniform()),
                CornellBox::lampY,
                std::lerp(CornellBox::lampZ0, CornellBox::lampZ1, random.uniform())};
        Vec3 L = on - P;
        float towards = dot(n, L), distance2 = dot(L, L);
        if (towards <= 0)
            return 0;
        // cos cos / d^2, L not being of unit length.
        float form = towards * std::fabs(L.y) / (distance2 * distance2);
        RTCRay ray = rayAlong(P, L, 0.9999f).ray;
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        rtcOccluded1(scene_, &context, &ray);
        bool blocked = ray.tfar < 0;
        return blocked ? 0
                       : CornellBox::lampRadiance * CornellBox::lampArea * form *
                             std::numbers::inv_pi_v<float>;
    }

    const CornellBox &box_;
    RTCDevice device_;
    RTCScene scene_;
};

std::vector<float> render(const Settings &settings) {
    constexpr int size = CornellBox::size;
    CornellBox box;
    PathTracer tracer(box);
    std::vector<float> picture(size * size);
    std::atomic<int> nextRow = 0;
    auto work = [&] {
        _mm_setcsr(_mm_getcsr() | _MM_FLUSH_ZERO_ON | _MM_DENORMALS_ZERO_ON);
        for (int y; (y = nextRow++) < size;)
            for (int x = 0; x < size; ++x) {
                RandomNumbers random((std::uint64_t(settings.seed) << 32) + y * size + x);
                double sum = 0;
                for (int sample = 0; sample < settings.samples; ++sample) {
                    float dx = random.uniform(), dy = random.uniform();
                    sum += tracer.radiance(
                        CornellBox::cameraDirection(float(x) + dx, float(y) + dy), random);
                }
                picture[y * size + x] = float(sum / settings.samples);
            }
    };
    std::vector<std::jthread> others;
    for (unsigned thread = 1; thread < settings.threads; ++thread)
        others.emplace_back(work);
    work();
    others.clear(); // Waits for them.
    return picture;
}

void write(const std::string &file, const std::vector<float> &values) {
    constexpr int size = CornellBox::size;
    Picture picture;
    picture.window = {size, size, 0, size, 0, size};
    for (const char *channel : {"R", "G", "B"})
        picture.channels.push_back({channel, values});
    std::string problem;
    auto bytes = encodeExr(picture, problem);
    if (!bytes)
        throw std::runtime_error(problem);
    std::ofstream stream(file, std::ios::binary);
    stream.write(reinterpret_cast<const char *>(bytes->data()), std::streamsize(bytes->size()));
    if (!stream.flush())
        throw std::runtime_error("cannot write " + file);
}

bool parse(int argc, char **argv, Settings &settings) {
    for (int i = 1; i < argc; ++i) {
        std::string word = argv[i];
        bool hasValue = i + 1 < argc && word.starts_with("--");
        int value = hasValue ? std::atoi(argv[++i]) : 0;
        if (word == "--spp" && value > 0)
            settings.samples = value;
        else if (word == "--seed" && hasValue)
            settings.seed = unsigned(value);
        else if (word == "--threads" && value > 0)
            settings.threads = unsigned(value);
        else if (!word.starts_with("--") && settings.file.empty())
            settings.file = word;
        else
            return false;
    }
    return !settings.file.empty();
}

} // namespace
} // namespace candela::bench

int main(int argc, char **argv) try {
    candela::bench::Settings settings;
    if (!candela::bench::parse(argc, argv, settings)) {
        std::fprintf(stderr, "usage: yardstick OUTPUT.exr [--spp N] [--seed N] [--threads N]\n");
        return 2;
    }
    std::vector<float> picture = candela::bench::render(settings);
    candela::bench::write(settings.file, picture);
} catch (const std::exception &problem) {
    std::fprintf(stderr, "yardstick: %s\n", problem.what());
    return 1;
}
