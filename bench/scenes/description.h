// SPDX-License-Identifier: Apache-2.0
// A benchmark scene as plain numbers in greys, of which the yardstick builds its Embree scene and
// writes the RIB file for Candela: both programs see the same digits.
#pragma once

#include "foundation/base/vec3.h"

#include <array>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <vector>

namespace candela::bench {

/// Diffuse triangles of one albedo.
struct DiffuseMesh {
    float albedo = 0;
    std::vector<Vec3> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;

    void addQuad(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
        auto first = std::uint32_t(vertices.size());
        vertices.insert(vertices.end(), {a, b, c, d});
        triangles.push_back({first, first + 1, first + 2});
        triangles.push_back({first, first + 2, first + 3});
    }

    /// The six sides of a box along the axes.
    void addBox(Vec3 low, Vec3 high) {
        auto corner = [&](int i) {
            return Vec3{i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z};
        };
        for (auto [a, b, c, d] : {std::array{0, 1, 3, 2},
                                  {4, 5, 7, 6},
                                  {0, 1, 5, 4},
                                  {2, 3, 7, 6},
                                  {0, 2, 6, 4},
                                  {1, 3, 7, 5}})
            addQuad(corner(a), corner(b), corner(c), corner(d));
    }
};

/// A black parallelogram that shines to both sides.
struct QuadLamp {
    Vec3 corner, edgeU, edgeV;
    float radiance = 0; ///< W m^-2 sr^-1.
};

/// A black ball that shines outwards.
struct SphereLamp {
    Vec3 centre;
    float radius = 0;
    float radiance = 0; ///< W m^-2 sr^-1.
};

struct SceneDescription {
    std::string name;
    int size = 512;       ///< Pixels, both ways.
    Vec3 eye;             ///< The camera looks along z, y is up, -x is right.
    float halfExtent = 1; ///< Of the picture, at a distance of 1.
    std::vector<DiffuseMesh> meshes;
    std::vector<QuadLamp> quads;
    std::vector<SphereLamp> spheres;
    float domeRadiance = 0; ///< From everywhere at infinity, W m^-2 sr^-1.
    float domeRadius = 0;   ///< Of the sphere that stands for the dome in RIB; clear of all else.
};

/// The scene of that name: cornell_grey, cornell_spheres, dome, hall.
/// \throws std::invalid_argument for any other name.
SceneDescription describeScene(const std::string &name);

/// The scene as RIB; its picture is NAME.exr.
/// \throws std::runtime_error when the file cannot be written.
void writeRib(const SceneDescription &scene, const std::string &file);

} // namespace candela::bench
