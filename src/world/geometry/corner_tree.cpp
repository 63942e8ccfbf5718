// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/corner_tree.h"

#include <algorithm>
#include <numeric>

namespace candela {

CornerTree::CornerTree(std::span<const FlatVertex> points)
    : points_(points), isThere_(points.size()), order_(points.size()), leafOf_(points.size()) {
    constexpr std::size_t ofLeaf = 8;
    std::size_t leaves = 1;
    while (leaves * ofLeaf < points.size())
        leaves *= 2;
    nodes_.resize(2 * leaves - 1);
    std::iota(order_.begin(), order_.end(), 0);
    build(0, 0, int(points.size()));
}

void CornerTree::build(int node, int first, int last) {
    Node &here = nodes_[std::size_t(node)];
    here.first = first, here.last = last;
    if (first == last)
        return;
    here.low = here.high = points_[std::size_t(order_[std::size_t(first)])].place;
    for (int k = first; k < last; ++k) {
        const FlatPoint p = points_[std::size_t(order_[std::size_t(k)])].place;
        here.low = {std::min(here.low.x, p.x), std::min(here.low.y, p.y)};
        here.high = {std::max(here.high.x, p.x), std::max(here.high.y, p.y)};
    }
    if (2 * std::size_t(node) + 1 >= nodes_.size()) {
        for (int k = first; k < last; ++k)
            leafOf_[std::size_t(order_[std::size_t(k)])] = node;
        return;
    }
    const bool isWide = here.high.x - here.low.x > here.high.y - here.low.y;
    const int middle = first + (last - first) / 2;
    std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + last,
                     [&](int p, int q) {
                         const FlatPoint a = points_[std::size_t(p)].place;
                         const FlatPoint b = points_[std::size_t(q)].place;
                         return isWide ? a.x < b.x : a.y < b.y;
                     });
    build(2 * node + 1, first, middle);
    build(2 * node + 2, middle, last);
}

void CornerTree::set(int point, bool isThere) {
    if (has(point) == isThere)
        return;
    isThere_[std::size_t(point)] = isThere;
    for (int node = leafOf_[std::size_t(point)]; node >= 0; node = node == 0 ? -1 : (node - 1) / 2)
        nodes_[std::size_t(node)].count += isThere ? 1 : -1;
}

bool CornerTree::isBeside(const Node &node, FlatPoint a, FlatPoint b, FlatPoint c) {
    return node.low.x > std::max({a.x, b.x, c.x}) || node.high.x < std::min({a.x, b.x, c.x}) ||
           node.low.y > std::max({a.y, b.y, c.y}) || node.high.y < std::min({a.y, b.y, c.y}) ||
           mostLeft(node, a, b) < 0 || mostLeft(node, b, c) < 0 || mostLeft(node, c, a) < 0;
}

} // namespace candela
