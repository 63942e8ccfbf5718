// SPDX-License-Identifier: Apache-2.0
// From control points to patch polynomials, and what those polynomials are bounded by.
#pragma once

#include "world/geometry/dice_counts.h"
#include "world/geometry/patch_polynomials.h"

#include <optional>
#include <span>
#include <string>

namespace candela {

/// How the control points of a RiPatchMesh make patches.
struct PatchTopology {
    PatchGrid grid;
    bool bicubic = false;
    int uVertices = 0, vVertices = 0;
    int uStep = 1, vStep = 1;
    std::array<float, 16> uBasis{}, vBasis{}; ///< Bicubic only; rows as in BasisRecord.

    int degree() const { return bicubic ? 3 : 1; }
    int vertices() const { return uVertices * vVertices; }
};

/// The topology of a mesh under these bases, or a sentence why there is none.
std::optional<PatchTopology> patchTopology(const PatchMeshRecord &, const Attributes &,
                                           std::string &why);

/// Values at control points, `components` floats each, as polynomials.
PatchPolynomials convertVertices(const PatchTopology &, std::span<const float> values,
                                 int components);

/// A component's Bezier ordinates of degree 3, [i][j] along u and v: their hull holds the patch.
using BezierNet = std::array<std::array<double, 4>, 4>;
BezierNet bezierNet(const PatchPolynomials &, int patch, int component);

/// What is known of one patch: components 3 are x, y, z; 4 are homogeneous.
struct PatchBounds {
    bool valid = true; ///< False if a weight may vanish.
    Box3 box;
    DerivativeBounds derivatives; ///< By u and v within the patch.
    double coefficientSum = 0;    ///< Largest sum of magnitudes: what rounding is relative to.
};
/// Does every patch end where its neighbour begins? Not under every basis and step.
bool patchesMeet(const PatchGrid &, const PatchPolynomials &positions, double tolerance);

PatchBounds patchBounds(const PatchPolynomials &positions, int patch);

} // namespace candela
