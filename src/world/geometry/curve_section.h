// SPDX-License-Identifier: Apache-2.0
// Points of the two forms that a curve may have: a tube round it, or a ribbon across a normal.
#pragma once

#include "world/geometry/curve_layout.h"

namespace candela {

/// One cubic of a curve with all that makes a surface of it.
struct CurveSegment {
    std::array<CurveOrdinates, 3> position;
    CurveOrdinates width; ///< Diameter of a tube, width of a ribbon.
    /// Of a ribbon; of tubes they are not looked at.
    std::array<CurveOrdinates, 3> normal{};

    Vec3 at(float v) const;
    Vec3 slopeAt(float v) const;
    /// The unit vector along the curve, also where its control points coincide.
    Vec3 tangentAt(float v) const;
    /// No derivative of the curve is longer.
    float largestSlope() const;
};

/// What stands between the two.
CurveSegment between(const CurveSegment &, const CurveSegment &, float share);

/// A point, its derivatives by u (across, or once around) and by v (along the segment), and the
/// normal dPdu x dPdv, of any length but zero.
struct SectionPoint {
    Vec3 P, dPdu, dPdv, Ng;
};

/// The frame that angles on a tube are counted in: x x y is the tangent.
struct TubeFrame {
    Vec3 x, y, tangent;
};
/// `axis`: any direction that the curve does not run along.
TubeFrame tubeFrame(const CurveSegment &, Vec3 axis, float v);

/// Circles about the curve and at right angles to it; the normal points outwards.
SectionPoint tubePoint(const CurveSegment &, Vec3 axis, float u, float v);
/// Lines through the curve, at right angles to it and the normal.
SectionPoint ribbonPoint(const CurveSegment &, float u, float v);

} // namespace candela
