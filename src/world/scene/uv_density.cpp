// SPDX-License-Identifier: Apache-2.0
#include "world/scene/uv_density.h"

#include "world/scene/light_table.h"

#include <algorithm>
#include <cmath>

namespace candela {

namespace {

constexpr int cells = UvDensity::cells;
constexpr int gauss = 2 * cells; ///< Two Gauss points a cell along u.

float gaussPoint(int index) {
    constexpr float low = 0.21132486540518713f;
    return (float(index / 2) + (index % 2 ? 1 - low : low)) / cells;
}

/// Transformed area per unit (u,v) at the Gauss points of one line of constant v.
void jacobians(const Surface &surface, const Matrix4 &matrix, float v, double *jacobian) {
    float us[gauss], vs[gauss];
    std::uint32_t pieces[gauss] = {};
    for (int k = 0; k < gauss; ++k)
        us[k] = gaussPoint(k), vs[k] = v;
    float area[gauss], planes[3 * gauss];
    transformedAreas(surface, matrix, {gauss, pieces, us, vs}, planes, area);
    for (int k = 0; k < gauss; ++k)
        jacobian[k] = std::isfinite(area[k]) ? area[k] : 0;
}

int cellOf(float x) { return std::clamp(int(x * cells), 0, cells - 1); }

} // namespace

void transformedAreas(const Surface &surface, const Matrix4 &matrix, const SurfaceQuery &query,
                      float *scratch, float *area) {
    SurfaceAnswer answer;
    answer.Ng = {scratch, scratch + query.count, scratch + 2 * query.count};
    answer.areaScale = area;
    surface.evaluate(query, answer);
    auto row = [&](int k) { return Vec3{matrix.at(k, 0), matrix.at(k, 1), matrix.at(k, 2)}; };
    // Area vectors transform by the cofactors.
    Vec3 x = cross(row(1), row(2)), y = cross(row(2), row(0)), z = cross(row(0), row(1));
    for (int k = 0; k < query.count; ++k) {
        Vec3 n = answer.Ng.get(k);
        n *= 1 / std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)});
        area[k] *= length(x * n.x + y * n.y + z * n.z) / length(n);
    }
}

UvDensity::UvDensity(const Surface &surface, const Matrix4 &currentFromObject)
    : density_(cells * cells, 0) {
    std::vector<double> mass(cells * cells, 0);
    double jacobian[gauss];
    for (int line = 0; line < gauss; ++line) {
        jacobians(surface, currentFromObject, gaussPoint(line), jacobian);
        for (int k = 0; k < gauss; ++k)
            mass[line / 2 * cells + k / 2] += jacobian[k] / (4.0 * cells * cells);
    }
    for (double part : mass)
        area_ += part;
    if (!(area_ > 0))
        return;
    double below = 0;
    for (int row = 0; row < cells; ++row) {
        double sum = 0;
        for (int column = 0; column < cells; ++column) {
            double part = mass[row * cells + column];
            density_[row * cells + column] = float(part / area_ * cells * cells);
            columns_.push_back(sum += part);
        }
        rows_.push_back(below += sum);
        if (sum > 0)
            for (int column = 0; column < cells; ++column)
                columns_[row * cells + column] /= sum;
    }
    for (double &share : rows_)
        share /= below;
}

void UvDensity::sample(float x, float y, float &u, float &v) const {
    double alongV = y, alongU = x;
    int row = chooseByCumulative(rows_, alongV);
    const double *columns = columns_.data() + row * cells;
    int column = chooseByCumulative({columns, std::size_t(cells)}, alongU);
    u = std::min(float((column + alongU) / cells), 1.0f);
    v = std::min(float((row + alongV) / cells), 1.0f);
}

float UvDensity::at(float u, float v) const { return density_[cellOf(v) * cells + cellOf(u)]; }

void UvDensity::scale(float factor) {
    for (float &density : density_)
        density *= factor;
}

} // namespace candela
