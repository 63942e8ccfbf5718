// SPDX-License-Identifier: Apache-2.0
// Points in the plane that come and go, found by the triangle that they lie in.
#pragma once

#include "world/geometry/flat_polygon.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace candela {

/// A balanced tree over all points that may be there; at first none is.
class CornerTree {
public:
    explicit CornerTree(std::span<const FlatVertex> points);

    bool has(int point) const { return isThere_[std::size_t(point)] != 0; }
    void set(int point, bool isThere);

    /// Of the points in or on the triangle a tip c, counter-clockwise, for which accept(point) is
    /// true, the one farthest from the side ac; -1 if there is none.
    template <class Accept>
    int farthest(FlatPoint a, FlatPoint tip, FlatPoint c, const Accept &accept) const {
        int best = -1;
        double distance = -1;
        int waiting[64], count = 0; // Each level leaves one behind.
        waiting[count++] = 0;
        while (count > 0) {
            const int at = waiting[--count];
            const Node &node = nodes_[std::size_t(at)];
            if (node.count == 0 || isBeside(node, a, tip, c) || mostLeft(node, c, a) <= distance)
                continue;
            if (2 * at + 1 < int(nodes_.size())) {
                const bool isFirst = mostLeft(nodes_[std::size_t(2 * at + 1)], c, a) >
                                     mostLeft(nodes_[std::size_t(2 * at + 2)], c, a);
                waiting[count++] = 2 * at + (isFirst ? 2 : 1);
                waiting[count++] = 2 * at + (isFirst ? 1 : 2);
                continue;
            }
            for (int k = node.first; k < node.last; ++k) {
                const int point = order_[std::size_t(k)];
                const FlatPoint p = points_[std::size_t(point)].place;
                if (has(point) && turn(c, a, p) > distance && inTriangle(p, a, tip, c) &&
                    accept(point))
                    best = point, distance = turn(c, a, p);
            }
        }
        return best;
    }

private:
    struct Node {
        FlatPoint low, high;
        int first = 0, last = 0; ///< In order_.
        int count = 0;           ///< Points of it that are there.
    };
    void build(int node, int first, int last);
    /// How far left of a line the node reaches, times the line's length.
    static double mostLeft(const Node &node, FlatPoint from, FlatPoint to) {
        return turn(
            from, to,
            {to.y < from.y ? node.high.x : node.low.x, to.x > from.x ? node.high.y : node.low.y});
    }
    /// Does all of the node lie beyond one side of the triangle?
    static bool isBeside(const Node &, FlatPoint a, FlatPoint b, FlatPoint c);

    std::span<const FlatVertex> points_;
    std::vector<std::uint8_t> isThere_;
    std::vector<Node> nodes_; ///< Complete: the children of k are 2 k + 1 and 2 k + 2.
    std::vector<int> order_, leafOf_;
};

} // namespace candela
