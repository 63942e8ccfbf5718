// SPDX-License-Identifier: Apache-2.0
// Trim curves (RI 3.2, section 5.2) as an attribute of NURBS.
#pragma once

#include "interface/ri/primitive_record.h"

#include <optional>
#include <string>
#include <vector>

namespace candela {

/// A rational curve in the (u,v) of a NuPatch.
struct TrimCurveRecord {
    SplineRecord spline;
    std::vector<float> u, v, w; ///< Of each vertex; homogeneous.
};

/// Loops of curves, each curve beginning where the one before it ends.
using TrimRecord = std::vector<std::vector<TrimCurveRecord>>;

/// The numbers of a TrimCurve request, as RI writes them: all curves' together.
struct TrimNumbers {
    std::vector<int> curveCounts, orders, vertexCounts;
    std::vector<float> knots, minima, maxima, u, v, w;
};

/// The loops, or nothing and what is wrong.
std::optional<TrimRecord> readTrim(const TrimNumbers &, std::string &why);

/// Keeps numbers that can be read among the named attributes ("trimcurve:..."); none at all trim
/// nothing.
void keepTrim(const TrimNumbers &, Attributes &);
TrimRecord trimOf(const Attributes &);
/// What lies inside is cut away, not what lies outside: Attribute "trimcurve" "string sense".
bool trimsInside(const Attributes &);

} // namespace candela
