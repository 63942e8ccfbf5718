// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/patch_surface.h"

#include <cmath>

namespace candela {

/// How fast a coordinate within a patch runs by the query's.
static double spread(const PatchAxis &axis, int patch) {
    return std::abs(axis.speed(patch) * (axis.high - axis.low));
}

PatchSurface::PatchSurface(const PatchGrid &grid, PatchPolynomials positions,
                           std::vector<PatchBounds> bounds, MeshSides sides,
                           GridVariables variables)
    : grid_(grid), positions_(std::move(positions), bounds), patchBounds_(std::move(bounds)),
      variables_(std::move(variables)) {
    for (int k = 0; k < grid_.patches(); ++k) {
        const PatchBounds &patch = patchBounds_[k];
        const double alongU = patch.derivatives.du * spread(grid_.u, k % grid_.u.patches);
        const double alongV = patch.derivatives.dv * spread(grid_.v, k / grid_.u.patches);
        bound_.add(patch.box);
        // Of the polynomials, and of that float.
        roundingError_ =
            std::max(roundingError_, 4e-7 * patch.coefficientSum + 2e-7 * (alongU + alongV));
    }
    const PatchPolynomials &polynomials = positions_.polynomials();
    outline_ = {patchBounds_, std::move(sides), patchesMeet(grid_, polynomials, roundingError_),
                float(4 * roundingError_)};
    Vec3 margin{float(roundingError_), float(roundingError_), float(roundingError_)};
    bound_ = {bound_.low - margin, bound_.high + margin};
}

std::array<double, 2> PatchSurface::longestDerivatives() const {
    std::array<double, 2> longest{0, 0};
    for (int k = 0; k < grid_.patches(); ++k) {
        const DerivativeBounds &d = patchBounds_[k].derivatives;
        longest[0] = std::max(longest[0], d.du * spread(grid_.u, k % grid_.u.patches));
        longest[1] = std::max(longest[1], d.dv * spread(grid_.v, k / grid_.u.patches));
    }
    return longest;
}

void PatchSurface::evaluate(const SurfaceQuery &query, const SurfaceAnswer &answer) const {
    const float rangeU = grid_.u.high - grid_.u.low, rangeV = grid_.v.high - grid_.v.low;
    PatchPoints points;
    for (int start = 0; start < query.count; start += PatchPoints::capacity) {
        locate(grid_, query.u + start, query.v + start,
               std::min(query.count - start, points.capacity), points);
        positions_.evaluate(points, start, answer);
        for (int i = 0; i < points.count; ++i) {
            const int k = start + i;
            if (answer.areaScale)
                answer.areaScale[k] *= rangeU * rangeV;
            if (answer.u)
                answer.u[k] = grid_.u.low + points.meshU[i] * rangeU;
            if (answer.v)
                answer.v[k] = grid_.v.low + points.meshV[i] * rangeV;
        }
    }
    if (answer.N.x || answer.dNdu.x || answer.dNdv.x)
        variables_.overrideNormals(query.count, query.u, query.v, answer.N, answer.dNdu,
                                   answer.dNdv);
}

void PatchSurface::evaluateVariable(int index, const SurfaceQuery &query, float *const *value,
                                    float *const *valueDu, float *const *valueDv) const {
    variables_.evaluate(index, 0, query.count, query.u, query.v, value, valueDu, valueDv);
}

bool PatchSurface::hasArea() const {
    for (int patch = 0; patch < grid_.patches(); ++patch)
        if (positions_.hasArea(patch))
            return true;
    return false;
}

float PatchSurface::area() const {
    double sum = 0;
    for (int patch = 0; patch < grid_.patches(); ++patch)
        sum += positions_.area(patch);
    return float(sum);
}

PatchCuts PatchSurface::cutsAt(const DiceRate &rate) const {
    return choosePatchCuts(grid_, patchBounds_, rate);
}

double PatchSurface::triangleCount(const DiceRate &rate) const {
    return candela::triangleCount(grid_, cutsAt(rate), patchBounds_);
}

DicedMesh PatchSurface::dice(const DiceRate &rate) const {
    PatchCuts cuts = cutsAt(rate);
    DicedMesh mesh = dicePatches(grid_, cuts, *this, outline_);
    mesh.chordError = float(cuts.error) + outline_.tolerance;
    return mesh;
}

} // namespace candela
