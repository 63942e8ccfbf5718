// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/swept_dicing.h"

#include <numbers>
#include <optional>

namespace candela {

namespace {

class SweptDicer {
public:
    explicit SweptDicer(const SweptGrid &grid)
        : grid_(grid), columns_(grid.counts.columns + 1), rows_(grid.counts.rows + 1) {}

    DicedMesh run() {
        chooseAngles();
        const double cell = 2 * std::numbers::pi / grid_.counts.turn;
        widening_ = std::sqrt(cell / std::sin(cell));
        mesh_.positions.reserve(std::size_t(columns_) * (rows_ + grid_.counts.poles));
        mesh_.vertexUv.reserve(mesh_.positions.capacity());
        mesh_.triangles.reserve(std::size_t(grid_.counts.triangles()));
        for (int row = 0; row < rows_; ++row)
            addRow(row);
        if (isPole(grid_.row.front()))
            poleStart_ = addPole(0, grid_.row.front());
        if (isPole(grid_.row.back()))
            poleEnd_ = addPole(1, grid_.row.back());
        for (int row = 0; row < grid_.counts.rows; ++row)
            for (int column = 0; column < grid_.counts.columns; ++column)
                addCell(column, row);
        return std::move(mesh_);
    }

private:
    std::uint32_t vertex(int column, int row) const {
        return std::uint32_t(row) * std::uint32_t(columns_) + std::uint32_t(column);
    }
    bool isPole(Vec3 end) const { return std::hypot(end.x, end.y) <= grid_.poleRadius; }

    /// Multiples of a cell, the same whatever is swept; a full turn comes back to the first.
    void chooseAngles() {
        constexpr double full = 2 * std::numbers::pi;
        int last = grid_.counts.columns, turn = grid_.counts.turn;
        double cells = turn * std::abs(grid_.sweep) / full;
        bool aligned = std::abs(cells - last) <= 1e-6;
        for (int column = 0; column <= last; ++column) {
            bool multiple = column < last || aligned;
            double angle = multiple ? full * (column % turn) / turn : std::abs(grid_.sweep);
            turns_.push_back(turnBy(std::copysign(angle, grid_.sweep)));
            us_.push_back(column < last ? float(column / cells) : 1.0f);
        }
    }

    void addRow(int row) {
        Vec3 p = grid_.row[grid_.closedV && row == grid_.counts.rows ? 0 : row];
        float t = float(row) / float(grid_.counts.rows);
        for (int column = 0; column < columns_; ++column) {
            Turn turn = turns_[column];
            mesh_.positions.push_back({float((p.x * turn.cosine - p.y * turn.sine) * widening_),
                                       float((p.x * turn.sine + p.y * turn.cosine) * widening_),
                                       p.z});
            mesh_.vertexUv.push_back({us_[column], t});
        }
    }

    /// A vertex for each column of triangles, all in one place: u at a pole is that of the middle
    /// of the triangle.
    std::uint32_t addPole(float t, Vec3 position) {
        auto first = std::uint32_t(mesh_.positions.size());
        for (int column = 0; column < grid_.counts.columns; ++column) {
            mesh_.positions.push_back({0, 0, position.z});
            mesh_.vertexUv.push_back({(us_[column] + us_[column + 1]) / 2, t});
        }
        return first;
    }

    void addCell(int column, int row) {
        std::uint32_t a = vertex(column, row), b = vertex(column + 1, row);
        std::uint32_t c = vertex(column, row + 1), d = vertex(column + 1, row + 1);
        bool startsAtPole = poleStart_ && row == 0;
        bool endsAtPole = poleEnd_ && row == grid_.counts.rows - 1;
        if (startsAtPole) {
            mesh_.triangles.push_back({*poleStart_ + std::uint32_t(column), d, c});
        } else if (endsAtPole) {
            mesh_.triangles.push_back({a, b, *poleEnd_ + std::uint32_t(column)});
        } else {
            mesh_.triangles.push_back({a, b, d});
            mesh_.triangles.push_back({a, d, c});
        }
    }

    SweptGrid grid_;
    int columns_;
    int rows_;
    std::vector<Turn> turns_; ///< Of each column's angle.
    std::vector<float> us_;
    double widening_ = 1; ///< Of circles to polygons, which then have the circles' areas.
    DicedMesh mesh_;
    std::optional<std::uint32_t> poleStart_, poleEnd_;
};

} // namespace

DicedMesh diceSwept(const SweptGrid &grid) { return SweptDicer(grid).run(); }

} // namespace candela
