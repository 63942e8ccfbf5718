// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/patch_dicing.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace candela {

static double sum(const std::vector<int> &counts) {
    return std::accumulate(counts.begin(), counts.end(), 0.0);
}

PatchCuts choosePatchCuts(const PatchGrid &grid, std::span<const PatchBounds> bounds,
                          const DiceRate &rate) {
    PatchCuts cuts{std::vector<int>(grid.patchesU, 1), std::vector<int>(grid.patchesV, 1), 0};
    double share = std::max(1.0, maximalCells / grid.patches());
    for (int patch = 0; patch < grid.patches(); ++patch) {
        DiceCounts counts = chooseCounts(bounds[patch].derivatives, rate, {1, 1}, share);
        int &column = cuts.columns[patch % grid.patchesU], &row = cuts.rows[patch / grid.patchesU];
        column = std::max(column, counts.u);
        row = std::max(row, counts.v);
    }
    // Columns and rows take the most of their patches, which together can be too much.
    double excess = std::sqrt(sum(cuts.columns) * sum(cuts.rows) / maximalCells);
    if (excess > 1)
        for (auto *counts : {&cuts.columns, &cuts.rows})
            for (int &count : *counts)
                count = std::max(1, int(count / excess));
    for (int patch = 0; patch < grid.patches(); ++patch) {
        DiceCounts counts{cuts.columns[patch % grid.patchesU], cuts.rows[patch / grid.patchesU]};
        cuts.error = std::max(cuts.error, cellError(bounds[patch].derivatives, counts));
    }
    return cuts;
}

double triangleCount(const PatchGrid &grid, const PatchCuts &cuts,
                     std::span<const PatchBounds> bounds) {
    double triangles = 2 * sum(cuts.columns) * sum(cuts.rows);
    for (int patch = 0; patch < grid.patches(); ++patch) {
        const auto &point = bounds[patch].collapsed;
        double columns = cuts.columns[patch % grid.patchesU];
        double rows = cuts.rows[patch / grid.patchesU];
        triangles -= columns * (point[0] + point[1]) + rows * (point[2] + point[3]);
        triangles += (point[0] && point[3]) + (point[1] && point[2]); // Of one cell's one triangle.
    }
    return triangles;
}

namespace {

/// Parameters of the cuts of patches [from, to), ends included.
std::vector<float> cutsOf(const std::vector<int> &counts, int from, int to) {
    std::vector<float> parameters;
    double patches = double(counts.size());
    for (int patch = from; patch < to; ++patch)
        for (int i = 0; i < counts[patch]; ++i)
            parameters.push_back(float((patch + double(i) / counts[patch]) / patches));
    parameters.push_back(float(to / patches));
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

    void closeSeams(bool closedU, bool closedV) {
        for (std::size_t row = 0; closedU && row < rows_; ++row)
            meet(vertex(columns_ - 1, row), vertex(0, row));
        for (std::size_t column = 0; closedV && column < columns_; ++column)
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
    for (int v = 0; v < grid.patchesV; row += cuts.rows[v++]) {
        std::size_t column = 0;
        for (int u = 0; u < grid.patchesU; column += cuts.columns[u++])
            patches.push_back(
                {column, row, cuts.columns[u], cuts.rows[v], bounds[patches.size()].collapsed});
    }
    return patches;
}

static DicedMesh diceTogether(const PatchGrid &grid, const PatchCuts &cuts, const Surface &surface,
                              const PatchOutline &outline) {
    PatchDicer dicer(surface, outline.tolerance);
    dicer.addGrid(cutsOf(cuts.columns, 0, grid.patchesU), cutsOf(cuts.rows, 0, grid.patchesV));
    std::vector<PatchCells> patches = cellsOf(grid, cuts, outline.patches);
    for (int side = 0; side < 4; ++side)
        for (std::size_t k = 0; k < outline.sides[side].size(); ++k) {
            std::size_t column = side < 2 ? k : side == 2 ? 0 : grid.patchesU - 1;
            std::size_t row = side >= 2 ? k : side == 0 ? 0 : grid.patchesV - 1;
            dicer.placeSide(patches[row * grid.patchesU + column], side, outline.sides[side][k]);
        }
    for (const PatchCells &cells : patches)
        dicer.collapse(cells);
    dicer.closeSeams(grid.periodicU, grid.periodicV);
    for (const PatchCells &cells : patches)
        dicer.addTriangles(cells);
    return dicer.take();
}

static DicedMesh diceApart(const PatchGrid &grid, const PatchCuts &cuts, const Surface &surface,
                           const PatchOutline &outline) {
    PatchDicer dicer(surface, outline.tolerance);
    for (int row = 0; row < grid.patchesV; ++row)
        for (int column = 0; column < grid.patchesU; ++column) {
            auto us = cutsOf(cuts.columns, column, column + 1);
            auto vs = cutsOf(cuts.rows, row, row + 1);
            stayWithin(us, column + 1 == grid.patchesU);
            stayWithin(vs, row + 1 == grid.patchesV);
            PatchCells cells{0, 0, cuts.columns[column], cuts.rows[row],
                             outline.patches[row * grid.patchesU + column].collapsed};
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
