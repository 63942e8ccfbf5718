// SPDX-License-Identifier: Apache-2.0
#include "embree_scene.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace candela::bench {
namespace {

void attach(RTCScene scene, RTCGeometry geometry, unsigned id) {
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(scene, geometry, id);
    rtcReleaseGeometry(geometry);
}

std::vector<float> sharesOfPower(const SceneDescription &scene) {
    std::vector<float> sums;
    double sum = 0;
    auto add = [&](double power) { sums.push_back(float(sum += power)); };
    for (const QuadLamp &lamp : scene.quads)
        add(2 * double(lamp.radiance) * length(cross(lamp.edgeU, lamp.edgeV)));
    for (const SphereLamp &lamp : scene.spheres)
        add(4 * std::numbers::pi * lamp.radius * lamp.radius * lamp.radiance);
    for (float &share : sums)
        share = float(share / sum);
    return sums;
}

} // namespace

EmbreeScene::EmbreeScene(const SceneDescription &description)
    : device_(rtcNewDevice(nullptr)), scene_(rtcNewScene(device_)),
      cumulative_(sharesOfPower(description)) {
    addTriangles(description);
    addSpheres(description);
    rtcCommitScene(scene_);
}

EmbreeScene::~EmbreeScene() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
}

std::size_t EmbreeScene::chooseLamp(float random, float &probability) const {
    auto found = std::upper_bound(cumulative_.begin(), cumulative_.end() - 1, random);
    probability = *found - (found == cumulative_.begin() ? 0 : found[-1]);
    return std::size_t(found - cumulative_.begin());
}

void EmbreeScene::addTriangles(const SceneDescription &description) {
    std::vector<Vec3> vertices;
    std::vector<std::array<std::uint32_t, 3>> corners;
    auto add = [&](const DiffuseMesh &mesh, float radiance) {
        auto first = std::uint32_t(vertices.size());
        vertices.insert(vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
        for (auto [a, b, c] : mesh.triangles) {
            corners.push_back({first + a, first + b, first + c});
            const std::vector<Vec3> &v = mesh.vertices;
            triangles_.push_back(
                {normalize(cross(v[b] - v[a], v[c] - v[a])), mesh.albedo, radiance});
        }
    };
    for (const DiffuseMesh &mesh : description.meshes)
        add(mesh, 0);
    for (const QuadLamp &lamp : description.quads) {
        DiffuseMesh quad;
        quad.addQuad(lamp.corner, lamp.corner + lamp.edgeU, lamp.corner + lamp.edgeU + lamp.edgeV,
                     lamp.corner + lamp.edgeV);
        add(quad, lamp.radiance);
    }
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    std::copy(vertices.begin(), vertices.end(),
              static_cast<Vec3 *>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
                                                          RTC_FORMAT_FLOAT3, sizeof(Vec3),
                                                          vertices.size())));
    std::copy(corners.begin(), corners.end(),
              static_cast<std::array<std::uint32_t, 3> *>(
                  rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                          sizeof corners[0], corners.size())));
    attach(scene_, geometry, 0);
}

void EmbreeScene::addSpheres(const SceneDescription &description) {
    if (description.spheres.empty())
        return;
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_SPHERE_POINT);
    auto *spheres = static_cast<float *>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4,
                                4 * sizeof(float), description.spheres.size()));
    for (const SphereLamp &lamp : description.spheres)
        for (float value : {lamp.centre.x, lamp.centre.y, lamp.centre.z, lamp.radius})
            *spheres++ = value;
    attach(scene_, geometry, 1);
}

} // namespace candela::bench
