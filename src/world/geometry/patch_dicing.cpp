// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/patch_dicing.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace candela {

static double sum(const std::vector<int> &counts) {
    return std::accumulate(counts.begin(), counts.end(), 0.0);
}

PatchCuts choosePatchCuts(const PatchGrid &grid, std::span<const DerivativeBounds> bounds,
                          const DiceRate &rate) {
    PatchCuts cuts{std::vector<int>(grid.patchesU, 1), std::vector<int>(grid.patchesV, 1), 0};
    double share = std::max(1.0, maximalCells / grid.patches());
    for (int patch = 0; patch < grid.patches(); ++patch) {
        DiceCounts counts = chooseCounts(bounds[patch], rate, {1, 1}, share);
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
    for (int patch = 0; patch < grid.patches(); ++patch)
        cuts.error =
            std::max(cuts.error, cellError(bounds[patch], {cuts.columns[patch % grid.patchesU],
                                                           cuts.rows[patch / grid.patchesU]}));
    return cuts;
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

class PatchDicer {
public:
    PatchDicer(const Surface &surface, float tolerance)
        : surface_(surface), tolerance_(tolerance) {}

    /// Adds a grid of vertices and its triangles; `closed` sides meet themselves.
    void addGrid(const std::vector<float> &us, const std::vector<float> &vs, bool closedU,
                 bool closedV) {
        first_ = mesh_.positions.size();
        columns_ = us.size();
        for (float v : vs)
            addRow(us, v);
        closeSeams(vs.size(), closedU, closedV);
        for (std::size_t row = 0; row + 1 < vs.size(); ++row)
            for (std::size_t column = 0; column + 1 < columns_; ++column)
                addCell(column, row);
    }

    DicedMesh take() { return std::move(mesh_); }

private:
    std::size_t vertex(std::size_t column, std::size_t row) const {
        return first_ + row * columns_ + column;
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

    void closeSeams(std::size_t rows, bool closedU, bool closedV) {
        for (std::size_t row = 0; closedU && row < rows; ++row)
            meet(vertex(columns_ - 1, row), vertex(0, row));
        for (std::size_t column = 0; closedV && column < columns_; ++column)
            meet(vertex(column, rows - 1), vertex(column, 0));
    }

    void addCell(std::size_t column, std::size_t row) {
        auto a = std::uint32_t(vertex(column, row)), b = std::uint32_t(vertex(column + 1, row));
        auto c = std::uint32_t(vertex(column, row + 1));
        auto d = std::uint32_t(vertex(column + 1, row + 1));
        addTriangle(a, b, d);
        addTriangle(a, d, c);
    }

    /// Where an edge has collapsed nothing is left of one triangle.
    void addTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        const auto &p = mesh_.positions;
        if (p[a] != p[b] && p[b] != p[c] && p[c] != p[a])
            mesh_.triangles.push_back({a, b, c});
    }

    const Surface &surface_;
    float tolerance_;
    DicedMesh mesh_;
    std::size_t first_ = 0, columns_ = 0;
};

/// The last parameter below the end of a patch that still belongs to it.
void stayWithin(std::vector<float> &parameters, bool lastPatch) {
    if (!lastPatch)
        parameters.back() = std::nextafter(parameters.back(), 0.0f);
}

} // namespace

DicedMesh dicePatches(const PatchGrid &grid, const PatchCuts &cuts, const Surface &surface,
                      bool patchesMeet, float tolerance) {
    PatchDicer dicer(surface, tolerance);
    if (patchesMeet) {
        dicer.addGrid(cutsOf(cuts.columns, 0, grid.patchesU), cutsOf(cuts.rows, 0, grid.patchesV),
                      grid.periodicU, grid.periodicV);
        return dicer.take();
    }
    for (int row = 0; row < grid.patchesV; ++row)
        for (int column = 0; column < grid.patchesU; ++column) {
            auto us = cutsOf(cuts.columns, column, column + 1);
            auto vs = cutsOf(cuts.rows, row, row + 1);
            stayWithin(us, column + 1 == grid.patchesU);
            stayWithin(vs, row + 1 == grid.patchesV);
            dicer.addGrid(us, vs, false, false);
        }
    return dicer.take();
}

} // namespace candela
