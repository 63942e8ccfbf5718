// SPDX-License-Identifier: Apache-2.0
// Benchmark scene A in greys for programs on bare Embree: the numbers of scenes/cornell_grey.rib.
#pragma once

#include "foundation/base/vec3.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <embree3/rtcore.h>
#include <numbers>
#include <vector>

namespace candela::bench {

struct CornellBox {
    static constexpr int size = 512; ///< Pixels, both ways.
    static constexpr Vec3 eye{2.78f, 2.73f, -8.0f};
    static constexpr float halfExtent = 12.5f / 35; ///< Of the picture, at a distance of 1.
    static constexpr float lampX0 = 2.13f, lampX1 = 3.43f, lampY = 5.488f, lampZ0 = 2.27f,
                           lampZ1 = 3.32f, lampArea = (lampX1 - lampX0) * (lampZ1 - lampZ0);
    static constexpr float lampRadiance = 15;

    std::vector<Vec3> vertices;                       ///< Four a quadrilateral; two triangles each.
    std::vector<float> albedos;                       ///< Of each triangle.
    std::vector<Vec3> normals;                        ///< Unit, of each triangle.
    std::vector<std::uint32_t> indices;               ///< Three a triangle.
    static constexpr std::uint32_t lampTriangles = 2; ///< The first two; they reflect nothing.

    CornellBox() {
        constexpr float W = 5.56f, H = 5.488f, D = 5.592f, white = .73f;
        add(0, {lampX0, H, lampZ0}, {lampX1, H, lampZ0}, {lampX1, H, lampZ1}, {lampX0, H, lampZ1});
        add(white, {0, 0, 0}, {W, 0, 0}, {W, 0, D}, {0, 0, D});
        add(white, {0, 0, D}, {W, 0, D}, {W, H, D}, {0, H, D});
        add(white, {0, H, 0}, {W, H, 0}, {W, H, lampZ0}, {0, H, lampZ0});
        add(white, {0, H, lampZ1}, {W, H, lampZ1}, {W, H, D}, {0, H, D});
        add(white, {0, H, lampZ0}, {lampX0, H, lampZ0}, {lampX0, H, lampZ1}, {0, H, lampZ1});
        add(white, {lampX1, H, lampZ0}, {W, H, lampZ0}, {W, H, lampZ1}, {lampX1, H, lampZ1});
        add(.25f, {W, 0, 0}, {W, 0, D}, {W, H, D}, {W, H, 0});
        add(.40f, {0, 0, 0}, {0, 0, D}, {0, H, D}, {0, H, 0});
        addBlock({Vec3{1.30f, 1.65f, .65f},
                  {.82f, 1.65f, 2.25f},
                  {2.40f, 1.65f, 2.72f},
                  {2.90f, 1.65f, 1.14f}});
        addBlock({Vec3{4.23f, 3.30f, 2.47f},
                  {2.65f, 3.30f, 2.96f},
                  {3.14f, 3.30f, 4.56f},
                  {4.72f, 3.30f, 4.06f}});
    }

    /// The unit direction of the camera's ray through a raster position (pixels, y down).
    static Vec3 cameraDirection(float x, float y) {
        // The world is right-handed: what is right in the picture is -x.
        float right = (2 * x / size - 1) * halfExtent, up = (1 - 2 * y / size) * halfExtent;
        return normalize({-right, up, 1});
    }

    RTCScene commit(RTCDevice device) const {
        RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
        auto *points = static_cast<Vec3 *>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(Vec3), vertices.size()));
        auto *corners = static_cast<std::uint32_t *>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, indices.size() / 3));
        std::copy(vertices.begin(), vertices.end(), points);
        std::copy(indices.begin(), indices.end(), corners);
        rtcCommitGeometry(geometry);
        RTCScene scene = rtcNewScene(device);
        rtcAttachGeometry(scene, geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(scene);
        return scene;
    }

private:
    void add(float albedo, Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
        auto first = std::uint32_t(vertices.size());
        vertices.insert(vertices.end(), {a, b, c, d});
        for (std::uint32_t corner : {0, 1, 2, 0, 2, 3})
            indices.push_back(first + corner);
        for (int triangle = 0; triangle < 2; ++triangle) {
            albedos.push_back(albedo);
            normals.push_back(normalize(cross(b - a, c - a)));
        }
    }

    void addBlock(const std::array<Vec3, 4> &top) {
        add(.73f, top[0], top[1], top[2], top[3]);
        for (int i = 0; i < 4; ++i) {
            Vec3 a = top[i], b = top[(i + 1) % 4];
            add(.73f, a, {a.x, 0, a.z}, {b.x, 0, b.z}, b);
        }
    }
};

/// Independent random numbers: PCG32 (O'Neill 2014).
class RandomNumbers {
public:
    explicit RandomNumbers(std::uint64_t stream) : increment_(2 * stream + 1) {
        next();
        state_ += 0x9e3779b97f4a7c15u;
        next();
    }
    /// Uniform in [0, 1).
    float uniform() { return float(next() >> 8) * 0x1p-24f; }

private:
    std::uint32_t next() {
        std::uint64_t old = state_;
        state_ = old * 6364136223846793005u + increment_;
        auto mixed = std::uint32_t(((old >> 18) ^ old) >> 27);
        auto turn = std::uint32_t(old >> 59);
        return mixed >> turn | mixed << (-turn & 31);
    }
    std::uint64_t state_ = 0, increment_;
};

/// A cosine-distributed direction about a unit normal.
inline Vec3 cosineDirection(Vec3 normal, RandomNumbers &random) {
    float z = 1 - 2 * random.uniform(), turn = 2 * std::numbers::pi_v<float> * random.uniform();
    float r = std::sqrt(std::max(0.0f, 1 - z * z));
    // A point on the unit sphere that touches the surface: no frame is needed.
    return normalize(normal + Vec3{r * std::cos(turn), r * std::sin(turn), z} * .999999f);
}

} // namespace candela::bench
