// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/patch_dicing.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace candela {

static double sum(const std::vector<int> &counts) {
    return std::accumulate(counts.begin(), counts.end(), 0.0);
}

/// The ladder 1, 2, 3, 4, 6, 8, 12...: patches that share a side and are much alike agree about it.
static int onLadder(int count) {
    int step = 1;
    while (step < count)
        step = step > 1 && step * 3 / 2 >= count ? step * 3 / 2 : step * 2;
    return step;
}

PatchCuts choosePatchCuts(const PatchGrid &grid, std::span<const PatchBounds> bounds,
                          const DiceRate &rate) {
    PatchCuts cuts{std::vector<int>(grid.u.patches, 1), std::vector<int>(grid.v.patches, 1), 0};
    double share = std::max(1.0, maximalCells / grid.patches());
    for (int patch = 0; patch < grid.patches(); ++patch) {
        // Between two sides that are points one row has no inside.
        int least = std::ranges::count(bounds[patch].collapsed, true) >= 2 ? 2 : 1;
        DiceCounts counts = chooseCounts(bounds[patch].derivatives, rate, {least, least}, share);
        // Nearly as many one way as the other become equal, so that it makes no difference to
        // neighbours which way a patch that bends alike both ways runs along their side.
        if (std::max(counts.u, counts.v) <= 1.2 * std::min(counts.u, counts.v) + 1)
            counts.u = counts.v = std::max(counts.u, counts.v);
        int &column = cuts.columns[patch % grid.u.patches],
            &row = cuts.rows[patch / grid.u.patches];
        column = std::max(column, onLadder(counts.u));
        row = std::max(row, onLadder(counts.v));
    }
    // Columns and rows take the most of their patches, which together can be too much.
    double excess = std::sqrt(sum(cuts.columns) * sum(cuts.rows) / maximalCells);
    if (excess > 1)
        for (auto *counts : {&cuts.columns, &cuts.rows})
            for (int &count : *counts)
                count = std::max(1, int(count / excess));
    for (int patch = 0; patch < grid.patches(); ++patch) {
        DiceCounts counts{cuts.columns[patch % grid.u.patches], cuts.rows[patch / grid.u.patches]};
        cuts.error = std::max(cuts.error, cellError(bounds[patch].derivatives, counts));
    }
    return cuts;
}

double triangleCount(const PatchGrid &grid, const PatchCuts &cuts,
                     std::span<const PatchBounds> bounds) {
    double triangles = 2 * sum(cuts.columns) * sum(cuts.rows);
    for (int patch = 0; patch < grid.patches(); ++patch) {
        const auto &point = bounds[patch].collapsed;
        double columns = cuts.columns[patch % grid.u.patches];
        double rows = cuts.rows[patch / grid.u.patches];
        triangles -= columns * (point[0] + point[1]) + rows * (point[2] + point[3]);
        triangles += (point[0] && point[3]) + (point[1] && point[2]); // Of one cell's one triangle.
    }
    return triangles;
}

namespace {

/// Parameters of the cuts of patches [from, to), ends included.
std::vector<float> cutsOf(const PatchAxis &axis, const std::vector<int> &counts, int from, int to) {
    std::vector<float> parameters;
    for (int patch = from; patch < to; ++patch)
        for (int i = 0; i < counts[patch]; ++i)
            parameters.push_back(float(axis.at(patch, double(i) / counts[patch])));
    parameters.push_back(float(axis.at(to - 1, 1)));
    return parameters;
}

/// One patch's cells within a grid of vertices.
struct PatchCells {
    std::size_t column = 0, row = 0; ///< Where it begins.
    int columns = 1, rows = 1;
    std::array<bool, 4> collapsed{};
};

class PatchDicer {
public:
    PatchDicer(const Surface &surface, float tolerance)
        : surface_(surface), tolerance_(tolerance) {}

    /// Adds a grid of vertices.
    void addGrid(const std::vector<float> &us, const std::vector<float> &vs) {
        first_ = mesh_.positions.size();
        columns_ = us.size(), rows_ = vs.size();
        for (float v : vs)
            addRow(us, v);
    }

    /// Puts a side of a patch onto its curve; sides as in PatchBounds::collapsed.
    void placeSide(const PatchCells &cells, int side, const SideCurve &curve) {
        int steps = side < 2 ? cells.columns : cells.rows;
        for (int i = 0; i <= steps; ++i) {
            Vec3 place = curve.at(i, steps), &position = mesh_.positions[onSide(cells, side, i)];
            if (length(place - position) <= tolerance_)
                position = place;
        }
    }

    void collapse(const PatchCells &cells) {
        for (int side = 0; side < 4; ++side)
            for (int i = 1; cells.collapsed[side] && i <= (side < 2 ? cells.columns : cells.rows);
                 ++i)
                mesh_.positions[onSide(cells, side, i)] = mesh_.positions[onSide(cells, side, 0)];
    }

    /// Ends that meet are one: those of periodic meshes, and of what was modelled closed.
    void closeSeams() {
        for (std::size_t row = 0; row < rows_; ++row)
            meet(vertex(columns_ - 1, row), vertex(0, row));
        for (std::size_t column = 0; column < columns_; ++column)
            meet(vertex(column, rows_ - 1), vertex(column, 0));
    }

    /// Where a side is a point nothing is left of one triangle.
    void addTriangles(const PatchCells &cells) {
        const auto &point = cells.collapsed;
        for (int row = 0; row < cells.rows; ++row)
            for (int column = 0; column < cells.columns; ++column) {
                auto corner = [&](int right, int up) {
                    return std::uint32_t(
                        vertex(cells.column + column + right, cells.row + row + up));
                };
                bool atEnd = column + 1 == cells.columns, atTop = row + 1 == cells.rows;
                if (!(point[0] && row == 0) && !(point[3] && atEnd))
                    mesh_.triangles.push_back({corner(0, 0), corner(1, 0), corner(1, 1)});
                if (!(point[1] && atTop) && !(point[2] && column == 0))
                    mesh_.triangles.push_back({corner(0, 0), corner(1, 1), corner(0, 1)});
            }
    }

    DicedMesh take() { return std::move(mesh_); }

private:
    std::size_t vertex(std::size_t column, std::size_t row) const {
        return first_ + row * columns_ + column;
    }
    std::size_t onSide(const PatchCells &cells, int side, int step) const {
        std::size_t column = side < 2 ? step : side == 2 ? 0 : cells.columns;
        std::size_t row = side >= 2 ? step : side == 0 ? 0 : cells.rows;
        return vertex(cells.column + column, cells.row + row);
    }

    void addRow(const std::vector<float> &us, float v) {
        std::size_t n = us.size(), start = mesh_.positions.size();
        std::vector<float> planes(4 * n, v);
        SurfaceAnswer answer;
        answer.P = {&planes[n], &planes[2 * n], &planes[3 * n]};
        surface_.evaluate({int(n), nullptr, us.data(), planes.data()}, answer);
        mesh_.positions.resize(start + n);
        for (std::size_t i = 0; i < n; ++i) {
            mesh_.positions[start + i] = answer.P.get(int(i));
            mesh_.vertexUv.push_back({us[i], v});
        }
    }

    void meet(std::size_t moved, std::size_t fixed) {
        if (length(mesh_.positions[moved] - mesh_.positions[fixed]) <= tolerance_)
            mesh_.positions[moved] = mesh_.positions[fixed];
    }

    const Surface &surface_;
    float tolerance_;
    DicedMesh mesh_;
    std::size_t first_ = 0, columns_ = 0, rows_ = 0;
};

/// The last parameter below the end of a patch that still belongs to it.
void stayWithin(std::vector<float> &parameters, bool lastPatch) {
    if (!lastPatch)
        parameters.back() = std::nextafter(parameters.back(), 0.0f);
}

} // namespace

/// Every patch's cells in the grid of the whole mesh.
static std::vector<PatchCells> cellsOf(const PatchGrid &grid, const PatchCuts &cuts,
                                       std::span<const PatchBounds> bounds) {
    std::vector<PatchCells> patches;
    std::size_t row = 0;
    for (int v = 0; v < grid.v.patches; row += cuts.rows[v++]) {
        std::size_t column = 0;
        for (int u = 0; u < grid.u.patches; column += cuts.columns[u++])
            patches.push_back(
                {column, row, cuts.columns[u], cuts.rows[v], bounds[patches.size()].collapsed});
    }
    return patches;
}

static DicedMesh diceTogether(const PatchGrid &grid, const PatchCuts &cuts, const Surface &surface,
                              const PatchOutline &outline) {
    PatchDicer dicer(surface, outline.tolerance);
    dicer.addGrid(cutsOf(grid.u, cuts.columns, 0, grid.u.patches),
                  cutsOf(grid.v, cuts.rows, 0, grid.v.patches));
    std::vector<PatchCells> patches = cellsOf(grid, cuts, outline.patches);
    for (int side = 0; side < 4; ++side)
        for (std::size_t k = 0; k < outline.sides[side].size(); ++k) {
            std::size_t column = side < 2 ? k : side == 2 ? 0 : grid.u.patches - 1;
            std::size_t row = side >= 2 ? k : side == 0 ? 0 : grid.v.patches - 1;
            dicer.placeSide(patches[row * grid.u.patches + column], side, outline.sides[side][k]);
        }
    for (const PatchCells &cells : patches)
        dicer.collapse(cells);
    dicer.closeSeams();
    for (const PatchCells &cells : patches)
        dicer.addTriangles(cells);
    return dicer.take();
}

static DicedMesh diceApart(const PatchGrid &grid, const PatchCuts &cuts, const Surface &surface,
                           const PatchOutline &outline) {
    PatchDicer dicer(surface, outline.tolerance);
    for (int row = 0; row < grid.v.patches; ++row)
        for (int column = 0; column < grid.u.patches; ++column) {
            auto us = cutsOf(grid.u, cuts.columns, column, column + 1);
            auto vs = cutsOf(grid.v, cuts.rows, row, row + 1);
            stayWithin(us, column + 1 == grid.u.patches);
            stayWithin(vs, row + 1 == grid.v.patches);
            PatchCells cells{0, 0, cuts.columns[column], cuts.rows[row],
                             outline.patches[row * grid.u.patches + column].collapsed};
            dicer.addGrid(us, vs);
            dicer.collapse(cells);
            dicer.addTriangles(cells);
        }
    return dicer.take();
}

DicedMesh dicePatches(const PatchGrid &grid, const PatchCuts &cuts, const Surface &surface,
                      const PatchOutline &outline) {
    return outline.patchesMeet ? diceTogether(grid, cuts, surface, outline)
                               : diceApart(grid, cuts, surface, outline);
}

} // namespace candela
