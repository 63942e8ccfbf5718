// SPDX-License-Identifier: Apache-2.0
// What Candela is measured by: a minimal path tracer on bare Embree for the diffuse benchmark
// scenes in greys. Scalar, one ray at a time, independent random numbers, no shading system. One
// lamp a vertex, chosen by power: a quadrilateral by area, a ball by the cone that it fills. A dome
// is met by rays that escape, which the cosine distributes best there is for constant radiance.
//   yardstick OUTPUT.exr [--scene NAME] [--spp N] [--seed N] [--threads N]
//   yardstick OUTPUT.rib --scene NAME --write-rib 1
#include "cornell_box.h"
#include "embree_scene.h"
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
    std::string file, scene = "cornell_grey";
    bool writesRib = false;
    int samples = 64;
    unsigned seed = 0, threads = std::max(1u, std::thread::hardware_concurrency());
};

class PathTracer {
public:
    explicit PathTracer(const SceneDescription &scene) : description_(scene), embree_(scene) {}

    /// Radiance along one path from the camera through a raster position (pixels, y down).
    float radiance(float x, float y, RandomNumbers &random) const {
        float scale = 2 / float(description_.size), extent = description_.halfExtent;
        Vec3 origin = description_.eye,
             direction = normalize({(1 - x * scale) * extent, (1 - y * scale) * extent, 1});
        float throughput = 1, sum = 0;
        for (int depth = 0; depth <= deepest; ++depth) {
            RTCRayHit hit = rayAlong(origin, direction);
            RTCIntersectContext context;
            rtcInitIntersectContext(&context);
            rtcIntersect1(embree_.scene(), &context, &hit);
            if (hit.hit.geomID == RTC_INVALID_GEOMETRY_ID)
                return sum + throughput * description_.domeRadiance;
            // Light sampling has seen to lamps already, but for the camera.
            if (hit.hit.geomID != 0)
                return depth == 0 ? description_.spheres[hit.hit.primID].radiance : sum;
            const SurfaceTriangle &surface = embree_.triangle(hit.hit.primID);
            if (surface.radiance > 0)
                return depth == 0 ? surface.radiance : sum;
            Vec3 P = origin + direction * hit.ray.tfar, n = surface.normal;
            if (dot(n, direction) > 0)
                n = -n;
            throughput *= surface.albedo;
            if (embree_.lamps() > 0)
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

    bool blocked(Vec3 P, Vec3 L, float end) const {
        RTCRay ray = rayAlong(P, L, end).ray;
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        rtcOccluded1(embree_.scene(), &context, &ray);
        return ray.tfar < 0;
    }

    /// Irradiance of the lamps over pi, from one point on one of them.
    float lampLight(Vec3 P, Vec3 n, RandomNumbers &random) const {
        float probability = 1;
        std::size_t lamp =
            embree_.lamps() > 1 ? embree_.chooseLamp(random.uniform(), probability) : 0;
        std::size_t quads = description_.quads.size();
        float light = lamp < quads ? quadLight(description_.quads[lamp], P, n, random)
                                   : sphereLight(description_.spheres[lamp - quads], P, n, random);
        return light * std::numbers::inv_pi_v<float> / probability;
    }

    float quadLight(const QuadLamp &lamp, Vec3 P, Vec3 n, RandomNumbers &random) const {
        float u = random.uniform(), v = random.uniform();
        Vec3 L = lamp.corner + lamp.edgeU * u + lamp.edgeV * v - P;
        float towards = dot(n, L), distance2 = dot(L, L);
        if (towards <= 0)
            return 0;
        // cos cos area / d^2; neither L nor the lamp's normal is of unit length.
        float form =
            towards * std::fabs(dot(cross(lamp.edgeU, lamp.edgeV), L)) / (distance2 * distance2);
        return blocked(P, L, 0.9999f) ? 0 : lamp.radiance * form;
    }

    float sphereLight(const SphereLamp &lamp, Vec3 P, Vec3 n, RandomNumbers &random) const {
        Vec3 axis = lamp.centre - P;
        float distance2 = dot(axis, axis), radius2 = lamp.radius * lamp.radius;
        if (distance2 <= radius2)
            return 0;
        float sine2 = radius2 / distance2;
        float height = sine2 / (1 + std::sqrt(1 - sine2)); // 1 - cosine, without cancellation.
        float drop = height * random.uniform(), z = 1 - drop, r = std::sqrt(drop * (2 - drop)),
              turn = 2 * std::numbers::pi_v<float> * random.uniform();
        Vec3 w = axis / std::sqrt(distance2), s, t;
        orthonormalBasis(w, s, t);
        Vec3 L = s * (r * std::cos(turn)) + t * (r * std::sin(turn)) + w * z;
        float towards = dot(n, L);
        if (towards <= 0)
            return 0;
        float along = dot(axis, L),
              reach = along - std::sqrt(std::max(0.0f, along * along - distance2 + radius2));
        return blocked(P, L, reach * 0.999f)
                   ? 0
                   : lamp.radiance * towards * 2 * std::numbers::pi_v<float> * height;
    }

    const SceneDescription &description_;
    EmbreeScene embree_;
};

std::vector<float> render(const SceneDescription &scene, const Settings &settings) {
    const int size = scene.size;
    PathTracer tracer(scene);
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
                    sum += tracer.radiance(float(x) + dx, float(y) + dy, random);
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

void write(const std::string &file, int size, const std::vector<float> &values) {
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
        if (word == "--scene" && hasValue)
            settings.scene = argv[i];
        else if (word == "--write-rib" && hasValue)
            settings.writesRib = value != 0;
        else if (word == "--spp" && value > 0)
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
        std::fprintf(stderr, "usage: yardstick OUTPUT [--scene NAME] [--spp N] [--seed N] "
                             "[--threads N] [--write-rib 1]\n");
        return 2;
    }
    candela::bench::SceneDescription scene = candela::bench::describeScene(settings.scene);
    if (settings.writesRib)
        candela::bench::writeRib(scene, settings.file);
    else
        candela::bench::write(settings.file, scene.size, candela::bench::render(scene, settings));
} catch (const std::exception &problem) {
    std::fprintf(stderr, "yardstick: %s\n", problem.what());
    return 1;
}
