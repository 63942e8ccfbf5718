// SPDX-License-Identifier: Apache-2.0
#include "world/shapes/joined_points.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace candela {

namespace {

using Triple = std::array<std::uint32_t, 3>;
using ShapeList = std::vector<std::uint32_t>;

/// Pairs of shapes that share surface and not just rims.
class SharedSurfaces {
public:
    SharedSurfaces(std::span<const PlacedVertex> vertices, std::span<const Triple> triangles) {
        findInner(vertices, triangles);
        findTriangles(vertices, triangles);
    }

    bool any() const { return !pairs_.empty() || !alone_.empty(); }
    bool shares(std::uint32_t a, std::uint32_t b) const {
        return pairs_.contains(std::minmax(a, b)) || alone_.contains(a) || alone_.contains(b);
    }

private:
    /// Of more shapes in one place those that come last are joined to none: pairs are many.
    static constexpr std::size_t mostInOnePlace = 64;

    /// The shapes, in increasing order, share what they are listed for.
    void note(const ShapeList &shapes) {
        const std::size_t count = std::min(shapes.size(), mostInOnePlace);
        for (std::size_t i = 0; i < count; ++i)
            for (std::size_t k = i + 1; k < count; ++k)
                pairs_.emplace(shapes[i], shapes[k]);
        alone_.insert(shapes.begin() + std::ptrdiff_t(count), shapes.end());
    }

    /// Calls note() for each run of equal keys; entries are a key and a shape.
    template <class Key> void noteRuns(std::vector<std::pair<Key, std::uint32_t>> entries) {
        std::ranges::sort(entries);
        entries.erase(std::ranges::unique(entries).begin(), entries.end());
        for (std::size_t first = 0, last; first < entries.size(); first = last) {
            ShapeList shapes;
            for (last = first; last < entries.size() && entries[last].first == entries[first].first;
                 ++last)
                shapes.push_back(entries[last].second);
            if (shapes.size() > 1)
                note(shapes);
        }
    }

    /// Places that lie within several shapes, on the rim of none.
    void findInner(std::span<const PlacedVertex> vertices, std::span<const Triple> triangles) {
        // Of each shape's edges, by their places: a rim has them once.
        std::vector<Triple> edges;
        for (const Triple &t : triangles)
            for (int k = 0; k < 3; ++k) {
                const PlacedVertex &a = vertices[t[k]], &b = vertices[t[(k + 1) % 3]];
                if (a.place != b.place)
                    edges.push_back(
                        {a.shape, std::min(a.place, b.place), std::max(a.place, b.place)});
            }
        std::ranges::sort(edges);
        std::set<std::pair<std::uint32_t, std::uint32_t>> rim; // Shape and place.
        for (std::size_t i = 0; i < edges.size(); ++i) {
            const bool asBefore = i > 0 && edges[i] == edges[i - 1];
            const bool asNext = i + 1 < edges.size() && edges[i] == edges[i + 1];
            if (!asBefore && !asNext)
                for (int end : {1, 2})
                    rim.emplace(edges[i][0], edges[i][std::size_t(end)]);
        }
        std::vector<std::pair<std::uint32_t, std::uint32_t>> inner; // Place and shape.
        for (const PlacedVertex &vertex : vertices)
            if (!rim.contains({vertex.shape, vertex.place}))
                inner.emplace_back(vertex.place, vertex.shape);
        noteRuns(std::move(inner));
    }

    /// Triangles of several shapes in one place.
    void findTriangles(std::span<const PlacedVertex> vertices, std::span<const Triple> triangles) {
        std::vector<std::pair<Triple, std::uint32_t>> all;
        for (const Triple &t : triangles) {
            Triple places{vertices[t[0]].place, vertices[t[1]].place, vertices[t[2]].place};
            std::ranges::sort(places);
            if (places[0] != places[1] && places[1] != places[2])
                all.emplace_back(places, vertices[t[0]].shape);
        }
        noteRuns(std::move(all));
    }

    std::set<std::pair<std::uint32_t, std::uint32_t>> pairs_;
    std::set<std::uint32_t> alone_;
};

/// A point of a place, and the shapes that it is of.
struct Group {
    std::uint32_t point;
    ShapeList shapes;
};

} // namespace

std::vector<std::uint32_t> joinedPoints(std::span<const PlacedVertex> vertices,
                                        std::span<const Triple> triangles) {
    std::vector<std::uint32_t> point;
    point.reserve(vertices.size());
    const SharedSurfaces shared(vertices, triangles);
    if (!shared.any()) {
        for (const PlacedVertex &vertex : vertices)
            point.push_back(vertex.place);
        return point;
    }
    std::map<std::uint32_t, std::vector<Group>> groupsOf; // By place.
    std::uint32_t points = 0;
    for (const PlacedVertex &vertex : vertices) {
        std::vector<Group> &groups = groupsOf[vertex.place];
        const auto isIn = [&](const Group &group) {
            return std::ranges::find(group.shapes, vertex.shape) != group.shapes.end();
        };
        const auto fits = [&](const Group &group) {
            return std::ranges::none_of(group.shapes, [&](std::uint32_t other) {
                return shared.shares(vertex.shape, other);
            });
        };
        auto group = std::ranges::find_if(groups, isIn);
        if (group == groups.end()) {
            group = std::ranges::find_if(groups, fits);
            if (group == groups.end())
                group = groups.insert(groups.end(), {points++, {}});
            group->shapes.push_back(vertex.shape);
        }
        point.push_back(group->point);
    }
    return point;
}

} // namespace candela
