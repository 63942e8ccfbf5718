// SPDX-License-Identifier: Apache-2.0
#include "world/shapes/elements.h"

#include <algorithm>
#include <cmath>

namespace candela {

float signByVote(const Shape &shape, const RayShape &mesh) {
    int vote = 0;
    const std::size_t step = std::max<std::size_t>(1, mesh.triangles.size() / 15);
    for (std::size_t k = 0; k < mesh.triangles.size(); k += step) {
        auto [a, b, c] = mesh.triangles[k];
        std::uint32_t piece = shape.naming == Naming::Direct ? std::uint32_t(k)
                              : shape.pieces.empty()         ? 0
                                                             : shape.pieces[k];
        float u = 1 / 3.0f, v = 1 / 3.0f, x = 0, y = 0, z = 0;
        if (shape.naming == Naming::Corners) {
            const auto *uv = shape.vertexUv.data();
            u = (uv[a][0] + uv[b][0] + uv[c][0]) / 3, v = (uv[a][1] + uv[b][1] + uv[c][1]) / 3;
        }
        SurfaceAnswer answer;
        answer.Ng = {&x, &y, &z};
        shape.surface->evaluate({1, &piece, &u, &v}, answer);
        Vec3 normal = normalize(transformNormal(shape.shapeFromOuter, normalize(Vec3{x, y, z})));
        Vec3 p0 = mesh.positions[a];
        Vec3 element = cross(mesh.positions[b] - p0, mesh.positions[c] - p0);
        float along = dot(normalize(element), normal);
        vote += along > 0 ? 1 : along < 0 ? -1 : 0;
    }
    return vote < 0 ? -1 : 1;
}

Reach reachOf(const RayShape &mesh) {
    Reach reach;
    for (const auto &t : mesh.triangles) {
        Vec3 edge[3];
        float squared = 0;
        for (int k = 0; k < 3; ++k) {
            edge[k] = mesh.positions[t[(k + 1) % 3]] - mesh.positions[t[k]];
            squared = std::max(squared, dot(edge[k], edge[k]));
        }
        const float longest = std::sqrt(squared), area = length(cross(edge[0], edge[1]));
        const float product = length(edge[0]) * length(edge[2]);
        reach.longestEdge = std::max(reach.longestEdge, longest);
        if (!(area > 0))
            continue;
        const float width = area / longest, astray = longest * (product / area) / 2;
        reach.slender = std::max(reach.slender, std::min(astray, width / elementRounding));
    }
    reach.slender = std::max(reach.slender, reach.longestEdge);
    return reach;
}

} // namespace candela
