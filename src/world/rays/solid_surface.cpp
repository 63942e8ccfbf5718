// SPDX-License-Identifier: Apache-2.0
#include "world/rays/solid_surface.h"

#include <tuple>

namespace candela {

SolidExpression::SolidExpression(const std::vector<SolidNode> &nodes) {
    for (const SolidNode &node : nodes)
        nodes_.push_back({node.parent, node.needsAll ? 0 : 1, 0, node.subtracted, false});
    for (std::size_t k = 1; k < nodes.size(); ++k) {
        Node &node = nodes_[k], &parent = nodes_[std::size_t(node.parent)];
        parent.needed += nodes[std::size_t(node.parent)].needsAll;
        parent.countFarAway += node.subtracted;
        node.cutsAway = parent.cutsAway != node.subtracted;
    }
    for (Node &node : nodes_) // Of nothing at all there is nothing.
        node.needed = std::max(node.needed, 1);
}

void SolidExpression::State::reset(const SolidExpression &expression) {
    expression_ = &expression;
    counts_.clear();
    for (const Node &node : expression.nodes_)
        counts_.push_back(node.countFarAway);
    own_.assign(expression.nodes_.size(), 0);
}

void SolidExpression::State::cross(std::int32_t node) {
    own_[std::size_t(node)] ^= 1;
    bool enters = own_[std::size_t(node)];
    while (node >= 0) {
        const Node &at = expression_->nodes_[std::size_t(node)];
        std::int32_t &count = counts_[std::size_t(node)];
        const bool before = count >= at.needed;
        count += enters ? 1 : -1;
        const bool after = count >= at.needed;
        if (before == after)
            return;
        enters = after != at.subtracted;
        node = at.parent;
    }
}

void sortFromBehind(std::vector<SolidCrossing> &crossings) {
    std::ranges::sort(crossings, [](const SolidCrossing &a, const SolidCrossing &b) {
        return std::tie(b.t, a.part, a.element) < std::tie(a.t, b.part, b.element);
    });
}

SolidPlace::SolidPlace(std::span<const SolidCrossing> crossings, std::size_t first,
                       std::span<const SolidPart> parts)
    : crossings_(crossings), parts_(parts), first_(first), last_(first + 1) {
    constexpr std::size_t most = 64; // Of more than lie upon each other anywhere, each is asked.
    const SolidCrossing &far = crossings[first];
    while (last_ < std::min(crossings.size(), first + most) &&
           far.t - crossings[last_].t <= far.slack + crossings[last_].slack)
        ++last_;
}

/// Neighbouring elements overlap by more than rounding: rays through their common edge meet both.
bool SolidPlace::isCountedTwice(std::size_t k) const {
    const auto isNeighbour = [&](const SolidCrossing &other) {
        return parts_[std::size_t(other.part)].node ==
                   parts_[std::size_t(crossings_[k].part)].node &&
               other.againstNormal == crossings_[k].againstNormal;
    };
    return std::any_of(crossings_.begin() + std::ptrdiff_t(first_),
                       crossings_.begin() + std::ptrdiff_t(k), isNeighbour);
}

bool SolidPlace::isPassed(std::int32_t node) const {
    bool odd = false;
    for (std::size_t k = first_; k < last_; ++k)
        if (parts_[std::size_t(crossings_[k].part)].node == node && !isCountedTwice(k))
            odd = !odd;
    return odd;
}

const SolidCrossing *SolidPlace::pass(const SolidExpression &expression,
                                      SolidExpression::State &state) const {
    const bool insideBehind = state.isInside();
    const SolidCrossing *sheet = nullptr;
    for (std::size_t k = first_; k < last_; ++k) {
        const SolidPart &part = parts_[std::size_t(crossings_[k].part)];
        if (isCountedTwice(k))
            continue;
        const bool before = state.isInside();
        state.cross(part.node);
        if (part.isSheet) {
            if (state.isInside() != before)
                sheet = &crossings_[k];
            state.cross(part.node);
        }
    }
    const bool insideBefore = state.isInside();
    if (insideBefore == insideBehind)
        return sheet;
    // Of surfaces that coincide, the same one whatever rounding says of their order.
    const SolidCrossing *surface = nullptr;
    for (std::size_t k = first_; k < last_; ++k) {
        const SolidPart &part = parts_[std::size_t(crossings_[k].part)];
        const bool endsHere =
            state.isInsideOwn(part.node) == (insideBefore != expression.isCutAway(part.node));
        if (!part.isSheet && endsHere && isPassed(part.node) &&
            (!surface || crossings_[k].part < surface->part))
            surface = &crossings_[k];
    }
    return surface ? surface : &crossings_[first_];
}

} // namespace candela
