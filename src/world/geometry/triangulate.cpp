// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/triangulate.h"

#include "world/geometry/flat_polygon.h"
#include "world/geometry/span_loop.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>

namespace candela {

namespace {

struct Normal {
    double x = 0, y = 0, z = 0;
    double along(int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
};

/// Newell's normal: twice the area vector of the loop. `scale` becomes the square of its extent.
Normal normalOf(std::span<const Vec3> points, std::span<const int> loop, double &scale) {
    Normal n;
    scale = 0;
    Vec3 origin = points[loop[0]];
    auto relative = [&](std::size_t i) {
        Vec3 p = points[loop[i % loop.size()]];
        return Normal{double(p.x) - origin.x, double(p.y) - origin.y, double(p.z) - origin.z};
    };
    for (std::size_t i = 1; i < loop.size(); ++i) {
        Normal a = relative(i), b = relative(i + 1);
        n.x += a.y * b.z - a.z * b.y;
        n.y += a.z * b.x - a.x * b.z;
        n.z += a.x * b.y - a.y * b.x;
        scale = std::max(scale, a.x * a.x + a.y * a.y + a.z * a.z);
    }
    return n;
}

/// Looks along the axis nearest to the normal, so that the coordinates stay exact; the outer loop
/// then turns counter-clockwise.
struct Projection {
    int first = 0, second = 1;

    explicit Projection(Normal n) : Projection(n, axesOf(n)[0]) {}
    Projection(Normal n, int axis) : first((axis + 1) % 3), second((axis + 2) % 3) {
        if (n.along(axis) < 0)
            std::swap(first, second);
    }
    /// From the axis nearest to the normal on.
    static std::array<int, 3> axesOf(Normal n) {
        std::array<int, 3> axes{0, 1, 2};
        std::ranges::stable_sort(axes, std::greater{},
                                 [&](int axis) { return std::abs(n.along(axis)); });
        return axes;
    }
    FlatPoint operator()(Vec3 p) const { return {p[first], p[second]}; }
};

/// The loop without immediate repetitions.
FlatLoop flatten(std::span<const Vec3> points, std::span<const int> loop,
                 const Projection &project) {
    FlatLoop flat;
    for (int index : loop) {
        FlatPoint place = project(points[index]);
        if (flat.empty() || flat.back().place != place)
            flat.push_back({place, index});
    }
    while (flat.size() > 1 && flat.front().place == flat.back().place)
        flat.pop_back();
    return flat;
}

/// Clips ears off a loop until nothing is left. Linked list by index; only corners that are not
/// convex can lie in an ear.
class EarClipper {
public:
    EarClipper(const FlatLoop &loop, std::vector<std::array<std::uint32_t, 3>> &triangles)
        : loop_(loop), triangles_(triangles), next_(loop.size()), previous_(loop.size()),
          notConvex_(loop.size()) {
        int n = int(loop.size());
        for (int i = 0; i < n; ++i)
            next_[i] = (i + 1) % n, previous_[i] = (i + n - 1) % n;
        for (int i = 0; i < n; ++i)
            if ((notConvex_[i] = !(bend(i) > 0)))
                blockers_.push_back(i);
    }

    /// False if corners were given up that the loop turns back at: it crosses itself.
    bool run() {
        bool clean = true;
        int remaining = int(loop_.size()), corner = 0, refused = 0;
        while (remaining >= 3) {
            bool clip = isEar(corner) || (remaining == 3 && bend(corner) > 0);
            if (!clip && refused < remaining) {
                ++refused;
                corner = next_[corner];
                continue;
            }
            // No ear is left in loops that cross themselves or have shrunk to a line: give up a
            // corner, as a triangle if it turns the right way.
            if (!clip) {
                corner = mostConvex(corner, remaining);
                clean = clean && bend(corner) == 0;
            }
            if (bend(corner) > 0)
                emit(corner);
            corner = remove(corner);
            --remaining;
            refused = 0;
        }
        return clean;
    }

private:
    FlatPoint place(int i) const { return loop_[i].place; }
    double bend(int i) const { return turn(place(previous_[i]), place(i), place(next_[i])); }

    bool isEar(int tip) const {
        if (notConvex_[tip])
            return false;
        int a = previous_[tip], c = next_[tip];
        for (int p : blockers_)
            if (p != a && p != c && blocks(p, a, tip, c))
                return false;
        return true;
    }

    /// Corners that stand where a corner of the ear does (bridges make them) block it only if
    /// their edges run into it.
    bool blocks(int p, int a, int tip, int c) const {
        FlatPoint A = place(a), T = place(tip), C = place(c), q = place(p);
        if (!inTriangle(q, A, T, C))
            return false;
        auto edgesEnter = [&](FlatPoint before, FlatPoint corner, FlatPoint after) {
            return pointsInside(before, corner, after, place(next_[p])) ||
                   pointsInside(before, corner, after, place(previous_[p]));
        };
        if (q == A)
            return edgesEnter(C, A, T);
        if (q == T)
            return edgesEnter(A, T, C);
        if (q == C)
            return edgesEnter(T, C, A);
        return true;
    }

    int mostConvex(int start, int remaining) const {
        int best = start;
        for (int i = next_[start], k = 1; k < remaining; ++k, i = next_[i])
            if (bend(i) > bend(best))
                best = i;
        return best;
    }

    void emit(int tip) {
        triangles_.push_back({std::uint32_t(loop_[previous_[tip]].index),
                              std::uint32_t(loop_[tip].index),
                              std::uint32_t(loop_[next_[tip]].index)});
    }

    /// Takes the corner out; returns where to go on: two further, so that fans stay short.
    int remove(int corner) {
        int a = previous_[corner], c = next_[corner];
        next_[a] = c;
        previous_[c] = a;
        if (notConvex_[corner])
            std::erase(blockers_, corner);
        refresh(a);
        refresh(c);
        return next_[c];
    }

    /// Clipping can also close a corner that was convex, in a loop with collinear parts.
    void refresh(int i) {
        bool was = notConvex_[i], is = !(bend(i) > 0);
        notConvex_[i] = is;
        if (was && !is)
            std::erase(blockers_, i);
        else if (!was && is)
            blockers_.push_back(i);
    }

    const FlatLoop &loop_;
    std::vector<std::array<std::uint32_t, 3>> &triangles_;
    std::vector<int> next_, previous_;
    std::vector<char> notConvex_;
    std::vector<int> blockers_;
};

/// One loop of many. Loops that touch are rare enough to look for only when joining fails.
bool join(FlatLoop &outside, std::vector<FlatLoop> holes) {
    FlatLoop joined = outside;
    bool good = bridgeHoles(joined, holes);
    std::size_t corners = outside.size();
    for (const FlatLoop &hole : holes)
        corners += hole.size();
    constexpr std::size_t mostCorners = 10000;
    if (!good && corners <= mostCorners) {
        splitWhereLoopsTouch(outside, holes);
        joined = outside;
        good = bridgeHoles(joined, std::move(holes));
    }
    outside = std::move(joined);
    return good;
}

/// A face's loops along one axis. `joined` is false if a hole could not be.
struct FlatFace {
    FlatLoop loop;
    bool joined = true;
};

FlatFace flattenFace(std::span<const Vec3> points, std::span<const std::span<const int>> loops,
                     const Projection &project) {
    FlatFace face{flatten(points, loops[0], project), true};
    std::vector<FlatLoop> holes;
    for (std::span<const int> loop : loops.subspan(1)) {
        FlatLoop hole = loop.empty() ? FlatLoop{} : flatten(points, loop, project);
        if (hole.size() < 3)
            continue; // A hole without area takes nothing away.
        if (doubleArea(hole) > 0)
            std::ranges::reverse(hole);
        holes.push_back(std::move(hole));
    }
    face.joined = join(face.loop, std::move(holes));
    return face;
}

/// Is every corner within the rounding of a flat face's coordinates of the plane?
bool isFlat(std::span<const Vec3> points, std::span<const int> loop, Normal n, double area,
            double scale) {
    Vec3 origin = points[loop[0]];
    return std::ranges::all_of(loop, [&](int index) {
        Vec3 p = points[index];
        double height = n.x * (double(p.x) - origin.x) + n.y * (double(p.y) - origin.y) +
                        n.z * (double(p.z) - origin.z);
        return std::abs(height) <= 1e-4 * area * std::sqrt(scale);
    });
}

} // namespace

/// A face that is not flat, cut along one axis after the other until its loop is seen not to cross
/// itself; false, and nothing added, if there is no such axis.
static bool clipAlongSomeAxis(std::span<const Vec3> points,
                              std::span<const std::span<const int>> loops, Normal normal,
                              std::vector<std::array<std::uint32_t, 3>> &triangles) {
    auto standsStill = [&](int a, int b) { return points[a] == points[b]; };
    for (int axis : Projection::axesOf(normal)) {
        Projection project(normal, axis);
        FlatFace face = flattenFace(points, loops, project);
        // Corners that fall onto one another along the axis are apart in space.
        std::size_t corners = loops[0].size();
        for (std::size_t i = 0; i < loops[0].size(); ++i)
            corners -= standsStill(loops[0][i], loops[0][(i + 1) % loops[0].size()]);
        std::size_t before = triangles.size();
        bool whole = loops.size() > 1 || face.loop.size() == corners;
        if (whole && face.joined && face.loop.size() >= 3 && doubleArea(face.loop) > 0 &&
            EarClipper(face.loop, triangles).run() &&
            (loops.size() > 1 || triangles.size() - before == corners - 2))
            return true;
        triangles.resize(before);
    }
    return false;
}

TriangulationResult triangulate(std::span<const Vec3> points,
                                std::span<const std::span<const int>> loops,
                                std::vector<std::array<std::uint32_t, 3>> &triangles) {
    if (loops.empty() || loops[0].size() < 3)
        return TriangulationResult::Degenerate;
    double scale = 0;
    Normal normal = normalOf(points, loops[0], scale);
    double area = std::sqrt(normal.x * normal.x + normal.y * normal.y + normal.z * normal.z);
    // Thinner than the rounding of its own coordinates.
    if (!(area > 1e-10 * scale))
        return TriangulationResult::Degenerate;
    if (loops.size() == 1 && cutQuickly(points, loops[0], triangles))
        return TriangulationResult::Good;
    if (!isFlat(points, loops[0], normal, area, scale)) {
        if (clipAlongSomeAxis(points, loops, normal, triangles) ||
            (loops.size() == 1 && spanLoop(points, loops[0], triangles)))
            return TriangulationResult::Good;
    }
    FlatFace face = flattenFace(points, loops, Projection(normal));
    std::size_t before = triangles.size();
    EarClipper(face.loop, triangles).run();
    if (triangles.size() == before)
        return TriangulationResult::Degenerate;
    return face.joined ? TriangulationResult::Good : TriangulationResult::HoleDropped;
}

} // namespace candela
