// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/subdivision_values.h"

#include <map>

namespace candela {

ValueMesh valueMesh(const NumericVariable &variable, const SubdivisionRecord &mesh) {
    const std::size_t n = std::size_t(variable.components);
    ValueMesh result;
    result.mesh.scheme = mesh.scheme;
    result.mesh.vertexCounts = mesh.vertexCounts;
    result.mesh.interpolateBoundary = mesh.faceVaryingBoundary == 2 ? 2 : 1;
    std::map<std::pair<int, std::vector<float>>, int> known;
    std::multimap<int, int> copies; // Of a vertex of the mesh.
    for (std::size_t corner = 0; corner < mesh.vertices.size(); ++corner) {
        const auto value = variable.values.begin() + std::ptrdiff_t(corner * n);
        const auto [entry, isNew] = known.try_emplace(
            {mesh.vertices[corner], std::vector<float>(value, value + std::ptrdiff_t(n))},
            result.vertices);
        if (isNew) {
            ++result.vertices;
            copies.emplace(mesh.vertices[corner], entry->second);
            result.values.insert(result.values.end(), value, value + std::ptrdiff_t(n));
        }
        result.mesh.vertices.push_back(entry->second);
    }
    const auto each = [&](int vertex, auto call) {
        for (auto [at, end] = copies.equal_range(vertex); at != end; ++at)
            call(at->second);
    };
    for (const auto &crease : mesh.creases)
        for (std::size_t i = 0; i + 1 < crease.vertices.size(); ++i)
            each(crease.vertices[i], [&](int a) {
                each(crease.vertices[i + 1], [&](int b) {
                    result.mesh.creases.push_back({{a, b}, crease.sharpness});
                });
            });
    for (const auto &corner : mesh.corners)
        each(corner.vertex, [&](int a) { result.mesh.corners.push_back({a, corner.sharpness}); });
    return result;
}

} // namespace candela
