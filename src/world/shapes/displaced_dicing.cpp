// SPDX-License-Identifier: Apache-2.0
#include "world/shapes/displaced_dicing.h"

#include "foundation/base/parallel.h"
#include "world/geometry/displaced_surface.h"
#include "world/shapes/displaced_points.h"
#include "world/shapes/elements.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace candela {

namespace {

/// Distinct keys in increasing order, and of each of the given ones which it is.
struct Numbered {
    explicit Numbered(const std::vector<std::uint64_t> &given) : number(given.size()) {
        std::vector<std::pair<std::uint64_t, std::uint32_t>> order(given.size());
        for (std::uint32_t i = 0; i < order.size(); ++i)
            order[i] = {given[i], i};
        std::ranges::sort(order);
        for (const auto &[key, i] : order) {
            if (keys.empty() || keys.back() != key)
                keys.push_back(key);
            number[i] = std::uint32_t(keys.size() - 1);
        }
    }
    std::vector<std::uint64_t> keys;
    std::vector<std::uint32_t> number;
};

/// No vertex.
constexpr std::uint32_t none = ~0u;

class Splitter {
public:
    Splitter(std::span<DisplacedDicing> shapes, const Camera *camera, double mostTriangles)
        : shapes_(shapes), camera_(camera), mostTriangles_(mostTriangles) {
        active_ = all_.begin(shapes_);
        constexpr int mostLevels = 32;
        for (int level = 0; level < mostLevels && !active_.empty(); ++level)
            splitOnce();
        done_.insert(done_.end(), active_.begin(), active_.end());
        all_.turnPoles(done_);
    }

    std::vector<RayShape> finish() {
        std::vector<std::vector<VertexTriple>> triangles(shapes_.size());
        for (const VertexTriple &t : done_)
            triangles[all_.vertices[t[0]].shape].push_back(t);
        std::vector<RayShape> meshes(shapes_.size());
        std::vector<std::uint32_t> numberOf(all_.vertices.size()); // Each vertex is of one shape.
        parallelFor(shapes_.size(),
                    [&](std::size_t i) { meshes[i] = finish(i, triangles[i], numberOf); });
        return meshes;
    }

private:
    /// How many times too long an edge is. Where it started counts too: what lies folded may open.
    /// Across a step of the shader's, or an edge at which two faces were joined, no splitting makes
    /// it short: it ends when the edge was short enough before.
    float excess(std::uint64_t edge) const {
        const DisplacedPoint &a = all_.points[firstOf(edge)], &b = all_.points[secondOf(edge)];
        const float start = length(a.start - b.start), moved = length(a.moved - b.moved);
        const float most = std::min(a.edge, b.edge) * pixelAt(a.moved, b.moved);
        const float excess = std::max(std::min(moved, mostStretch * start), start) / most;
        return std::isfinite(excess) ? excess : 0;
    }
    static constexpr float mostStretch = 8;

    /// What the frame does not show is seen by other ways, and less closely.
    float pixelAt(Vec3 a, Vec3 b) const {
        if (!camera_)
            return 1;
        constexpr float unseen = 4, least = 1e-3f;
        Box3 box;
        box.add(a), box.add(b);
        const float nearest = least * length(a - b);
        if (const std::optional<float> depth = camera_->shownDepth(box))
            return camera_->pixelSize(std::max(*depth, nearest));
        return unseen * camera_->pixelSize(std::max(length(a + b) / 2, nearest));
    }

    void splitOnce() {
        std::vector<std::uint64_t> sides;
        for (const VertexTriple &t : active_)
            for (int k = 0; k < 3; ++k)
                sides.push_back(pairOf(t[k], t[(k + 1) % 3]));
        const Numbered vertexEdges(sides);
        std::vector<std::uint64_t> pairs;
        for (std::uint64_t edge : vertexEdges.keys)
            pairs.push_back(
                pairOf(all_.vertices[firstOf(edge)].point, all_.vertices[secondOf(edge)].point));
        const Numbered edges(pairs);
        std::vector<std::uint32_t> times(edges.keys.size());
        for (std::uint32_t side : vertexEdges.number)
            ++times[edges.number[side]];
        const std::vector<std::uint32_t> middles = splitEdges(edges.keys, times);
        const std::uint32_t firstVertex = std::uint32_t(all_.vertices.size());
        std::vector<std::uint32_t> middleVertex(vertexEdges.keys.size(), none);
        for (std::size_t i = 0; i < middleVertex.size(); ++i)
            if (const std::uint32_t point = middles[edges.number[i]]; point != none) {
                middleVertex[i] = std::uint32_t(all_.vertices.size());
                all_.vertices.push_back(all_.between(vertexEdges.keys[i], point));
            }
        all_.move(shapes_, firstVertex, firstNewPoint_);
        std::vector<VertexTriple> parts;
        for (std::size_t t = 0; t < active_.size(); ++t) {
            VertexTriple middle;
            for (int k = 0; k < 3; ++k)
                middle[k] = middleVertex[vertexEdges.number[3 * t + k]];
            split(active_[t], middle, parts);
        }
        active_ = std::move(parts);
    }

    /// Of each edge the point in its middle, or none. The longest are split, as many as the budget
    /// has room for.
    std::vector<std::uint32_t> splitEdges(const std::vector<std::uint64_t> &edges,
                                          const std::vector<std::uint32_t> &times) {
        std::vector<float> tooLong(edges.size());
        constexpr std::size_t chunk = 4096;
        parallelFor((edges.size() + chunk - 1) / chunk, [&](std::size_t part) {
            for (std::size_t i = part * chunk; i < std::min(edges.size(), (part + 1) * chunk); ++i)
                tooLong[i] = excess(edges[i]);
        });
        const double room = mostTriangles_ - double(done_.size() + active_.size());
        auto added = [&] {
            double sum = 0;
            for (std::size_t i = 0; i < edges.size(); ++i)
                sum += tooLong[i] > threshold_ ? times[i] : 0;
            return sum;
        };
        while (added() > room)
            threshold_ *= 1.2f;
        firstNewPoint_ = std::uint32_t(all_.points.size());
        std::vector<std::uint32_t> middles(edges.size(), none);
        for (std::size_t i = 0; i < edges.size(); ++i)
            if (tooLong[i] > threshold_)
                middles[i] = all_.addBetween(edges[i]);
        return middles;
    }

    /// `middle` of each edge (k, k + 1), or none.
    void split(const VertexTriple &t, const VertexTriple &middle,
               std::vector<VertexTriple> &parts) {
        const int count = int(std::ranges::count_if(middle, [](auto m) { return m != none; }));
        if (count == 0) {
            done_.push_back(t);
            return;
        }
        if (count == 3) {
            for (int k = 0; k < 3; ++k)
                parts.push_back({t[k], middle[k], middle[(k + 2) % 3]});
            parts.push_back(middle);
            return;
        }
        // Turned so that edge 0 is split, and with it edge 1 if two are.
        int k = 0;
        while (middle[k] == none || (count == 2 && middle[(k + 1) % 3] == none))
            ++k;
        const std::uint32_t a = t[k], b = t[(k + 1) % 3], c = t[(k + 2) % 3], ab = middle[k];
        if (count == 1) {
            parts.insert(parts.end(), {{a, ab, c}, {ab, b, c}});
            return;
        }
        const std::uint32_t bc = middle[(k + 1) % 3];
        parts.push_back({ab, b, bc});
        if (all_.distance(a, bc) <= all_.distance(ab, c))
            parts.insert(parts.end(), {{a, ab, bc}, {a, bc, c}});
        else
            parts.insert(parts.end(), {{a, ab, c}, {ab, bc, c}});
    }

    /// The side that the surface's own triangles face, which splitting has kept.
    float signOf(const DisplacedDicing &dicing) const {
        Shape undisplaced = *dicing.shape;
        undisplaced.naming = dicing.mesh.vertexUv.empty() ? Naming::Direct : Naming::Corners;
        undisplaced.vertexUv = dicing.mesh.vertexUv;
        undisplaced.pieces = dicing.mesh.pieces;
        RayShape mesh;
        mesh.triangles = dicing.mesh.triangles;
        for (Vec3 position : dicing.mesh.positions)
            mesh.positions.push_back(transformPoint(undisplaced.outerFromShape, position));
        return signByVote(undisplaced, mesh);
    }

    RayShape finish(std::size_t number, const std::vector<VertexTriple> &triangles,
                    std::vector<std::uint32_t> &numberOf) const {
        const DisplacedDicing &dicing = shapes_[number];
        Shape &shape = *dicing.shape;
        std::vector<std::uint32_t> used;
        for (const VertexTriple &t : triangles)
            used.insert(used.end(), t.begin(), t.end());
        std::ranges::sort(used);
        used.erase(std::ranges::unique(used).begin(), used.end());
        RayShape met;
        DisplacedMesh mesh;
        for (std::uint32_t i : used) {
            const DisplacedVertex &vertex = all_.vertices[i];
            numberOf[i] = std::uint32_t(met.positions.size());
            met.positions.push_back(all_.points[vertex.point].moved);
            mesh.positions.push_back(transformPoint(shape.shapeFromOuter, met.positions.back()));
            mesh.vertexUv.push_back({vertex.u, vertex.v});
        }
        for (const VertexTriple &t : triangles) {
            VertexTriple local;
            for (int k = 0; k < 3; ++k)
                local[k] = numberOf[t[k]];
            mesh.triangles.push_back(local);
            if (dicing.mesh.vertexUv.empty() || !dicing.mesh.pieces.empty())
                mesh.pieces.push_back(all_.vertices[t[0]].piece);
        }
        met.triangles = mesh.triangles;
        shape.naming = Naming::Direct;
        shape.curved = true, shape.away = false, shape.flat = false;
        shape.elements = std::uint32_t(met.triangles.size());
        shape.elementSign = signOf(dicing);
        mesh.sign = shape.elementSign * shape.handedness;
        shape.offset = elementRounding * reachOf(met).slender;
        shape.surface =
            std::make_shared<DisplacedSurface>(shape.surface, shape.displacement, std::move(mesh));
        return met;
    }

    std::span<DisplacedDicing> shapes_;
    const Camera *camera_;
    const double mostTriangles_;
    float threshold_ = 1; ///< Edges are split that are so many times too long.
    DisplacedPoints all_;
    std::uint32_t firstNewPoint_ = 0;
    std::vector<VertexTriple> active_, done_;
};

} // namespace

std::vector<RayShape> diceDisplaced(std::span<DisplacedDicing> shapes, const Camera *camera,
                                    double mostTriangles) {
    return Splitter(shapes, camera, mostTriangles).finish();
}

} // namespace candela
