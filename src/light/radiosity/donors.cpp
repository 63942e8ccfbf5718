// SPDX-License-Identifier: Apache-2.0
#include "light/radiosity/donors.h"

#include <algorithm>

namespace candela::radiosity {

namespace {

/// Corners are looked up so much of the way from the element's middle.
constexpr float almost = 0.98f;

float heightOver(const Mesh &mesh, int receiver, Vec3 P) {
    return dot(mesh.element(receiver).normal, P - mesh.element(receiver).centre);
}

bool seesNode(const Mesh &mesh, int receiver, int sender) {
    return std::ranges::any_of(mesh.nodes(sender), [&](const Node &node) {
        return heightOver(mesh, receiver, node.P) > 0;
    });
}

} // namespace

int donorOf(const Mesh &mesh, int receiver, int sender, PlaceLookup &lookup) {
    const Element &element = mesh.element(sender);
    if (!element.isCut || seesNode(mesh, receiver, sender))
        return -1;
    const bool isTriangle = mesh.basis(sender).isTriangle();
    const std::span<const Place> corners = Basis::corners(isTriangle);
    std::size_t highest = 0;
    for (std::size_t k = 1; k < corners.size(); ++k)
        if (heightOver(mesh, receiver, element.corners[k]) >
            heightOver(mesh, receiver, element.corners[highest]))
            highest = k;
    const Place centre = Basis::centre(isTriangle);
    const Place within{centre.u + almost * (corners[highest].u - centre.u),
                       centre.v + almost * (corners[highest].v - centre.v)};
    lookup.clear();
    lookup.add(mesh, std::int32_t(element.face), Mesh::inFace(element, within),
               element.centre + (element.corners[highest] - element.centre) * almost);
    lookup.find(mesh);
    const NodeWeights &found = lookup[0];
    for (int i = 0; i < found.count; ++i) {
        const int leaf = found.node[std::size_t(i)] / mesh.stride();
        if (seesNode(mesh, receiver, leaf))
            return leaf;
    }
    return -1;
}

std::array<float, mostNodes> donorWeights(const Mesh &mesh, int receiver, int donor) {
    std::array<float, mostNodes> weights{};
    float sum = 0;
    const std::span<const Node> nodes = mesh.nodes(donor);
    for (std::size_t j = 0; j < nodes.size(); ++j)
        if (heightOver(mesh, receiver, nodes[j].P) > 0)
            sum += weights[j] = nodes[j].area;
    for (float &weight : weights)
        weight /= sum;
    return weights;
}

} // namespace candela::radiosity
