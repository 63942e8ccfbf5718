// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/flat_polygon.h"

#include <algorithm>
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
    for (std::size_t i = 0; i < loop.size(); ++i)
        if (segmentsMeet(a, b, loop[i].place, loop[(i + 1) % loop.size()].place))
            return true;
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

/// The corner of `outside` nearest to `from` that is seen from there, holes in the way or not.
static std::optional<std::size_t> visibleCorner(const FlatLoop &outside, FlatPoint from,
                                                std::span<const FlatLoop> obstacles) {
    std::vector<std::size_t> order(outside.size());
    std::iota(order.begin(), order.end(), 0);
    auto distance = [&](std::size_t i) {
        double dx = outside[i].place.x - from.x, dy = outside[i].place.y - from.y;
        return dx * dx + dy * dy;
    };
    std::ranges::stable_sort(order, {}, distance);
    for (std::size_t i : order) {
        FlatPoint corner = outside[i].place;
        FlatPoint previous = outside[(i + outside.size() - 1) % outside.size()].place;
        FlatPoint next = outside[(i + 1) % outside.size()].place;
        bool touches = corner == from;
        if (!touches && !pointsInside(previous, corner, next, from))
            continue;
        bool hidden = !touches && (crossesLoop(from, corner, outside) ||
                                   std::ranges::any_of(obstacles, [&](const FlatLoop &loop) {
                                       return crossesLoop(from, corner, loop);
                                   }));
        if (!hidden)
            return i;
    }
    return std::nullopt;
}

/// The loop a b c with the hole p q r joined at corner b and place p: a b p q r p b c.
static void splice(FlatLoop &outside, std::size_t corner, const FlatLoop &hole, std::size_t start) {
    FlatLoop detour;
    for (std::size_t i = 0; i <= hole.size(); ++i)
        detour.push_back(hole[(start + i) % hole.size()]);
    detour.push_back(outside[corner]);
    outside.insert(outside.begin() + std::ptrdiff_t(corner) + 1, detour.begin(), detour.end());
}

bool bridgeHoles(FlatLoop &outside, std::vector<FlatLoop> holes) {
    auto rightEnd = [](const FlatLoop &loop) { return -loop[rightmost(loop)].place.x; };
    std::ranges::stable_sort(holes, {}, rightEnd);
    bool good = true;
    for (std::size_t h = 0; h < holes.size(); ++h) {
        std::size_t start = rightmost(holes[h]);
        auto corner = visibleCorner(outside, holes[h][start].place, std::span(holes).subspan(h));
        if (corner)
            splice(outside, *corner, holes[h], start);
        else
            good = false;
    }
    return good;
}

} // namespace candela
