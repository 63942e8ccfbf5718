// SPDX-License-Identifier: Apache-2.0
#include "light/radiosity/surroundings.h"

#include "light/sampling/sobol.h"

#include <algorithm>
#include <cmath>

namespace candela::radiosity {

namespace {

/// A point of the element that is as likely to be anywhere.
Place placeOf(const Basis &basis, int k, std::uint32_t key) {
    const std::uint32_t index = std::uint32_t(k);
    Place at;
    sobolPairs(1, &key, &index, 0, &at.u, &at.v);
    if (!basis.isTriangle())
        return at;
    const float along = std::sqrt(at.u); // By strips, so that no narrow one is missed.
    return {1 - along, along * at.v};
}

int nearestNode(const Basis &basis, Place at) {
    int nearest = 0;
    float least = INFINITY;
    for (int i = 0; i < basis.nodes(); ++i) {
        const float u = basis.node(i).u - at.u, v = basis.node(i).v - at.v;
        if (u * u + v * v < least)
            least = u * u + v * v, nearest = i;
    }
    return nearest;
}

} // namespace

/// Points of the element join those that are to be asked about.
void Surroundings::scatter(const Mesh &mesh, int element, int count, std::uint32_t seed) {
    const Basis &basis = mesh.basis(element);
    const std::uint32_t key = pixelKey(element, 0, seed);
    for (int k = 0; k < count; ++k) {
        const Place at = placeOf(basis, k, key);
        const int node = nearestNode(basis, at);
        points_.add(mesh, element, Mesh::inFace(mesh.element(element), at),
                    mesh.nodes(element)[std::size_t(node)].N);
        nearest_.push_back(node);
    }
}

std::span<float *const> Surroundings::answers(const Mesh &mesh, const PointQuestion &question) {
    // Normals were the nearest nodes'; surfaces know better, but for the side that they are of.
    const Vec3Planes N = points_.N();
    std::vector<float> planes(7 * std::size_t(points_.size()));
    const auto plane = [&](int k) { return planes.data() + k * points_.size(); };
    const Vec3Planes Ng{plane(3), plane(4), plane(5)};
    mesh.scene().domains().frames(points_.places(), {plane(0), plane(1), plane(2)}, Ng, plane(6));
    for (int i = 0; i < points_.size(); ++i)
        N.set(i, dot(N.get(i), Ng.get(i)) < 0 ? -Ng.get(i) : Ng.get(i));
    return question(points_.places(), N);
}

void Surroundings::average(const Mesh &mesh, std::span<const int> elements, int count,
                           const PointQuestion &question, std::uint32_t seed,
                           std::span<float *const> value) {
    const std::size_t together = std::size_t(capacity / count);
    int firstNode = 0;
    for (std::size_t first = 0; first < elements.size(); first += together) {
        const auto some = elements.subspan(first, std::min(together, elements.size() - first));
        points_ = {}, nearest_.clear();
        for (const int e : some)
            scatter(mesh, e, count, seed);
        const std::span<float *const> found = answers(mesh, question);
        for (std::size_t k = 0; k < some.size(); ++k) {
            takeMeans(mesh.basis(some[k]).nodes(), int(k) * count, count, found, firstNode, value);
            firstNode += mesh.basis(some[k]).nodes();
        }
    }
}

/// Nodes that no point is nearest to keep what they have.
void Surroundings::takeMeans(int nodes, int firstPoint, int count, std::span<float *const> found,
                             int firstNode, std::span<float *const> value) const {
    std::array<int, mostNodes> points{};
    for (int k = firstPoint; k < firstPoint + count; ++k)
        ++points[std::size_t(nearest_[std::size_t(k)])];
    for (std::size_t plane = 0; plane < value.size(); ++plane) {
        std::array<double, mostNodes> sum{};
        for (int k = firstPoint; k < firstPoint + count; ++k)
            sum[std::size_t(nearest_[std::size_t(k)])] += double(found[plane][k]);
        for (std::size_t node = 0; node < std::size_t(nodes); ++node)
            if (points[node] > 0)
                value[plane][firstNode + int(node)] = float(sum[node] / points[node]);
    }
}

} // namespace candela::radiosity
