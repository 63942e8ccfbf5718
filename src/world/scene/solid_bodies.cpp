// SPDX-License-Identifier: Apache-2.0
#include "world/scene/solid_bodies.h"

#include <algorithm>

namespace candela {

void SolidBodies::addShape(std::uint32_t shape, std::int32_t node, const SourceLocation &where) {
    if (node < 0)
        return;
    nodeOfShape_[shape] = node;
    where_.try_emplace(node, where);
}

void SolidBodies::addInstance(std::vector<std::int32_t> nodes) {
    // What is of a solid is so with all its shapes.
    if (!nodes.empty() && nodes.front() >= 0)
        nodesOfInstance_[instances_] = std::move(nodes);
    ++instances_;
}

void SolidBodies::addInstanceOfWorld(std::uint32_t firstShape, std::uint32_t shapes) {
    std::vector<std::int32_t> nodes;
    for (std::uint32_t shape = firstShape; shape < firstShape + shapes; ++shape)
        if (isCut(shape))
            nodes.push_back(nodeOfShape_.at(shape));
    addInstance(std::move(nodes));
}

PlacedBodies SolidBodies::solids(std::uint32_t worldShapes) const {
    PlacedBodies bodies;
    const std::vector<bool> ofSeveral = placed_.ofSeveral();
    std::vector<std::int32_t> solidOf(placed_.nodes.size(), -1), numberInIt(placed_.nodes.size());
    for (std::size_t k = 0; k < placed_.nodes.size(); ++k) {
        if (!ofSeveral[k])
            continue;
        const auto &[parent, block, subtracted] = placed_.nodes[k];
        if (parent < 0)
            bodies.all.emplace_back(), bodies.where.emplace_back();
        solidOf[k] =
            parent < 0 ? std::int32_t(bodies.all.size()) - 1 : solidOf[std::size_t(parent)];
        Solid &solid = bodies.all[std::size_t(solidOf[k])];
        numberInIt[k] = std::int32_t(solid.nodes.size());
        const SolidOperation operation = declared_.block(block).operation;
        solid.nodes.push_back(
            {parent < 0 ? -1 : numberInIt[std::size_t(parent)], subtracted,
             operation == SolidOperation::Intersection || operation == SolidOperation::Difference});
        const auto where = where_.find(std::int32_t(k));
        bodies.where[std::size_t(solidOf[k])].push_back(where == where_.end() ? SourceLocation{}
                                                                              : where->second);
    }
    const auto add = [&](std::uint32_t geometry, std::vector<std::int32_t> nodes) {
        Solid &solid = bodies.all[std::size_t(solidOf[std::size_t(nodes.front())])];
        for (std::int32_t &node : nodes)
            node = numberInIt[std::size_t(node)];
        solid.members.push_back({geometry, std::move(nodes)});
    };
    for (const auto &[shape, node] : nodeOfShape_)
        if (shape < worldShapes)
            add(shape, {node});
    for (const auto &[instance, nodes] : nodesOfInstance_)
        add(worldShapes + instance, nodes);
    return bodies;
}

} // namespace candela
