// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/cut_along_trim.h"

#include "world/geometry/constrained_triangulation.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace candela {

namespace {

using Place = TrimOutline::Place;
using Local = ConstrainedTriangulation::Place;
constexpr std::int64_t size = ConstrainedTriangulation::size;

double cross(Place origin, Place a, Place b) {
    return (a[0] - origin[0]) * (b[1] - origin[1]) - (a[1] - origin[1]) * (b[0] - origin[0]);
}

class Cutter {
public:
    Cutter(const DicedMesh &whole, const TrimOutline &outline, const TrimRule &rule)
        : whole_(whole), outline_(outline), rule_(rule), numberOf_(whole.positions.size(), none) {}

    DicedMesh run(const Surface &surface) {
        for (const auto &triangle : whole_.triangles)
            cut(triangle);
        placeNew(surface);
        return std::move(cut_);
    }

private:
    static constexpr std::uint32_t none = ~0u;
    using Corners = std::array<std::uint32_t, 3>;

    Place uv(std::uint32_t vertex) const {
        return {whole_.vertexUv[vertex][0], whole_.vertexUv[vertex][1]};
    }

    /// Side k of a triangle, from corner k to k + 1, as its neighbour sees it, too.
    struct Edge {
        std::uint32_t low, high;
        bool isTurned; ///< It runs from high to low.
    };
    static Edge edgeOf(const Corners &corner, int k) {
        const std::uint32_t a = corner[k], b = corner[(k + 1) % 3];
        return {std::min(a, b), std::max(a, b), a > b};
    }

    /// Where a segment crosses an edge: in parts of the edge, from its lower end. Signs of the same
    /// products decide it for all edges of a vertex and all segments of a point, so that what goes
    /// into a triangle comes out of it.
    std::optional<std::int64_t> crossing(const Edge &edge, const TrimOutline::Segment &s) const {
        const Place a = uv(edge.low), b = uv(edge.high);
        const double from = cross(a, b, s.from), to = cross(a, b, s.to);
        if ((from >= 0) == (to >= 0) ||
            (cross(s.from, s.to, a) >= 0) == (cross(s.from, s.to, b) >= 0))
            return std::nullopt;
        const double low = cross(s.from, s.to, a), high = cross(s.from, s.to, b);
        return std::llround(std::clamp(low / (low - high), 0.0, 1.0) * double(size));
    }

    static Local onSide(int k, const Edge &edge, std::int64_t part) {
        const std::int64_t along = edge.isTurned ? size - part : part;
        return k == 0   ? Local{along, 0}
               : k == 1 ? Local{size - along, along}
                        : Local{0, size - along};
    }

    /// Coordinates by the edges from corner 0, within the triangle.
    Local within(const Corners &corner, Place place) const {
        const Place a = uv(corner[0]), b = uv(corner[1]), c = uv(corner[2]);
        const double area = cross(a, b, c);
        const auto share = [&](double part) {
            return std::clamp<std::int64_t>(std::llround(part / area * double(size)), 1, size - 2);
        };
        Local local{share(cross(a, place, c)), share(cross(a, b, place))};
        if (const std::int64_t excess = local.x + local.y - (size - 1); excess > 0)
            (local.x > local.y ? local.x : local.y) -= excess;
        return local;
    }

    void cut(const Corners &corner) {
        Place low{2, 2}, high{-1, -1};
        for (std::uint32_t vertex : corner)
            for (int c : {0, 1})
                low[c] = std::min(low[c], uv(vertex)[c]),
                high[c] = std::max(high[c], uv(vertex)[c]);
        ConstrainedTriangulation parts;
        bool isCut = false;
        for (std::uint32_t k : outline_.near(low[1], high[1], near_)) {
            const TrimOutline::Segment &s = outline_.segments()[k];
            if (std::max(s.from[0], s.to[0]) < low[0] || std::min(s.from[0], s.to[0]) > high[0] ||
                std::max(s.from[1], s.to[1]) < low[1] || std::min(s.from[1], s.to[1]) > high[1])
                continue;
            isCut |= cutAlong(corner, s, parts);
        }
        if (!isCut) {
            if (keeps(corner, {size / 3, size / 3}))
                cut_.triangles.push_back({taken(corner[0]), taken(corner[1]), taken(corner[2])});
            return;
        }
        std::vector<std::uint32_t> numbers(parts.points().size(), none);
        for (const auto &part : parts.triangles()) {
            Local middle;
            for (int point : part)
                middle.x += parts.points()[std::size_t(point)].x / 3,
                    middle.y += parts.points()[std::size_t(point)].y / 3;
            if (!keeps(corner, middle))
                continue;
            Corners triangle;
            for (int k = 0; k < 3; ++k) {
                std::uint32_t &number = numbers[std::size_t(part[k])];
                if (number == none)
                    number = numberAt(corner, parts.points()[std::size_t(part[k])]);
                triangle[k] = number;
            }
            cut_.triangles.push_back(triangle);
        }
    }

    /// Adds a segment's part in the triangle; false if there is none.
    bool cutAlong(const Corners &corner, const TrimOutline::Segment &s,
                  ConstrainedTriangulation &parts) {
        std::array<int, 4> ends{};
        int count = 0;
        for (int k = 0; k < 3; ++k) {
            const Edge edge = edgeOf(corner, k);
            if (const auto part = crossing(edge, s))
                ends[count++] = parts.insert(onSide(k, edge, *part));
        }
        for (const Place &end : {s.from, s.to})
            if (count < 4 && holds(corner, end))
                ends[count++] = parts.insert(within(corner, end));
        if (count == 2)
            parts.constrain(ends[0], ends[1]);
        return count > 0;
    }

    bool holds(const Corners &corner, Place place) const {
        for (int k = 0; k < 3; ++k) {
            const Edge edge = edgeOf(corner, k);
            const double inside = cross(uv(edge.low), uv(edge.high), uv(corner[(k + 2) % 3]));
            if (inside == 0 || (cross(uv(edge.low), uv(edge.high), place) >= 0) != (inside > 0))
                return false;
        }
        return true;
    }

    Place placeOf(const Corners &corner, Local local) const {
        const Place a = uv(corner[0]), b = uv(corner[1]), c = uv(corner[2]);
        const double x = double(local.x) / double(size), y = double(local.y) / double(size);
        return {a[0] + x * (b[0] - a[0]) + y * (c[0] - a[0]),
                a[1] + x * (b[1] - a[1]) + y * (c[1] - a[1])};
    }

    bool keeps(const Corners &corner, Local local) const {
        return rule_.keeps(outline_.winding(placeOf(corner, local)));
    }

    std::uint32_t taken(std::uint32_t vertex) {
        if (numberOf_[vertex] == none) {
            numberOf_[vertex] = std::uint32_t(cut_.positions.size());
            cut_.positions.push_back(whole_.positions[vertex]);
            cut_.vertexUv.push_back(whole_.vertexUv[vertex]);
        }
        return numberOf_[vertex];
    }

    std::uint32_t numberAt(const Corners &corner, Local local) {
        const auto add = [&](Place place) {
            const std::uint32_t number = std::uint32_t(cut_.positions.size());
            new_.push_back(number);
            cut_.positions.push_back({});
            cut_.vertexUv.push_back({float(place[0]), float(place[1])});
            return number;
        };
        for (int k = 0; k < 3; ++k) {
            const bool isOn = k == 0   ? local.y == 0
                              : k == 1 ? local.x + local.y == size
                                       : local.x == 0;
            if (!isOn)
                continue;
            const std::int64_t along = k == 0 ? local.x : k == 1 ? local.y : size - local.y;
            if (along == 0 || along == size)
                return taken(corner[along == 0 ? k : (k + 1) % 3]);
            const Edge edge = edgeOf(corner, k);
            const std::int64_t part = edge.isTurned ? size - along : along;
            const auto [entry, isNew] =
                onEdges_.try_emplace({edge.low, edge.high, part}, std::uint32_t(0));
            if (isNew) {
                const Place a = uv(edge.low), b = uv(edge.high);
                const double share = double(part) / double(size);
                entry->second = add({a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])});
            }
            return entry->second;
        }
        return add(placeOf(corner, local));
    }

    void placeNew(const Surface &surface) {
        const int n = int(new_.size());
        const std::vector<std::uint32_t> piece(new_.size(), 0);
        std::vector<float> planes(5 * new_.size());
        float *u = planes.data(), *v = u + n;
        for (int k = 0; k < n; ++k)
            u[k] = cut_.vertexUv[new_[std::size_t(k)]][0],
            v[k] = cut_.vertexUv[new_[std::size_t(k)]][1];
        SurfaceAnswer answer;
        answer.P = {v + n, v + 2 * n, v + 3 * n};
        surface.evaluate({n, piece.data(), u, v}, answer);
        for (int k = 0; k < n; ++k)
            cut_.positions[new_[std::size_t(k)]] = answer.P.get(k);
    }

    const DicedMesh &whole_;
    const TrimOutline &outline_;
    const TrimRule &rule_;
    DicedMesh cut_;
    std::vector<std::uint32_t> numberOf_; ///< Of the whole mesh's vertices.
    std::map<std::tuple<std::uint32_t, std::uint32_t, std::int64_t>, std::uint32_t> onEdges_;
    std::vector<std::uint32_t> new_, near_;
};

} // namespace

DicedMesh cutAlongTrim(const DicedMesh &whole, const TrimOutline &outline, const TrimRule &rule,
                       const Surface &surface) {
    DicedMesh cut = Cutter(whole, outline, rule).run(surface);
    cut.chordError = whole.chordError;
    return cut;
}

} // namespace candela
