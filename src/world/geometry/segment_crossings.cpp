// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/segment_crossings.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace candela {

namespace {

/// What a second or two allow.
constexpr long mostPairs = 50'000'000;
constexpr std::size_t mostCuts = 1'000'000;

struct Box {
    FlatPoint low, high;

    explicit Box(const FlatSegment &s)
        : low{std::min(s.from.x, s.to.x), std::min(s.from.y, s.to.y)},
          high{std::max(s.from.x, s.to.x), std::max(s.from.y, s.to.y)} {}
    void add(const Box &other) {
        low = {std::min(low.x, other.low.x), std::min(low.y, other.low.y)};
        high = {std::max(high.x, other.high.x), std::max(high.y, other.high.y)};
    }
    bool meets(const Box &other) const {
        return low.x <= other.high.x && high.x >= other.low.x && low.y <= other.high.y &&
               high.y >= other.low.y;
    }
};

/// Pairs of segments whose boxes meet, by a tree of boxes that is held against itself.
class CutFinder {
public:
    CutFinder(std::span<const FlatSegment> segments, std::vector<SegmentCut> &cuts)
        : segments_(segments), cuts_(cuts), order_(segments.size()) {
        std::iota(order_.begin(), order_.end(), 0);
        for (const FlatSegment &segment : segments)
            boxes_.emplace_back(segment);
        std::size_t leaves = 1;
        while (leaves * ofLeaf < segments.size())
            leaves *= 2;
        nodes_.resize(2 * leaves - 1, {Box({}), 0, 0});
        build(0, 0, int(segments.size()));
    }

    bool run() {
        within(0);
        return isBounded();
    }

private:
    static constexpr std::size_t ofLeaf = 4;
    struct Node {
        Box box;
        int first, last;
    };

    bool isBounded() const { return pairs_ <= mostPairs && cuts_.size() <= mostCuts; }
    bool isLeaf(int node) const { return 2 * std::size_t(node) + 1 >= nodes_.size(); }

    void build(int node, int first, int last) {
        Node &here = nodes_[std::size_t(node)];
        here.first = first, here.last = last;
        if (first == last)
            return;
        here.box = boxes_[std::size_t(order_[std::size_t(first)])];
        for (int k = first; k < last; ++k)
            here.box.add(boxes_[std::size_t(order_[std::size_t(k)])]);
        if (isLeaf(node))
            return;
        const bool isWide = here.box.high.x - here.box.low.x > here.box.high.y - here.box.low.y;
        const auto middleOf = [&](int k) {
            const Box &box = boxes_[std::size_t(k)];
            return isWide ? box.low.x + box.high.x : box.low.y + box.high.y;
        };
        const int middle = first + (last - first) / 2;
        std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + last,
                         [&](int a, int b) { return middleOf(a) < middleOf(b); });
        build(2 * node + 1, first, middle);
        build(2 * node + 2, middle, last);
    }

    void within(int node) {
        const Node &here = nodes_[std::size_t(node)];
        if (!isBounded())
            return;
        if (isLeaf(node)) {
            for (int i = here.first; i < here.last; ++i)
                for (int j = i + 1; j < here.last; ++j)
                    compare(i, j);
            return;
        }
        within(2 * node + 1);
        within(2 * node + 2);
        across(2 * node + 1, 2 * node + 2);
    }

    void across(int a, int b) {
        const Node &first = nodes_[std::size_t(a)], &second = nodes_[std::size_t(b)];
        if (++pairs_ > mostPairs || !first.box.meets(second.box) || first.first == first.last ||
            second.first == second.last)
            return;
        if (isLeaf(a) && isLeaf(b)) {
            for (int i = first.first; i < first.last; ++i)
                for (int j = second.first; j < second.last; ++j)
                    compare(i, j);
            return;
        }
        if (isLeaf(b) || (!isLeaf(a) && first.last - first.first >= second.last - second.first)) {
            across(2 * a + 1, b);
            across(2 * a + 2, b);
        } else {
            across(a, 2 * b + 1);
            across(a, 2 * b + 2);
        }
    }

    void compare(int i, int j) {
        const int a = order_[std::size_t(i)], b = order_[std::size_t(j)];
        ++pairs_;
        if (boxes_[std::size_t(a)].meets(boxes_[std::size_t(b)]) && isBounded())
            cut(a, b);
    }

    void cut(int a, int b) {
        const FlatSegment &s = segments_[std::size_t(a)], &t = segments_[std::size_t(b)];
        const double sFrom = turn(t.from, t.to, s.from), sTo = turn(t.from, t.to, s.to);
        const double tFrom = turn(s.from, s.to, t.from), tTo = turn(s.from, s.to, t.to);
        if (sFrom * sTo < 0 && tFrom * tTo < 0) {
            const double share = sFrom / (sFrom - sTo);
            const FlatPoint place{s.from.x + share * (s.to.x - s.from.x),
                                  s.from.y + share * (s.to.y - s.from.y)};
            cuts_.push_back({a, share, place});
            cuts_.push_back({b, tFrom / (tFrom - tTo), place});
            return;
        }
        if (sFrom == 0)
            cutAtEnd(b, s.from);
        if (sTo == 0)
            cutAtEnd(b, s.to);
        if (tFrom == 0)
            cutAtEnd(a, t.from);
        if (tTo == 0)
            cutAtEnd(a, t.to);
    }

    /// Of a place on the line through the segment.
    void cutAtEnd(int a, FlatPoint place) {
        const FlatSegment &s = segments_[std::size_t(a)];
        const double x = s.to.x - s.from.x, y = s.to.y - s.from.y;
        const double share =
            std::fabs(x) > std::fabs(y) ? (place.x - s.from.x) / x : (place.y - s.from.y) / y;
        if (share > 0 && share < 1)
            cuts_.push_back({a, share, place});
    }

    std::span<const FlatSegment> segments_;
    std::vector<SegmentCut> &cuts_;
    std::vector<Box> boxes_;
    std::vector<int> order_;
    std::vector<Node> nodes_;
    long pairs_ = 0;
};

} // namespace

bool findCuts(std::span<const FlatSegment> segments, std::vector<SegmentCut> &cuts) {
    return CutFinder(segments, cuts).run();
}

} // namespace candela
