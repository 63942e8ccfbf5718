// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/flat_polygon.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <span>

namespace candela {

double doubleArea(const FlatLoop &loop) {
    double sum = 0;
    for (std::size_t i = 1; i + 1 < loop.size(); ++i)
        sum += turn(loop[0].place, loop[i].place, loop[i + 1].place);
    return sum;
}

bool pointsInside(FlatPoint previous, FlatPoint corner, FlatPoint next, FlatPoint p) {
    bool leftOfIncoming = turn(previous, corner, p) > 0, leftOfOutgoing = turn(corner, next, p) > 0;
    double bend = turn(previous, corner, next);
    if (bend > 0)
        return leftOfIncoming && leftOfOutgoing;
    if (bend < 0)
        return leftOfIncoming || leftOfOutgoing;
    // Straight on, or back the way it came (the end of a spike: everything else is inside).
    double along = (corner.x - previous.x) * (next.x - corner.x) +
                   (corner.y - previous.y) * (next.y - corner.y);
    return along >= 0 ? leftOfOutgoing : turn(corner, next, p) != 0;
}

/// Is p, which lies on the line through a and b, strictly between them?
static bool between(FlatPoint a, FlatPoint b, FlatPoint p) {
    if (p == a || p == b)
        return false;
    return p.x >= std::min(a.x, b.x) && p.x <= std::max(a.x, b.x) && p.y >= std::min(a.y, b.y) &&
           p.y <= std::max(a.y, b.y);
}

bool segmentsMeet(FlatPoint a, FlatPoint b, FlatPoint c, FlatPoint d) {
    double abc = turn(a, b, c), abd = turn(a, b, d), cda = turn(c, d, a), cdb = turn(c, d, b);
    if (((abc > 0 && abd < 0) || (abc < 0 && abd > 0)) &&
        ((cda > 0 && cdb < 0) || (cda < 0 && cdb > 0)))
        return true;
    return (abc == 0 && between(a, b, c)) || (abd == 0 && between(a, b, d)) ||
           (cda == 0 && between(c, d, a)) || (cdb == 0 && between(c, d, b));
}

static bool crossesLoop(FlatPoint a, FlatPoint b, const FlatLoop &loop) {
    const auto [left, right] = std::minmax(a.x, b.x);
    const auto [low, high] = std::minmax(a.y, b.y);
    FlatPoint from = loop.back().place;
    for (const FlatVertex &corner : loop) {
        const FlatPoint to = corner.place;
        const bool isBeside = (from.x < left && to.x < left) || (from.x > right && to.x > right) ||
                              (from.y < low && to.y < low) || (from.y > high && to.y > high);
        if (!isBeside && segmentsMeet(a, b, from, to))
            return true;
        from = to;
    }
    return false;
}

static std::size_t rightmost(const FlatLoop &loop) {
    std::size_t best = 0;
    for (std::size_t i = 1; i < loop.size(); ++i) {
        FlatPoint p = loop[i].place, q = loop[best].place;
        if (p.x > q.x || (p.x == q.x && p.y > q.y))
            best = i;
    }
    return best;
}

/// Is the way from the hole's corner `start` to corner i of the outside free of other sides?
static bool isVisible(const FlatLoop &outside, std::size_t i, const FlatLoop &hole,
                      std::size_t start, std::span<const FlatLoop> obstacles) {
    FlatPoint from = hole[start].place, corner = outside[i].place;
    FlatPoint previous = outside[(i + outside.size() - 1) % outside.size()].place;
    FlatPoint next = outside[(i + 1) % outside.size()].place;
    // Of several corners in one place, the one whose inside the hole lies in.
    if (corner == from)
        return pointsInside(previous, corner, next, hole[(start + 1) % hole.size()].place) ||
               pointsInside(previous, corner, next,
                            hole[(start + hole.size() - 1) % hole.size()].place);
    return pointsInside(previous, corner, next, from) && !crossesLoop(from, corner, outside) &&
           std::ranges::none_of(
               obstacles, [&](const FlatLoop &loop) { return crossesLoop(from, corner, loop); });
}

/// The corner of `outside` nearest to that of the hole that is seen from there.
static std::optional<std::size_t> visibleCorner(const FlatLoop &outside, const FlatLoop &hole,
                                                std::size_t start,
                                                std::span<const FlatLoop> obstacles) {
    std::vector<std::size_t> order(outside.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, {}, [&](std::size_t i) {
        double dx = outside[i].place.x - hole[start].place.x;
        double dy = outside[i].place.y - hole[start].place.y;
        return dx * dx + dy * dy;
    });
    for (std::size_t i : order)
        if (isVisible(outside, i, hole, start, obstacles))
            return i;
    return std::nullopt;
}

/// The loop a b c with the hole p q r joined at corner b and place p: a b p q r p b c, or, where b
/// and p are in one place, a b q r p c.
static void splice(FlatLoop &outside, std::size_t corner, const FlatLoop &hole, std::size_t start) {
    bool touching = outside[corner].place == hole[start].place;
    FlatLoop detour;
    for (std::size_t i = touching ? 1 : 0; i <= hole.size(); ++i)
        detour.push_back(hole[(start + i) % hole.size()]);
    if (!touching)
        detour.push_back(outside[corner]);
    outside.insert(outside.begin() + std::ptrdiff_t(corner) + 1, detour.begin(), detour.end());
}

/// The corner that a hole to the left of a place is to be bridged to, by what lies straight to the
/// right: of the side there the end farther to the right or, of corners that stand before that one,
/// the one nearest to the direction (Eberly 1998). Nothing if there is no side.
static std::optional<std::size_t> cornerToTheRight(const FlatLoop &outside, FlatPoint from) {
    const std::size_t n = outside.size();
    double nearest = std::numeric_limits<double>::infinity();
    std::size_t best = n;
    for (std::size_t i = 0; i < n; ++i) {
        const FlatPoint a = outside[i].place, b = outside[i + 1 < n ? i + 1 : 0].place;
        if (!(a.y <= from.y && from.y <= b.y) || a.y == b.y) // Of those that go up.
            continue;
        const double x = a.x + (from.y - a.y) / (b.y - a.y) * (b.x - a.x);
        if (x >= from.x && x < nearest)
            nearest = x, best = a.x > b.x ? i : (i + 1) % n;
    }
    if (best == n)
        return std::nullopt;
    const FlatPoint end = outside[best].place, hit{nearest, from.y};
    const bool isAbove = end.y > from.y;
    const auto slope = [&](FlatPoint p) { return std::fabs(p.y - from.y) / (p.x - from.x); };
    double flattest = slope(end);
    for (std::size_t i = 0; i < n; ++i) {
        const FlatPoint p = outside[i].place;
        if (p.x > from.x && p != end && slope(p) < flattest &&
            inTriangle(p, from, isAbove ? hit : end, isAbove ? end : hit))
            flattest = slope(p), best = i;
    }
    return best;
}

bool bridgeHoles(FlatLoop &outside, std::vector<FlatLoop> holes) {
    auto rightEnd = [](const FlatLoop &loop) { return -loop[rightmost(loop)].place.x; };
    std::ranges::stable_sort(holes, {}, rightEnd);
    bool good = true;
    for (std::size_t h = 0; h < holes.size(); ++h) {
        std::size_t start = rightmost(holes[h]);
        const auto others = std::span(holes).subspan(h);
        auto corner = cornerToTheRight(outside, holes[h][start].place);
        if (!corner || !isVisible(outside, *corner, holes[h], start, others))
            corner = visibleCorner(outside, holes[h], start, others);
        if (corner)
            splice(outside, *corner, holes[h], start);
        else
            good = false;
    }
    return good;
}

} // namespace candela
