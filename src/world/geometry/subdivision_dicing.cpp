// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/subdivision_dicing.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace candela {

namespace {

/// A side that is half of an edge.
bool isHalf(const SubdivisionSide &side) { return std::abs(side.toHalf - side.fromHalf) == 1; }

/// Levels of cuts along the sides of a piece.
std::array<int, 4> levelsOf(const SubdivisionPiece &piece, const SubdivisionCuts &cuts) {
    std::array<int, 4> levels;
    for (int side = 0; side < 4; ++side)
        levels[side] = cuts.edges[piece.sides[side].edge] - int(isHalf(piece.sides[side]));
    return levels;
}

/// The points on edges, each once: vertices, then those within edges and spokes, then the middles
/// of faces.
class SharedPoints {
public:
    SharedPoints(const SubdivisionEdges &edges, const SubdivisionCuts &cuts)
        : edges_(edges), cuts_(cuts) {
        std::uint32_t next = edges.vertices;
        for (int level : cuts.edges) {
            firstWithin_.push_back(next);
            next += (1u << level) - 1;
        }
        firstMiddle_ = next;
        places_.resize(next + edges.faces);
        known_.resize(places_.size());
    }

    /// The point at a step of so many along a side.
    std::uint32_t on(const SubdivisionSide &side, int step, int steps) const {
        // In parts of the whole edge.
        const int parts = 1 << cuts_.edges[side.edge];
        const int from = parts * side.fromHalf / 2, to = parts * side.toHalf / 2;
        const int at = from + (to - from) / steps * step;
        return onEdge(side.edge, at, parts);
    }

    /// The place that was first said of the point.
    Vec3 agree(std::uint32_t point, Vec3 place) {
        if (!known_[point])
            places_[point] = place, known_[point] = true;
        return places_[point];
    }

private:
    std::uint32_t onEdge(std::uint32_t edge, int at, int parts) const {
        const bool isSpoke = edge >= edges_.edges.size();
        if (at > 0 && at < parts)
            return firstWithin_[edge] + std::uint32_t(at - 1);
        if (!isSpoke)
            return edges_.edges[edge][at == 0 ? 0 : 1];
        const auto &spoke = edges_.spokes[edge - edges_.edges.size()];
        if (at != 0)
            return firstMiddle_ + spoke.face;
        const int whole = 1 << cuts_.edges[spoke.edge];
        return onEdge(spoke.edge, whole / 2, whole);
    }

    const SubdivisionEdges &edges_;
    const SubdivisionCuts &cuts_;
    std::vector<std::uint32_t> firstWithin_;
    std::uint32_t firstMiddle_ = 0;
    std::vector<Vec3> places_;
    std::vector<bool> known_;
};

/// One piece: its vertices and its triangles.
class PieceDicer {
public:
    PieceDicer(const SubdivisionPiece &piece, const SubdivisionCells &cells,
               const SubdivisionCuts &cuts)
        : piece_(piece), levels_(levelsOf(piece, cuts)) {
        for (const SubdivisionCells::Cell &cell : cells.cells()) {
            std::vector<std::uint32_t> ring;
            cells.goRound(cell, levels_, [&](int u, int v) { ring.push_back(vertexAt(u, v)); });
            if (ring.size() == 4) {
                triangles_.push_back({ring[0], ring[1], ring[2]});
                triangles_.push_back({ring[0], ring[2], ring[3]});
                continue;
            }
            const std::uint32_t middle = vertexAt(cell.u + cell.side / 2, cell.v + cell.side / 2);
            for (std::size_t k = 0; k < ring.size(); ++k)
                triangles_.push_back({middle, ring[k], ring[(k + 1) % ring.size()]});
        }
    }

    /// Appends to the mesh; the surface calls the piece so.
    void finish(std::uint32_t name, const Surface &surface, SharedPoints &shared,
                DicedMesh &mesh) const {
        const std::uint32_t first = std::uint32_t(mesh.positions.size());
        const std::size_t n = places_.size();
        const std::vector<std::uint32_t> names(n, name);
        std::vector<float> planes(5 * n);
        float *u = planes.data(), *v = u + n;
        for (std::size_t k = 0; k < n; ++k) {
            u[k] = float(places_[k][0]) / SubdivisionCells::units;
            v[k] = float(places_[k][1]) / SubdivisionCells::units;
        }
        SurfaceAnswer answer;
        answer.P = {v + n, v + 2 * n, v + 3 * n};
        surface.evaluate({int(n), names.data(), u, v}, answer);
        for (std::size_t k = 0; k < n; ++k) {
            mesh.positions.push_back(agreed(places_[k], answer.P.get(int(k)), shared));
            mesh.vertexUv.push_back({u[k], v[k]});
        }
        for (const auto &[a, b, c] : triangles_)
            mesh.triangles.push_back({first + a, first + b, first + c});
        mesh.pieces.resize(mesh.triangles.size(), name);
    }

private:
    std::uint32_t vertexAt(int u, int v) {
        const auto [entry, isNew] =
            known_.try_emplace(std::uint64_t(u) << 32 | std::uint32_t(v), places_.size());
        if (isNew)
            places_.push_back({u, v});
        return entry->second;
    }

    /// What all pieces say of a place on a side.
    Vec3 agreed(std::array<int, 2> place, Vec3 position, SharedPoints &shared) const {
        for (int side = 0; side < 4; ++side) {
            const int across = place[side < 2 ? 1 : 0], along = place[side < 2 ? 0 : 1];
            if (across != (side % 2 == 0 ? 0 : SubdivisionCells::units))
                continue;
            const int steps = 1 << levels_[side];
            position = shared.agree(
                shared.on(piece_.sides[side], along / (SubdivisionCells::units / steps), steps),
                position);
        }
        return position;
    }

    const SubdivisionPiece &piece_;
    std::array<int, 4> levels_;
    std::unordered_map<std::uint64_t, std::uint32_t> known_;
    std::vector<std::array<int, 2>> places_;
    std::vector<std::array<std::uint32_t, 3>> triangles_;
};

} // namespace

SubdivisionCuts chooseCuts(const SubdivisionShape &shape, const DiceRate &rate) {
    // A rate that is no positive number asks for the finest dicing there is.
    SubdivisionRate wanted{rate.chordError > 0 ? double(rate.chordError) : 0.0,
                           rate.edgeLength > 0 ? double(rate.edgeLength) : 0.0};
    SubdivisionCuts cuts;
    const double most = std::max(maximalCells, double(shape.pieces.size()));
    for (double cells = most + 1; cells > most; --wanted.mostLevels) {
        cuts = {{}, std::vector<int>(shape.edges.edges.size() + shape.edges.spokes.size(), 0)};
        cells = 0;
        for (std::size_t k = 0; k < shape.pieces.size() && cells <= most; ++k) {
            cuts.pieces.emplace_back(*shape.tree, shape.errors, shape.numbers[k], wanted);
            cells += double(cuts.pieces.back().cells().size());
        }
    }
    for (std::size_t k = 0; k < shape.pieces.size(); ++k) {
        cuts.error = std::max(cuts.error, cuts.pieces[k].chord());
        for (int side = 0; side < 4; ++side) {
            const SubdivisionSide &along = shape.pieces[k].sides[side];
            int &level = cuts.edges[along.edge];
            level = std::max(level, cuts.pieces[k].levelAlong(side) + int(isHalf(along)));
        }
    }
    return cuts;
}

double triangleCount(const SubdivisionShape &shape, const SubdivisionCuts &cuts) {
    double count = 0;
    for (std::size_t k = 0; k < shape.pieces.size(); ++k) {
        const std::array<int, 4> levels = levelsOf(shape.pieces[k], cuts);
        for (const SubdivisionCells::Cell &cell : cuts.pieces[k].cells()) {
            int round = 0;
            cuts.pieces[k].goRound(cell, levels, [&](int, int) { ++round; });
            count += round == 4 ? 2 : round; // Two triangles, or a fan about the middle.
        }
    }
    return count;
}

DicedMesh diceSubdivision(const SubdivisionShape &shape, const SubdivisionCuts &cuts,
                          const Surface &surface) {
    DicedMesh mesh;
    SharedPoints shared(shape.edges, cuts);
    for (std::size_t k = 0; k < shape.pieces.size(); ++k)
        PieceDicer(shape.pieces[k], cuts.pieces[k], cuts)
            .finish(std::uint32_t(k), surface, shared, mesh);
    return mesh;
}

} // namespace candela
