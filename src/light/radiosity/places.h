// SPDX-License-Identifier: Apache-2.0
// Where fields are read at points of surfaces: nodes of leaves, and what each counts. Nodes behind
// a wall that stands on the surface count nothing.
#pragma once

#include "light/radiosity/cuts.h"

#include <array>
#include <vector>

namespace candela::radiosity {

struct NodeWeights {
    int count = 0;
    std::array<std::int32_t, mostNodes> node; ///< By Mesh::stride() and number.
    std::array<float, mostNodes> weight;
    int leaf = -1; ///< Of the nearest one, whose near light counts.

    /// What the leaf's own nodes count, 1 in all.
    void ofLeaf(int stride, float *value) const;
};

/// Points that are looked up together. One a thread.
class PlaceLookup {
public:
    void clear() { points_.clear(); }
    /// A point of a face, current space; -1 = of none.
    void add(const Mesh &, std::int32_t face, Place, Vec3 P);
    void find(const Mesh &);
    /// Of the point that was added as the i-th; nothing where there is no element.
    const NodeWeights &operator[](int i) const { return points_[std::size_t(i)].found; }

private:
    struct Point {
        int own; ///< The leaf that it lies in.
        Vec3 P;
        NodeWeights found;
    };
    /// A node that may count at a point, and how near it is.
    struct Candidate {
        std::size_t point;
        std::int32_t node;
        float distance;
    };
    void look(const Mesh &, int levels, const std::vector<std::size_t> &waiting);
    void take(const Mesh &, std::vector<std::size_t> &waiting);

    std::vector<Point> points_;
    std::vector<Candidate> candidates_;
    std::vector<std::uint8_t> isReached_; ///< By candidate.
    GroundRays rays_;
};

} // namespace candela::radiosity
