// SPDX-License-Identifier: Apache-2.0
// Patches by their Bezier ordinates, whose hull holds the patch: what patches are bounded by.
#pragma once

#include "world/geometry/dice_counts.h"
#include "world/geometry/patch_polynomials.h"

#include <span>

namespace candela {

/// A component's Bezier ordinates along u and v.
struct BezierNet {
    int sizeU = 4, sizeV = 4;
    std::vector<double> ordinates; ///< v runs fastest.

    BezierNet(int sizeU, int sizeV)
        : sizeU(sizeU), sizeV(sizeV), ordinates(std::size_t(sizeU) * std::size_t(sizeV)) {}
    double &at(int i, int j) { return ordinates[std::size_t(i * sizeV + j)]; }
    double at(int i, int j) const { return ordinates[std::size_t(i * sizeV + j)]; }
};

/// Cubic Bezier ordinates of u^i: b_k = sum over i <= k of C(k,i)/C(3,i) c_i.
inline constexpr double ordinatesOfPowers[4][4] = {
    {1, 0, 0, 0}, {1, 1.0 / 3, 0, 0}, {1, 2.0 / 3, 1.0 / 3, 0}, {1, 1, 1, 1}};

/// Of degree 3 where the coefficients are those of powers.
BezierNet bezierNet(const PatchPolynomials &, int patch, int component);

/// Bounds of the derivatives of the patch that has these components.
DerivativeBounds derivativeBounds(std::span<const BezierNet>);

/// The same of a quotient: the last component is what the others are divided by. Its ordinates are
/// positive.
DerivativeBounds rationalDerivatives(std::vector<BezierNet>);

/// What is known of one patch: components 3 are x, y, z; 4 are homogeneous.
struct PatchBounds {
    bool valid = true; ///< False if a weight may vanish.
    Box3 box;
    DerivativeBounds derivatives; ///< By u and v within the patch.
    double coefficientSum = 0;    ///< Largest sum of magnitudes: what rounding is relative to.
    /// Sides that are a point to within rounding: v = 0, v = 1, u = 0, u = 1.
    std::array<bool, 4> collapsed{};
};
PatchBounds patchBounds(const PatchPolynomials &positions, int patch);

/// Not of sizes beyond which products of lengths leave the range of floats.
bool hasUsableSize(const Box3 &);

/// Does every patch end where its neighbour begins? Not under every basis and step.
bool patchesMeet(const PatchGrid &, const PatchPolynomials &positions, double tolerance);

} // namespace candela
