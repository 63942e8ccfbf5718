// SPDX-License-Identifier: Apache-2.0
// Which of the surfaces that bound a solid's bodies are surfaces of the solid, along one ray.
#pragma once

#include "foundation/base/vec3.h"
#include "world/rays/solid.h"

#include <algorithm>
#include <span>
#include <vector>

namespace candela {

/// Where a ray crosses a surface of a body.
struct SolidCrossing {
    float t = 0;
    /// Crossings that are no farther apart than the sum of theirs may stand in either order.
    float slack = 0;
    std::int32_t part = 0; ///< Which shape of the solid's members, in their order.
    bool againstNormal = false;
    std::uint32_t geometry = 0, instance = 0, element = 0; ///< As the ray tracer names them.
    float u = 0, v = 0;
    Vec3 Ng;
};

/// What a shape of a member is to the solid.
struct SolidPart {
    std::int32_t node = 0;
    unsigned mask = 0; ///< As the ray tracer has it.
    int frontSign = 0; ///< As in RayShape.
    /// It bounds no body: it is seen where a thin body there would be.
    bool isSheet = false;
};

/// A solid's nodes, ready to be asked. All bodies have an end: far away nothing is inside.
class SolidExpression {
public:
    explicit SolidExpression(const std::vector<SolidNode> &);

    /// What is inside at one point.
    class State {
    public:
        /// Outside of everything.
        void reset(const SolidExpression &);
        /// Passes the surface of the node's own body.
        void cross(std::int32_t node);
        bool isInside() const { return counts_[0] >= expression_->nodes_[0].needed; }
        bool isInsideOwn(std::int32_t node) const { return own_[std::size_t(node)] != 0; }

    private:
        const SolidExpression *expression_ = nullptr;
        std::vector<std::int32_t> counts_; ///< Of children that say yes.
        std::vector<std::uint8_t> own_;
    };

    /// The solid is where this body is not.
    bool isCutAway(std::int32_t node) const { return nodes_[std::size_t(node)].cutsAway; }
    std::size_t size() const { return nodes_.size(); }

private:
    struct Node {
        std::int32_t parent, needed, countFarAway = 0;
        bool subtracted, cutsAway;
    };
    std::vector<Node> nodes_;
};

/// One of the places where surfaces lie upon each other, or one alone: crossings [first, last).
class SolidPlace {
public:
    /// The place that begins, from behind, at crossing `first`.
    SolidPlace(std::span<const SolidCrossing> crossings, std::size_t first,
               std::span<const SolidPart> parts);

    std::size_t last() const { return last_; }
    /// Passes all of it, from its far to its near side: the crossing that is a surface of the
    /// solid, if one is.
    const SolidCrossing *pass(const SolidExpression &, SolidExpression::State &) const;

private:
    bool isCountedTwice(std::size_t k) const;
    /// The ray comes into the node's own body here, or out of it.
    bool isPassed(std::int32_t node) const;

    std::span<const SolidCrossing> crossings_;
    std::span<const SolidPart> parts_;
    std::size_t first_, last_;
};

/// Sorts from the farthest to the nearest.
void sortFromBehind(std::vector<SolidCrossing> &);

/// Calls visit(crossing, t) for each surface of the solid, from the farthest to the nearest: the
/// crossing of the body whose surface it is, and where the ray has left it behind. `crossings` are
/// all those of the ray beyond its beginning; they are sorted here. `state` is that of the
/// beginning then.
template <class Visit>
void passAll(const SolidExpression &expression, std::span<const SolidPart> parts,
             std::vector<SolidCrossing> &crossings, SolidExpression::State &state, Visit visit) {
    sortFromBehind(crossings);
    state.reset(expression);
    for (std::size_t first = 0; first < crossings.size();) {
        const SolidPlace place(crossings, first, parts);
        if (const SolidCrossing *surface = place.pass(expression, state))
            visit(*surface, crossings[first].t);
        first = place.last();
    }
}

} // namespace candela
