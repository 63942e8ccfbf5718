// SPDX-License-Identifier: Apache-2.0
// Splines over any knots, cut into the polynomials that they consist of.
#pragma once

#include "interface/ri/primitive_record.h"
#include "world/geometry/patch_polynomials.h"
#include "world/geometry/side_curve.h"

#include <span>

namespace candela {

/// One polynomial piece of a spline: between two knots, or between them and the ends of what is
/// drawn.
struct SplineSpan {
    int segment = 0; ///< Also the first of its order vertices.
    double begin = 0, end = 1;
    /// Bezier ordinates by vertices, order x order, row by row.
    std::vector<double> ordinates;
};

/// Those that are longer than nothing. The spline must be without defect (interface/ri).
std::vector<SplineSpan> splineSpans(const SplineRecord &);

/// Tensor products of splines.
class SplineMesh {
public:
    explicit SplineMesh(const NuPatchRecord &);

    const PatchGrid &grid() const { return grid_; }
    int vertices() const { return uVertices_ * vVertices_; }
    /// Values at vertices, `components` floats each, as polynomials.
    PatchPolynomials convert(std::span<const float> values, int components) const;
    /// The sides of homogeneous control points, four floats each.
    MeshSides sides(std::span<const float> points) const;

private:
    /// Of one component and patch: rows of `u` times vertices times rows of `v`.
    std::vector<double> product(std::span<const float> values, int components, int component,
                                const SplineSpan &u, const SplineSpan &v,
                                std::span<const double> uRows, std::span<const double> vRows) const;

    int uVertices_, vVertices_, uOrder_, vOrder_;
    std::vector<SplineSpan> u_, v_;
    PatchGrid grid_;
};

} // namespace candela
