// SPDX-License-Identifier: Apache-2.0
#include "world/shapes/cut_triangles.h"

#include "world/shapes/corner_order.h"

#include <algorithm>
#include <cmath>

namespace candela {

namespace {

struct Corner {
    Vec3 position;
    std::array<float, 2> uv;
};

/// A point of the triangle near the eye is at least this share of its longest edge away, so that
/// an eye on the triangle itself ends the cutting.
constexpr float nearestShare = 1.0f / (1 << 20);

/// A lower bound of the distance between the eye and the triangle: to its bounding box.
float distanceTo(const std::array<Corner, 3> &t, Vec3 eye) {
    Vec3 outside;
    for (int axis = 0; axis < 3; ++axis) {
        auto [low, high] =
            std::minmax({t[0].position[axis], t[1].position[axis], t[2].position[axis]});
        outside[axis] = std::max({low - eye[axis], eye[axis] - high, 0.0f});
    }
    return length(outside);
}

class Cutter {
public:
    Cutter(const DicedMesh &from, const Vec3 *eye) : from_(from), eye_(eye) {}

    bool isLarge(const std::array<Corner, 3> &t, float least) const {
        if (!eye_)
            return false;
        float edge = std::sqrt(squaredEdge(t, longest(t)));
        return edge > longestEdgeShare * std::max(distanceTo(t, *eye_), least);
    }
    static bool isTurnedNeedle(const std::array<Corner, 3> &t) {
        return bluntCorner(t[0].position, t[1].position, t[2].position) != 0;
    }

    std::vector<std::uint32_t> run(DicedMesh &to) {
        for (std::uint32_t k = 0; k < from_.triangles.size(); ++k) {
            auto corners = cornersOf(k);
            float least = nearestShare * std::sqrt(squaredEdge(corners, longest(corners)));
            add(corners, k, least);
        }
        to = std::move(to_);
        return std::move(pieces_);
    }

    std::array<Corner, 3> cornersOf(std::uint32_t k) const {
        const auto &t = from_.triangles[k];
        return {{{from_.positions[t[0]], {0, 0}},
                 {from_.positions[t[1]], {1, 0}},
                 {from_.positions[t[2]], {0, 1}}}};
    }

private:
    static float squaredEdge(const std::array<Corner, 3> &t, int k) {
        Vec3 edge = t[(k + 1) % 3].position - t[k].position;
        return dot(edge, edge);
    }
    static int longest(const std::array<Corner, 3> &t) {
        int k = 0;
        for (int other : {1, 2})
            if (squaredEdge(t, other) > squaredEdge(t, k))
                k = other;
        return k;
    }

    void add(const std::array<Corner, 3> &t, std::uint32_t piece, float least) {
        if (!isLarge(t, least)) {
            std::uint32_t first = std::uint32_t(to_.positions.size());
            for (const Corner &corner : t) {
                to_.positions.push_back(corner.position);
                to_.vertexUv.push_back(corner.uv);
            }
            to_.triangles.push_back({first, first + 1, first + 2});
            pieces_.push_back(piece);
            return;
        }
        const int k = longest(t);
        const Corner &a = t[k], &b = t[(k + 1) % 3], &c = t[(k + 2) % 3];
        Corner middle{(a.position + b.position) * 0.5f,
                      {(a.uv[0] + b.uv[0]) / 2, (a.uv[1] + b.uv[1]) / 2}};
        add({a, middle, c}, piece, least);
        add({middle, b, c}, piece, least);
    }

    const DicedMesh &from_;
    const Vec3 *eye_;
    DicedMesh to_;
    std::vector<std::uint32_t> pieces_;
};

} // namespace

std::vector<std::uint32_t> cutTriangles(DicedMesh &mesh, const Vec3 *eye) {
    Cutter cutter(mesh, eye);
    bool any = false;
    for (std::uint32_t k = 0; k < mesh.triangles.size() && !any; ++k) {
        const auto corners = cutter.cornersOf(k);
        any = cutter.isLarge(corners, 0) || cutter.isTurnedNeedle(corners);
    }
    if (!any)
        return {};
    const DicedMesh whole = std::move(mesh);
    return Cutter(whole, eye).run(mesh);
}

} // namespace candela
