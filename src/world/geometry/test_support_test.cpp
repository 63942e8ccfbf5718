// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/test_support.h"

#include <map>
#include <tuple>

namespace candela::geometrytest {

int borderEdges(const DicedMesh &mesh) {
    using Place = std::tuple<float, float, float>;
    auto place = [&](std::uint32_t i) {
        Vec3 p = mesh.positions[i];
        return Place{p.x + 0.0f, p.y + 0.0f, p.z + 0.0f}; // -0 is 0
    };
    std::map<std::pair<Place, Place>, int> directed;
    for (const auto &t : mesh.triangles)
        for (int k = 0; k < 3; ++k)
            ++directed[{place(t[k]), place(t[(k + 1) % 3])}];
    int borders = 0;
    for (const auto &[edge, count] : directed) {
        EXPECT_EQ(count, 1) << "two triangles turn the same way about an edge";
        borders += !directed.contains({edge.second, edge.first});
    }
    return borders;
}

double sampledChordError(const Surface &surface, const DicedMesh &mesh, int samplesPerTriangle) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> uniform(0, 1);
    double worst = 0;
    for (std::size_t k = 0; k < mesh.triangles.size(); ++k)
        for (int i = 0; i < samplesPerTriangle; ++i) {
            float a = uniform(random), b = uniform(random);
            if (a + b > 1)
                a = 1 - a, b = 1 - b;
            const auto &t = mesh.triangles[k];
            auto mix = [&](auto f) { return f(t[0]) * (1 - a - b) + f(t[1]) * a + f(t[2]) * b; };
            Vec3 onTriangle = mix([&](std::uint32_t v) { return mesh.positions[v]; });
            Point p = mesh.vertexUv.empty()
                          ? at(surface, a, b, std::uint32_t(k))
                          : at(surface, mix([&](std::uint32_t v) { return mesh.vertexUv[v][0]; }),
                               mix([&](std::uint32_t v) { return mesh.vertexUv[v][1]; }),
                               mesh.pieces.empty() ? 0 : mesh.pieces[k]);
            worst = std::max(worst, double(length(p.P - onTriangle)));
        }
    return worst;
}

} // namespace candela::geometrytest
