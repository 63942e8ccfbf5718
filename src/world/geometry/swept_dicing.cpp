// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/swept_dicing.h"

#include <cmath>
#include <optional>

namespace candela {

namespace {

class SweptDicer {
public:
    explicit SweptDicer(const SweptGrid &grid)
        : grid_(grid), columns_(grid.cells.u + 1), rows_(grid.cells.v + 1) {}

    DicedMesh run(const Surface &surface) {
        addGridVertices();
        evaluatePositions(surface);
        closeSeams();
        if (isPole(grid_.first))
            poleStart_ = addPole(0, grid_.first);
        if (isPole(grid_.last))
            poleEnd_ = addPole(1, grid_.last);
        addTriangles();
        return std::move(mesh_);
    }

private:
    std::uint32_t vertex(int column, int row) const {
        return std::uint32_t(row) * std::uint32_t(columns_) + std::uint32_t(column);
    }
    bool isPole(Vec3 end) const { return std::hypot(end.x, end.y) <= grid_.poleRadius; }

    void addGridVertices() {
        mesh_.vertexUv.reserve(std::size_t(columns_) * rows_);
        for (int row = 0; row < rows_; ++row)
            for (int column = 0; column < columns_; ++column)
                mesh_.vertexUv.push_back(
                    {float(column) / float(grid_.cells.u), float(row) / float(grid_.cells.v)});
    }

    void evaluatePositions(const Surface &surface) {
        std::size_t count = mesh_.vertexUv.size();
        std::vector<float> planes(count * 5);
        float *u = planes.data(), *v = u + count;
        for (std::size_t k = 0; k < count; ++k)
            u[k] = mesh_.vertexUv[k][0], v[k] = mesh_.vertexUv[k][1];
        SurfaceAnswer answer;
        answer.P = {v + count, v + 2 * count, v + 3 * count};
        surface.evaluate({int(count), nullptr, u, v}, answer);
        mesh_.positions.reserve(count);
        for (std::size_t k = 0; k < count; ++k)
            mesh_.positions.push_back(answer.P.get(int(k)));
    }

    void closeSeams() {
        for (int row = 0; grid_.closedU && row < rows_; ++row)
            mesh_.positions[vertex(columns_ - 1, row)] = mesh_.positions[vertex(0, row)];
        for (int column = 0; grid_.closedV && column < columns_; ++column)
            mesh_.positions[vertex(column, rows_ - 1)] = mesh_.positions[vertex(column, 0)];
    }

    /// A vertex for each column of triangles, all in one place: u at a pole is that of the middle
    /// of the triangle.
    std::uint32_t addPole(float t, Vec3 position) {
        auto first = std::uint32_t(mesh_.positions.size());
        for (int column = 0; column < grid_.cells.u; ++column) {
            mesh_.positions.push_back({0, 0, position.z});
            mesh_.vertexUv.push_back({(float(column) + 0.5f) / float(grid_.cells.u), t});
        }
        return first;
    }

    void addTriangles() {
        for (int row = 0; row < grid_.cells.v; ++row)
            for (int column = 0; column < grid_.cells.u; ++column)
                addCell(column, row);
    }

    void addCell(int column, int row) {
        std::uint32_t a = vertex(column, row), b = vertex(column + 1, row);
        std::uint32_t c = vertex(column, row + 1), d = vertex(column + 1, row + 1);
        bool startsAtPole = poleStart_ && row == 0;
        bool endsAtPole = poleEnd_ && row == grid_.cells.v - 1;
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
    DicedMesh mesh_;
    std::optional<std::uint32_t> poleStart_, poleEnd_;
};

} // namespace

DicedMesh diceSwept(const SweptGrid &grid, const Surface &surface) {
    return SweptDicer(grid).run(surface);
}

} // namespace candela
