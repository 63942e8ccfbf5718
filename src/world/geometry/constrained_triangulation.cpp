// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/constrained_triangulation.h"

#include <cmath>
#include <deque>

namespace candela {

namespace {

constexpr int next(int k) { return (k + 1) % 3; }
constexpr int before(int k) { return (k + 2) % 3; }
/// Segments that cross each other oftener than this in one triangle are left as they are.
constexpr int mostCrossings = 4096;

} // namespace

ConstrainedTriangulation::ConstrainedTriangulation()
    : points_{{0, 0}, {size, 0}, {0, size}},
      triangles_{{{0, 1, 2}, {-1, -1, -1}, {false, false, false}}}, at_{0, 0, 0} {}

std::vector<ConstrainedTriangulation::Triple> ConstrainedTriangulation::triangles() const {
    std::vector<Triple> result;
    for (const Triangle &t : triangles_)
        result.push_back(t.corner);
    return result;
}

/// Twice the area of a, b and c: positive if they turn left.
std::int64_t ConstrainedTriangulation::turn(int a, int b, Place c) const {
    const Place p = points_[a], q = points_[b];
    return (q.x - p.x) * (c.y - p.y) - (q.y - p.y) * (c.x - p.x);
}

ConstrainedTriangulation::Side ConstrainedTriangulation::find(Place place) const {
    const auto look = [&](int t, Side &found) {
        found = {t, -1};
        for (int k = 0; k < 3; ++k) {
            const auto &corner = triangles_[t].corner;
            const std::int64_t left = turn(corner[k], corner[next(k)], place);
            if (left < 0)
                return k;
            if (left == 0)
                found.k = k;
        }
        return -1;
    };
    Side found;
    int t = last_;
    for (std::size_t steps = 0; t >= 0 && steps < 2 * triangles_.size() + 3; ++steps) {
        const int outside = look(t, found);
        if (outside < 0) {
            last_ = t;
            return found;
        }
        t = triangles_[t].beyond[outside];
    }
    for (t = 0; t < int(triangles_.size()); ++t)
        if (look(t, found) < 0)
            return found;
    return {last_, -1};
}

int ConstrainedTriangulation::insert(Place place) {
    const Side found = find(place);
    for (int corner : triangles_[found.triangle].corner)
        if (points_[corner] == place)
            return corner;
    const int point = int(points_.size());
    points_.push_back(place);
    at_.push_back(found.triangle);
    if (found.k < 0)
        split(found.triangle, point);
    else
        splitSide(found, point);
    return point;
}

void ConstrainedTriangulation::set(int triangle, Triple corner, Triple beyond,
                                   std::array<bool, 3> isFixed) {
    if (triangle == int(triangles_.size()))
        triangles_.push_back({});
    triangles_[triangle] = {corner, beyond, isFixed};
    for (int point : corner)
        at_[point] = triangle;
}

void ConstrainedTriangulation::relink(int triangle, int from, int to) {
    if (triangle >= 0)
        for (int &beyond : triangles_[triangle].beyond)
            if (beyond == from) {
                beyond = to;
                return;
            }
}

void ConstrainedTriangulation::split(int triangle, int point) {
    const Triangle old = triangles_[triangle];
    const auto [a, b, c] = old.corner;
    const int second = int(triangles_.size()), third = second + 1;
    set(triangle, {a, b, point}, {old.beyond[0], second, third}, {old.isFixed[0], false, false});
    set(second, {b, c, point}, {old.beyond[1], third, triangle}, {old.isFixed[1], false, false});
    set(third, {c, a, point}, {old.beyond[2], triangle, second}, {old.isFixed[2], false, false});
    relink(old.beyond[1], triangle, second);
    relink(old.beyond[2], triangle, third);
    improve({{triangle, 0}, {second, 0}, {third, 0}});
}

ConstrainedTriangulation::Side ConstrainedTriangulation::acrossOf(Side side) const {
    const int other = triangles_[side.triangle].beyond[side.k];
    if (other < 0)
        return {};
    const int from = triangles_[side.triangle].corner[side.k];
    for (int k = 0; k < 3; ++k)
        if (triangles_[other].corner[next(k)] == from)
            return {other, k};
    return {};
}

void ConstrainedTriangulation::splitSide(Side side, int point) {
    const Side across = acrossOf(side);
    const Triangle old = triangles_[side.triangle];
    const int k = side.k, t = side.triangle, t1 = int(triangles_.size());
    const int a = old.corner[k], b = old.corner[next(k)], c = old.corner[before(k)];
    const bool fixed = old.isFixed[k];
    const int u = across.triangle, u1 = u < 0 ? -1 : t1 + 1;
    set(t, {a, point, c}, {u, t1, old.beyond[before(k)]}, {fixed, false, old.isFixed[before(k)]});
    set(t1, {point, b, c}, {u1, old.beyond[next(k)], t}, {fixed, old.isFixed[next(k)], false});
    relink(old.beyond[next(k)], t, t1);
    std::vector<Side> doubtful{{t, 2}, {t1, 1}};
    if (u >= 0) {
        const Triangle other = triangles_[u];
        const int m = across.k, d = other.corner[before(m)];
        set(u, {point, a, d}, {t, other.beyond[next(m)], u1},
            {fixed, other.isFixed[next(m)], false});
        set(u1, {b, point, d}, {t1, u, other.beyond[before(m)]},
            {fixed, false, other.isFixed[before(m)]});
        relink(other.beyond[before(m)], u, u1);
        doubtful.insert(doubtful.end(), {{u, 1}, {u1, 2}});
    }
    improve(std::move(doubtful));
}

void ConstrainedTriangulation::flip(Side side) {
    const Side across = acrossOf(side);
    const Triangle one = triangles_[side.triangle], other = triangles_[across.triangle];
    const int k = side.k, m = across.k, t = side.triangle, u = across.triangle;
    const int a = one.corner[k], b = one.corner[next(k)], c = one.corner[before(k)];
    const int d = other.corner[before(m)];
    set(t, {a, d, c}, {other.beyond[next(m)], u, one.beyond[before(k)]},
        {other.isFixed[next(m)], false, one.isFixed[before(k)]});
    set(u, {d, b, c}, {other.beyond[before(m)], one.beyond[next(k)], t},
        {other.isFixed[before(m)], one.isFixed[next(k)], false});
    relink(other.beyond[next(m)], u, t);
    relink(one.beyond[next(k)], t, u);
}

bool ConstrainedTriangulation::isDelaunay(Side side) const {
    const Side across = acrossOf(side);
    if (across.triangle < 0 || triangles_[side.triangle].isFixed[side.k])
        return true;
    const Place d = points_[triangles_[across.triangle].corner[before(across.k)]];
    std::int64_t x[3], y[3], squared[3];
    for (int k = 0; k < 3; ++k) {
        const Place p = points_[triangles_[side.triangle].corner[k]];
        x[k] = p.x - d.x, y[k] = p.y - d.y, squared[k] = x[k] * x[k] + y[k] * y[k];
    }
    __int128 inside = 0;
    for (int k = 0; k < 3; ++k)
        inside += __int128(squared[k]) * (x[next(k)] * y[before(k)] - x[before(k)] * y[next(k)]);
    return inside <= 0;
}

void ConstrainedTriangulation::improve(std::vector<Side> doubtful) {
    while (!doubtful.empty()) {
        const Side side = doubtful.back();
        doubtful.pop_back();
        if (isDelaunay(side))
            continue;
        const int t = side.triangle, u = triangles_[t].beyond[side.k];
        flip(side);
        doubtful.insert(doubtful.end(), {{t, 0}, {t, 2}, {u, 0}, {u, 1}});
    }
}

/// Round the point: to the left as far as it goes, then to the right.
template <class Call> void ConstrainedTriangulation::around(int point, Call call) const {
    for (bool toLeft : {true, false}) {
        int t = at_[point];
        do {
            int k = 0;
            while (triangles_[t].corner[k] != point)
                ++k;
            if (call(t, k))
                return;
            t = triangles_[t].beyond[toLeft ? before(k) : k];
        } while (t >= 0 && t != at_[point]);
        if (t >= 0)
            return;
    }
}

ConstrainedTriangulation::Side ConstrainedTriangulation::sideBetween(int a, int b) const {
    Side found;
    around(a, [&](int t, int k) {
        if (triangles_[t].corner[next(k)] == b)
            found = {t, k};
        else if (triangles_[t].corner[before(k)] == b)
            found = {t, before(k)};
        return found.triangle >= 0;
    });
    return found;
}

void ConstrainedTriangulation::fix(Side side, bool isFixed) {
    triangles_[side.triangle].isFixed[side.k] = isFixed;
    if (const Side across = acrossOf(side); across.triangle >= 0)
        triangles_[across.triangle].isFixed[across.k] = isFixed;
}

bool ConstrainedTriangulation::crosses(int a, int b, int p, int q) const {
    const auto side = [](std::int64_t turn) { return turn > 0 ? 1 : turn < 0 ? -1 : 0; };
    return side(turn(a, b, points_[p])) * side(turn(a, b, points_[q])) < 0 &&
           side(turn(p, q, points_[a])) * side(turn(p, q, points_[b])) < 0;
}

std::vector<std::array<int, 2>> ConstrainedTriangulation::crossed(int a, int b,
                                                                  int &through) const {
    std::vector<std::array<int, 2>> sides;
    through = -1;
    const auto isAhead = [&](int p) {
        const Place from = points_[a], to = points_[b], at = points_[p];
        return turn(a, b, at) == 0 &&
               (to.x - from.x) * (at.x - from.x) + (to.y - from.y) * (at.y - from.y) > 0;
    };
    // The triangle at the beginning whose far side the segment leaves by.
    Side out;
    around(a, [&](int t, int k) {
        const int p = triangles_[t].corner[next(k)], q = triangles_[t].corner[before(k)];
        if (isAhead(p) || isAhead(q))
            through = isAhead(p) ? p : q;
        else if (turn(a, b, points_[p]) < 0 && turn(a, b, points_[q]) > 0)
            out = {t, next(k)};
        return through >= 0 || out.triangle >= 0;
    });
    if (through >= 0)
        return sides;
    while (out.triangle >= 0) {
        const Triangle &triangle = triangles_[out.triangle];
        sides.push_back({triangle.corner[out.k], triangle.corner[next(out.k)]});
        const Side in = acrossOf(out);
        if (in.triangle < 0)
            break;
        const int tip = triangles_[in.triangle].corner[before(in.k)];
        if (tip == b)
            break;
        const std::int64_t left = turn(a, b, points_[tip]);
        if (left == 0) {
            through = tip;
            break;
        }
        // Of the tip and the side that was crossed, one end is left and the other right.
        out = {in.triangle, left > 0 ? before(in.k) : next(in.k)};
        const auto &corner = triangles_[out.triangle].corner;
        if ((turn(a, b, points_[corner[out.k]]) < 0) ==
            (turn(a, b, points_[corner[next(out.k)]]) < 0))
            out.k = out.k == next(in.k) ? before(in.k) : next(in.k);
    }
    return sides;
}

/// Where the segment crosses another there is a point of both, to rounding.
bool ConstrainedTriangulation::cutFixed(int a, int b,
                                        const std::vector<std::array<int, 2>> &sides) {
    for (const auto &[p, q] : sides) {
        const Side side = sideBetween(p, q);
        if (side.triangle < 0 || !triangles_[side.triangle].isFixed[side.k])
            continue;
        if (++crossings_ > mostCrossings)
            return true;
        const double before = double(turn(p, q, points_[a])),
                     after = double(turn(p, q, points_[b]));
        const double share = before / (before - after);
        const auto between = [&](std::int64_t from, std::int64_t to) {
            return from + std::int64_t(std::llround(share * double(to - from)));
        };
        const Place place{between(points_[a].x, points_[b].x), between(points_[a].y, points_[b].y)};
        fix(side, false);
        const int point = insert(place);
        constrain(p, point), constrain(point, q);
        constrain(a, point), constrain(point, b);
        return true;
    }
    return false;
}

void ConstrainedTriangulation::constrain(int a, int b) {
    if (a == b)
        return;
    if (const Side there = sideBetween(a, b); there.triangle >= 0)
        return fix(there, true);
    int through;
    const auto sides = crossed(a, b, through);
    if (through >= 0) {
        constrain(a, through);
        return constrain(through, b);
    }
    if (cutFixed(a, b, sides))
        return;
    std::deque<std::array<int, 2>> left(sides.begin(), sides.end());
    std::vector<std::array<int, 2>> made;
    for (std::size_t steps = 0; !left.empty() && steps < 64 + 16 * sides.size() * sides.size();
         ++steps) {
        const auto [p, q] = left.front();
        left.pop_front();
        const Side side = sideBetween(p, q), across = acrossOf(side);
        const int c = triangles_[side.triangle].corner[before(side.k)];
        const int d = triangles_[across.triangle].corner[before(across.k)];
        if (!crosses(c, d, p, q)) {
            left.push_back({p, q});
            continue;
        }
        flip(side);
        if (crosses(a, b, c, d))
            left.push_back({c, d});
        else
            made.push_back({c, d});
    }
    if (const Side there = sideBetween(a, b); there.triangle >= 0)
        fix(there, true);
    std::vector<Side> doubtful;
    for (const auto &[p, q] : made)
        if (const Side side = sideBetween(p, q); side.triangle >= 0)
            doubtful.push_back(side);
    improve(std::move(doubtful));
}

} // namespace candela
