// SPDX-License-Identifier: Apache-2.0
// A polygon in the plane, and the questions that triangulation asks of it.
#pragma once

#include <vector>

namespace candela {

struct FlatPoint {
    double x = 0, y = 0;
    friend bool operator==(const FlatPoint &, const FlatPoint &) = default;
};

/// A corner of a loop: where it is, and which vertex of the mesh it stands for.
struct FlatVertex {
    FlatPoint place;
    int index = 0;
};

using FlatLoop = std::vector<FlatVertex>;

/// Twice the area of the triangle, positive if counter-clockwise. For float coordinates the sign
/// is right to within the last bits of a double.
inline double turn(FlatPoint a, FlatPoint b, FlatPoint c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Twice the signed area.
double doubleArea(const FlatLoop &);

/// Is p in the triangle or on its border? The triangle turns counter-clockwise.
inline bool inTriangle(FlatPoint p, FlatPoint a, FlatPoint b, FlatPoint c) {
    return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
}

/// Does the direction from `corner` to p point strictly into the inside of the polygon, which at
/// this corner comes from `previous` and goes on to `next`, counter-clockwise?
bool pointsInside(FlatPoint previous, FlatPoint corner, FlatPoint next, FlatPoint p);

/// Do the segments ab and cd have a point in common, other than a common end point?
bool segmentsMeet(FlatPoint a, FlatPoint b, FlatPoint c, FlatPoint d);

/// Joins the holes (clockwise) to the outside (counter-clockwise) by bridges that are walked both
/// ways, so that one loop remains. Returns false if a hole could not be joined and was left out.
bool bridgeHoles(FlatLoop &outside, std::vector<FlatLoop> holes);

} // namespace candela
