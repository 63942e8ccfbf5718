// SPDX-License-Identifier: Apache-2.0
#include "light/radiosity/points.h"

#include <algorithm>
#include <map>

namespace candela::radiosity {

void PointBatch::add(const Mesh &mesh, int element, Place inFace, Vec3 N) {
    const PlacedDomain &domain = mesh.domainOf(element);
    instance_.push_back(domain.instance), shape_.push_back(domain.shape);
    piece_.push_back(mesh.faceOf(element).piece);
    u_.push_back(inFace.u), v_.push_back(inFace.v);
    nx_.push_back(N.x), ny_.push_back(N.y), nz_.push_back(N.z);
}

void PointBatch::addNodes(const Mesh &mesh, int element) {
    const Basis &basis = mesh.basis(element);
    const std::span<const Node> nodes = mesh.nodes(element);
    for (int i = 0; i < basis.nodes(); ++i)
        add(mesh, element, Mesh::inFace(mesh.element(element), basis.node(i)),
            nodes[std::size_t(i)].N);
}

std::vector<std::vector<int>> batchesByCode(const Mesh &mesh, std::span<const int> elements,
                                            int most) {
    std::map<int, std::vector<int>> byCode;
    for (int e : elements)
        byCode[mesh.domainOf(e).code].push_back(e);
    const std::size_t size = std::size_t(most / mesh.stride());
    std::vector<std::vector<int>> batches;
    for (const auto &[code, own] : byCode)
        for (std::size_t at = 0; at < own.size(); at += size)
            batches.emplace_back(own.begin() + std::ptrdiff_t(at),
                                 own.begin() + std::ptrdiff_t(std::min(at + size, own.size())));
    return batches;
}

} // namespace candela::radiosity
