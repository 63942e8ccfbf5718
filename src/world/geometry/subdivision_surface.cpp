// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/subdivision_surface.h"

#include <algorithm>

namespace candela {

SubdivisionSurface::SubdivisionSurface(SubdivisionShape shape, PatchPositions positions,
                                       std::span<const PatchBounds> leaves,
                                       SubdivisionVariables variables)
    : shape_(std::move(shape)), positions_(std::move(positions)), variables_(std::move(variables)) {
    for (std::size_t k = 0; k < leaves.size(); ++k) {
        const PatchBounds &leaf = leaves[k];
        bound_.add(leaf.box);
        // Of the polynomials, and of the float that says where on the piece.
        const double slopes = leaf.derivatives.du + leaf.derivatives.dv;
        roundingError_ =
            std::max(roundingError_,
                     4e-7 * leaf.coefficientSum + 2e-7 * slopes / shape_.tree->leaves()[k].side());
    }
    Vec3 margin{float(roundingError_), float(roundingError_), float(roundingError_)};
    bound_ = {bound_.low - margin, bound_.high + margin};
}

bool SubdivisionSurface::hasArea() const {
    for (std::size_t leaf = 0; leaf < shape_.tree->leaves().size(); ++leaf)
        if (positions_.hasArea(int(leaf)))
            return true;
    return false;
}

float SubdivisionSurface::area() const {
    double sum = 0;
    for (std::size_t leaf = 0; leaf < shape_.tree->leaves().size(); ++leaf)
        sum += positions_.area(int(leaf));
    return float(sum);
}

void SubdivisionSurface::evaluate(const SurfaceQuery &query, const SurfaceAnswer &answer) const {
    PatchPoints points;
    std::array<std::uint32_t, PatchPoints::capacity> piece{};
    for (int start = 0; start < query.count; start += PatchPoints::capacity) {
        const int count = std::min(query.count - start, points.capacity);
        for (int k = 0; k < count; ++k)
            piece[k] = shape_.numbers[query.piece[start + k]];
        shape_.tree->locate(count, piece.data(), query.u + start, query.v + start, points);
        positions_.evaluate(points, start, answer);
        if (answer.u)
            std::copy_n(points.meshU.begin(), count, answer.u + start);
        if (answer.v)
            std::copy_n(points.meshV.begin(), count, answer.v + start);
    }
    if (answer.N.x || answer.dNdu.x || answer.dNdv.x)
        variables_.overrideNormals(query, answer);
}

void SubdivisionSurface::evaluateVariable(int index, const SurfaceQuery &query, float *const *value,
                                          float *const *valueDu, float *const *valueDv) const {
    variables_.evaluate(index, query, value, valueDu, valueDv);
}

double SubdivisionSurface::triangleCount(const DiceRate &rate) const {
    return candela::triangleCount(shape_, chooseCuts(shape_, rate));
}

DicedMesh SubdivisionSurface::dice(const DiceRate &rate) const {
    const SubdivisionCuts cuts = chooseCuts(shape_, rate);
    DicedMesh mesh = diceSubdivision(shape_, cuts, *this);
    mesh.chordError = float(cuts.error + 4 * roundingError_);
    return mesh;
}

} // namespace candela
