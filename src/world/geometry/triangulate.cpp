// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/triangulate.h"

#include "world/geometry/clip_ears.h"
#include "world/geometry/simple_loops.h"
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
    double length() const { return std::sqrt(x * x + y * y + z * z); }
};

/// The way from b to a, in double.
Normal wayTo(Vec3 a, Vec3 b) { return {double(a.x) - b.x, double(a.y) - b.y, double(a.z) - b.z}; }

Normal cross(const Normal &a, const Normal &b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

/// Newell's normal: twice the area vector of the loop. `scale` becomes the square of its extent.
Normal normalOf(std::span<const Vec3> points, std::span<const int> loop, double &scale) {
    Normal n;
    scale = 0;
    const auto relative = [&](std::size_t i) {
        return wayTo(points[loop[i % loop.size()]], points[loop[0]]);
    };
    for (std::size_t i = 1; i < loop.size(); ++i) {
        const Normal a = relative(i), part = cross(a, relative(i + 1));
        n.x += part.x, n.y += part.y, n.z += part.z;
        scale = std::max(scale, a.x * a.x + a.y * a.y + a.z * a.z);
    }
    return n;
}

/// Of the plane through the first corner, the one farthest from it and the one farthest from both;
/// the way that the first bend of the loop looks.
Normal normalAcross(std::span<const Vec3> points, std::span<const int> loop) {
    const auto relative = [&](int corner) { return wayTo(points[corner], points[loop[0]]); };
    const auto farther = [](const Normal &a, const Normal &b) { return a.length() < b.length(); };
    Normal along, widest, bend;
    for (int corner : loop)
        along = std::max(along, relative(corner), farther);
    for (int corner : loop)
        widest = std::max(widest, cross(along, relative(corner)), farther);
    for (std::size_t i = 2; i < loop.size() && !(bend.length() > 1e-10 * widest.length()); ++i)
        bend = cross(wayTo(points[loop[i - 1]], points[loop[i - 2]]),
                     wayTo(points[loop[i]], points[loop[i - 1]]));
    if (bend.x * widest.x + bend.y * widest.y + bend.z * widest.z < 0)
        widest = {-widest.x, -widest.y, -widest.z};
    return widest;
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

/// A face's loops along one axis.
struct FlatFace {
    FlatLoop outside;
    std::vector<FlatLoop> holes;
};

FlatFace flattenFace(std::span<const Vec3> points, std::span<const std::span<const int>> loops,
                     const Projection &project) {
    FlatFace face{flatten(points, loops[0], project), {}};
    for (std::span<const int> loop : loops.subspan(1)) {
        FlatLoop hole = loop.empty() ? FlatLoop{} : flatten(points, loop, project);
        if (hole.size() < 3)
            continue; // A hole without area takes nothing away.
        if (doubleArea(hole) > 0)
            std::ranges::reverse(hole);
        face.holes.push_back(std::move(hole));
    }
    return face;
}

bool isConvex(const FlatLoop &loop) {
    int turnsBack = 0; // Of a loop that goes round once: twice from left to right.
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const FlatPoint a = loop[i].place, b = loop[(i + 1) % loop.size()].place;
        const FlatPoint c = loop[(i + 2) % loop.size()].place;
        if (!(turn(a, b, c) > 0))
            return false;
        turnsBack += (b.x - a.x > 0) != (c.x - b.x > 0);
    }
    return turnsBack == 2;
}

/// Do sides cross, or end on others, or loops come to a place again?
bool cross(const FlatFace &face) {
    if (face.holes.empty() && isConvex(face.outside))
        return false;
    std::vector<FlatSegment> sides;
    std::vector<std::pair<double, double>> places;
    const auto add = [&](const FlatLoop &loop) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            sides.push_back({loop[i].place, loop[(i + 1) % loop.size()].place});
            places.emplace_back(loop[i].place.x, loop[i].place.y);
        }
    };
    add(face.outside);
    for (const FlatLoop &hole : face.holes)
        add(hole);
    std::ranges::sort(places);
    return std::ranges::adjacent_find(places) != places.end() || meetWithin(sides);
}

/// Cuts a face whose loops do not cross; false, and nothing added, if they are seen to.
bool clip(const FlatFace &face, Triangles &triangles) {
    FlatLoop loop = face.outside;
    const std::size_t before = triangles.size();
    if (bridgeHoles(loop, face.holes) && clipEars(loop, WithoutEars::Stop, triangles) &&
        triangles.size() > before)
        return true;
    triangles.resize(before);
    return false;
}

/// Cuts a face whatever its loops do.
void clipSomehow(FlatFace face, Triangles &triangles) {
    bridgeHoles(face.outside, std::move(face.holes));
    clipEars(face.outside, WithoutEars::Force, triangles);
}

TriangulationResult clipCrossing(const FlatFace &face, int corners, Triangles &triangles,
                                 std::vector<MadeCorner> &made) {
    const std::size_t before = triangles.size();
    auto untangled = untangle(face.outside, face.holes, corners, made);
    if (untangled)
        for (auto &[outside, holes] : untangled->faces) {
            FlatFace part{std::move(outside), std::move(holes)};
            if (!clip(part, triangles))
                clipSomehow(std::move(part), triangles);
        }
    else
        clipSomehow(face, triangles);
    if (triangles.size() == before)
        return TriangulationResult::Degenerate;
    return untangled && untangled->cross ? TriangulationResult::Good
                                         : TriangulationResult::Approximated;
}

/// Is every corner within the rounding of a flat face's coordinates of the plane?
bool isFlat(std::span<const Vec3> points, std::span<const int> loop, const Normal &n,
            double scale) {
    return std::ranges::all_of(loop, [&](int index) {
        const Normal p = wayTo(points[index], points[loop[0]]);
        const double height = n.x * p.x + n.y * p.y + n.z * p.z;
        return std::abs(height) <= 1e-4 * n.length() * std::sqrt(scale);
    });
}

} // namespace

/// A face that is not flat, cut along one axis after the other until its loop is seen not to cross
/// itself; false, and nothing added, if there is no such axis.
static bool clipAlongSomeAxis(std::span<const Vec3> points,
                              std::span<const std::span<const int>> loops, Normal normal,
                              Triangles &triangles) {
    auto standsStill = [&](int a, int b) { return points[a] == points[b]; };
    for (int axis : Projection::axesOf(normal)) {
        Projection project(normal, axis);
        const FlatFace face = flattenFace(points, loops, project);
        // Corners that fall onto one another along the axis are apart in space.
        std::size_t corners = loops[0].size();
        for (std::size_t i = 0; i < loops[0].size(); ++i)
            corners -= standsStill(loops[0][i], loops[0][(i + 1) % loops[0].size()]);
        std::size_t before = triangles.size();
        bool whole = loops.size() > 1 || face.outside.size() == corners;
        if (whole && face.outside.size() >= 3 && doubleArea(face.outside) > 0 && !cross(face) &&
            clip(face, triangles) && (loops.size() > 1 || triangles.size() - before == corners - 2))
            return true;
        triangles.resize(before);
    }
    return false;
}

TriangulationResult triangulate(std::span<const Vec3> points,
                                std::span<const std::span<const int>> loops, Triangles &triangles,
                                std::vector<MadeCorner> &made) {
    if (loops.empty() || loops[0].size() < 3)
        return TriangulationResult::Degenerate;
    double scale = 0;
    Normal normal = normalOf(points, loops[0], scale);
    // Thinner than the rounding of its own coordinates.
    const auto vanishes = [&] { return !(normal.length() > 1e-10 * scale); };
    if (vanishes())
        normal = normalAcross(points, loops[0]); // Parts of it may turn against each other.
    if (vanishes())
        return TriangulationResult::Degenerate;
    if (loops.size() == 1 && cutQuickly(points, loops[0], triangles))
        return TriangulationResult::Good;
    if (!isFlat(points, loops[0], normal, scale)) {
        if (clipAlongSomeAxis(points, loops, normal, triangles) ||
            (loops.size() == 1 && spanLoop(points, loops[0], triangles)))
            return TriangulationResult::Good;
    }
    const FlatFace face = flattenFace(points, loops, Projection(normal));
    if (!cross(face) && clip(face, triangles))
        return TriangulationResult::Good;
    return clipCrossing(face, int(points.size()), triangles, made);
}

} // namespace candela
