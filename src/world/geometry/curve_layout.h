// SPDX-License-Identifier: Apache-2.0
// The pieces of RiCurves: one cubic a segment, whatever basis it came in, and the primitive
// variables along them (RI 3.2, 5.6).
#pragma once

#include "foundation/base/diagnostics.h"
#include "interface/ri/primitive_record.h"
#include "world/geometry/primitive_variables.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace candela {

/// Bezier ordinates along a segment.
using CurveOrdinates = std::array<float, 4>;

/// A cubic at a place, and its derivatives by it.
struct CubicAt {
    float value, slope, bend;
};

inline CubicAt cubicAt(const CurveOrdinates &b, float v) {
    const float w = 1 - v;
    const float d0 = b[1] - b[0], d1 = b[2] - b[1], d2 = b[3] - b[2];
    return {w * w * (w * b[0] + 3 * v * b[1]) + v * v * (3 * w * b[2] + v * b[3]),
            3 * (w * w * d0 + 2 * w * v * d1 + v * v * d2), 6 * (w * (d1 - d0) + v * (d2 - d1))};
}

/// Where the segments of all curves take their values.
class CurveLayout {
public:
    CurveLayout(const CurvesRecord &, const BasisRecord &);

    std::uint32_t segments() const { return std::uint32_t(curveOf_.size()); }
    std::uint32_t curves() const { return std::uint32_t(curves_.size()); }
    std::uint32_t curveOf(std::uint32_t segment) const { return curveOf_[segment]; }
    bool isCubic() const { return cubic_; }
    /// How many segments the curve of this one has, and how many stand before it.
    std::uint32_t segmentsBeside(std::uint32_t segment) const;
    std::uint32_t segmentsBefore(std::uint32_t segment) const;
    /// The segments that end where this one begins, and begin where it ends, if any do.
    std::optional<std::uint32_t> previous(std::uint32_t segment) const;
    std::optional<std::uint32_t> next(std::uint32_t segment) const;

    /// The number of values that a class has.
    int valuesOf(StorageClass) const;
    /// A component's values along a segment.
    CurveOrdinates ordinates(const NumericVariable &, std::uint32_t segment, int component) const;

private:
    struct Curve {
        std::uint32_t firstSegment, firstVertex, firstEnd, vertices;
    };

    const Curve &of(std::uint32_t segment) const { return curves_[curveOf_[segment]]; }
    std::uint32_t segmentsOf(const Curve &) const;

    bool cubic_, periodic_;
    std::uint32_t step_;
    std::uint32_t vertices_ = 0, ends_ = 0;
    /// Row: a Bezier ordinate; column: a control point of the basis.
    std::array<std::array<float, 4>, 4> bezierFromBasis_{};
    std::vector<Curve> curves_;
    std::vector<std::uint32_t> curveOf_; ///< By segment.
};

} // namespace candela
