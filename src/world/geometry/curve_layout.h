// SPDX-License-Identifier: Apache-2.0
// The pieces of RiCurves: one cubic a segment, whatever basis it came in, and the primitive
// variables along them (RI 3.2, 5.6).
#pragma once

#include "foundation/base/diagnostics.h"
#include "interface/ri/primitive_record.h"
#include "world/geometry/moment.h"
#include "world/geometry/primitive_variables.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace candela {

/// Bezier ordinates along a segment.
using CurveOrdinates = std::array<float, 4>;

/// What goes straight from the one to the other.
inline CurveOrdinates between(const CurveOrdinates &from, const CurveOrdinates &to, float share) {
    CurveOrdinates result;
    for (std::size_t k = 0; k < result.size(); ++k)
        result[k] = from[k] * (1 - share) + to[k] * share;
    return result;
}

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

    std::uint32_t segments() const { return segments_; }
    std::uint32_t curves() const { return count_; }
    std::uint32_t curveOf(std::uint32_t segment) const {
        return areAlike_ ? segment / curves_.front().segments : curveOf_[segment];
    }
    bool isCubic() const { return cubic_; }
    /// How many segments the curve of this one has, and how many stand before it.
    std::uint32_t segmentsBeside(std::uint32_t segment) const;
    std::uint32_t segmentsBefore(std::uint32_t segment) const;
    /// The segments that end where this one begins, and begin where it ends, if any do.
    std::optional<std::uint32_t> previous(std::uint32_t segment) const;
    std::optional<std::uint32_t> next(std::uint32_t segment) const;

    /// The number of values that a class has.
    int valuesOf(StorageClass) const;
    /// A component's values along a segment. Of what changes its shape a variable has the values of
    /// all steps, one step's after the other's.
    CurveOrdinates ordinates(const NumericVariable &, std::uint32_t segment, int component,
                             int step = 0) const;
    CurveOrdinates ordinates(const NumericVariable &, std::uint32_t segment, int component,
                             Moment) const;

private:
    struct Curve {
        std::uint32_t firstSegment, firstVertex, firstEnd, vertices, segments;
    };

    Curve of(std::uint32_t segment) const;
    std::uint32_t endsOf(const Curve &curve) const { return curve.segments + (periodic_ ? 0 : 1); }

    bool cubic_, periodic_;
    std::uint32_t step_;
    std::uint32_t vertices_ = 0, ends_ = 0;
    /// Row: a Bezier ordinate; column: a control point of the basis.
    std::array<std::array<float, 4>, 4> bezierFromBasis_{};
    std::uint32_t count_ = 0, segments_ = 0;
    bool areAlike_ = false;              ///< All curves have as many vertices as the first.
    std::vector<Curve> curves_;          ///< One where all are alike,
    std::vector<std::uint32_t> curveOf_; ///< and none of these, by segment.
};

} // namespace candela
