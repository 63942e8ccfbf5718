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
    /// Sides that are a point to within rounding: v = 0, v = 1, u = 0, u = 1.
    std::array<bool, 4> collapsed{};
};

/// One side of a patch by its own control points alone, so that patches which share a side agree
/// about it to the last bit, whichever way they run along it. Homogeneous Bezier ordinates, rounded
/// to float: those of a Bezier patch are its control points.
struct SideCurve {
    int degree = 3; ///< 1: only the ends count.
    std::array<std::array<float, 4>, 4> ordinates{};

    /// The point at step/steps of the way.
    Vec3 at(int step, int steps) const;
};

/// The sides of the patches round a mesh, in the order of PatchBounds::collapsed; homogeneous
/// control points, four floats each.
std::array<std::vector<SideCurve>, 4> sideCurves(const PatchTopology &,
                                                 std::span<const float> points);

/// Does every patch end where its neighbour begins? Not under every basis and step.
bool patchesMeet(const PatchGrid &, const PatchPolynomials &positions, double tolerance);

PatchBounds patchBounds(const PatchPolynomials &positions, int patch);

} // namespace candela
