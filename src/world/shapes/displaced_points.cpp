// SPDX-License-Identifier: Apache-2.0
#include "world/shapes/displaced_points.h"

#include "foundation/base/parallel.h"
#include "world/shapes/coincident_points.h"
#include "world/shapes/joined_points.h"

#include <algorithm>
#include <numeric>

namespace candela {

/// At poles a coordinate may be anything.
static void findIdleCoordinates(std::span<const DisplacedDicing> shapes,
                                std::vector<DisplacedVertex> &vertices) {
    std::size_t first = 0;
    for (std::uint32_t shape = 0; shape < shapes.size(); ++shape) {
        const DicedMesh &mesh = shapes[shape].mesh;
        if (mesh.vertexUv.empty()) {
            first += 3 * mesh.triangles.size();
            continue;
        }
        const int n = int(mesh.positions.size());
        const std::vector<std::uint32_t> piece = mesh.piecesOfVertices();
        std::vector<float> values(5 * std::size_t(n));
        float *u = values.data(), *v = u + n;
        const Vec3Planes P{v + n, v + 2 * n, v + 3 * n};
        const Vec3 extent = shapes[shape].shape->surface->bound().extent();
        const float still = 1e-6f * std::max({extent.x, extent.y, extent.z});
        for (bool alongU : {true, false}) {
            constexpr float step = 1 / 16.0f;
            for (int k = 0; k < n; ++k)
                u[k] = mesh.vertexUv[k][0], v[k] = mesh.vertexUv[k][1];
            for (float *c = alongU ? u : v, *end = c + n; c != end; ++c)
                *c += *c < 0.5f ? step : -step;
            SurfaceAnswer answer;
            answer.P = P;
            shapes[shape].shape->surface->evaluate({n, piece.data(), u, v}, answer);
            for (int k = 0; k < n; ++k) {
                DisplacedVertex &vertex = vertices[first + k];
                const bool isIdle = length(P.get(k) - mesh.positions[k]) <= still;
                (alongU ? vertex.uIsIdle : vertex.vIsIdle) = isIdle;
            }
        }
        first += n;
    }
}

std::vector<VertexTriple> DisplacedPoints::begin(std::span<const DisplacedDicing> shapes) {
    std::vector<VertexTriple> triangles;
    std::vector<Vec3> starts;
    for (std::uint32_t shape = 0; shape < shapes.size(); ++shape) {
        const DicedMesh &mesh = shapes[shape].mesh;
        const bool direct = mesh.vertexUv.empty();
        const std::uint32_t first = std::uint32_t(vertices.size());
        auto add = [&](std::uint32_t corner, std::uint32_t piece, float u, float v) {
            vertices.push_back({shape, piece, 0, u, v});
            starts.push_back(
                transformPoint(shapes[shape].shape->outerFromShape, mesh.positions[corner]));
        };
        const std::vector<std::uint32_t> piece = mesh.piecesOfVertices();
        for (std::uint32_t k = 0; k < mesh.positions.size() && !direct; ++k)
            add(k, piece[k], mesh.vertexUv[k][0], mesh.vertexUv[k][1]);
        for (std::uint32_t k = 0; k < mesh.triangles.size(); ++k) {
            const auto [a, b, c] = mesh.triangles[k];
            if (direct) {
                const std::uint32_t next = std::uint32_t(vertices.size());
                add(a, k, 0, 0), add(b, k, 1, 0), add(c, k, 0, 1);
                triangles.push_back({next, next + 1, next + 2});
            } else {
                triangles.push_back({first + a, first + b, first + c});
            }
        }
    }
    const std::vector<std::uint32_t> places = placesOf(starts);
    std::vector<PlacedVertex> placed;
    for (std::size_t i = 0; i < vertices.size(); ++i)
        placed.push_back({vertices[i].shape, places[i]});
    const std::vector<std::uint32_t> joined = joinedPoints(placed, triangles);
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        DisplacedVertex &vertex = vertices[i];
        vertex.point = joined[i];
        const float edge = shapes[vertex.shape].edge;
        if (vertex.point == points.size())
            points.push_back({starts[i], {}, edge});
        points[vertex.point].edge = std::min(points[vertex.point].edge, edge);
    }
    findIdleCoordinates(shapes, vertices);
    move(shapes, 0, 0);
    return triangles;
}

/// Moves vertices of one shape; `moved` by vertex from the first on.
static void moveVertices(const Shape &shape, const std::vector<DisplacedVertex> &all,
                         std::span<const std::uint32_t> which, std::uint32_t firstVertex,
                         Vec3 *moved) {
    const std::size_t n = which.size();
    std::vector<std::uint32_t> piece(n);
    std::vector<float> values(5 * n);
    float *u = values.data(), *v = u + n;
    const Vec3Planes P{v + n, v + 2 * n, v + 3 * n};
    for (std::size_t k = 0; k < n; ++k) {
        const DisplacedVertex &vertex = all[which[k]];
        piece[k] = vertex.piece, u[k] = vertex.u, v[k] = vertex.v;
    }

    shape.displacement->move({int(n), piece.data(), u, v}, P);
    for (std::size_t k = 0; k < n; ++k)
        moved[which[k] - firstVertex] = transformPoint(shape.outerFromShape, P.get(int(k)));
}

void DisplacedPoints::move(std::span<const DisplacedDicing> shapes, std::uint32_t firstVertex,
                           std::uint32_t firstPoint) {
    std::vector<std::uint32_t> order(vertices.size() - firstVertex);
    std::iota(order.begin(), order.end(), firstVertex);
    std::ranges::stable_sort(order, {}, [&](std::uint32_t i) { return vertices[i].shape; });
    constexpr std::size_t chunk = 512;
    std::vector<std::pair<std::size_t, std::size_t>> runs;
    for (std::size_t i = 0; i < order.size(); ++i)
        if (i == 0 || vertices[order[i]].shape != vertices[order[i - 1]].shape ||
            i - runs.back().first == chunk)
            runs.emplace_back(i, i + 1);
        else
            ++runs.back().second;
    std::vector<Vec3> moved(order.size());
    parallelFor(runs.size(), [&](std::size_t run) {
        const auto [begin, end] = runs[run];
        moveVertices(*shapes[vertices[order[begin]].shape].shape, vertices,
                     {order.data() + begin, end - begin}, firstVertex, moved.data());
    });
    std::vector<std::uint32_t> shares(points.size() - firstPoint);
    for (std::uint32_t i = 0; i < moved.size(); ++i) {
        const std::uint32_t point = vertices[firstVertex + i].point;
        points[point].moved += moved[i];
        ++shares[point - firstPoint];
    }
    for (std::size_t i = 0; i < shares.size(); ++i)
        points[firstPoint + i].moved *= 1 / float(shares[i]);
}

DisplacedVertex DisplacedPoints::between(std::uint64_t edge, std::uint32_t point) const {
    const DisplacedVertex &a = vertices[firstOf(edge)], &b = vertices[secondOf(edge)];
    DisplacedVertex middle{a.shape, a.piece, point, (a.u + b.u) / 2, (a.v + b.v) / 2};
    if (a.uIsIdle != b.uIsIdle)
        middle.u = a.uIsIdle ? b.u : a.u;
    if (a.vIsIdle != b.vIsIdle)
        middle.v = a.vIsIdle ? b.v : a.v;
    middle.uIsIdle = a.uIsIdle && b.uIsIdle, middle.vIsIdle = a.vIsIdle && b.vIsIdle;
    return middle;
}

float DisplacedPoints::distance(std::uint32_t vertex, std::uint32_t other) const {
    return length(points[vertices[vertex].point].moved - points[vertices[other].point].moved);
}

std::uint32_t DisplacedPoints::addBetween(std::uint64_t edge) {
    const DisplacedPoint a = points[firstOf(edge)], b = points[secondOf(edge)];
    points.push_back({(a.start + b.start) * 0.5f, {}, std::min(a.edge, b.edge)});
    return std::uint32_t(points.size() - 1);
}

void DisplacedPoints::turnPoles(std::vector<VertexTriple> &triangles) {
    for (VertexTriple &t : triangles)
        for (int k = 0; k < 3; ++k) {
            DisplacedVertex vertex = vertices[t[k]];
            const DisplacedVertex &b = vertices[t[(k + 1) % 3]], &c = vertices[t[(k + 2) % 3]];
            const bool u = vertex.uIsIdle && !b.uIsIdle && !c.uIsIdle;
            const bool v = vertex.vIsIdle && !b.vIsIdle && !c.vIsIdle;
            if (!u && !v)
                continue;
            vertex.u = u ? (b.u + c.u) / 2 : vertex.u;
            vertex.v = v ? (b.v + c.v) / 2 : vertex.v;
            t[k] = std::uint32_t(vertices.size());
            vertices.push_back(vertex);
        }
}

} // namespace candela
