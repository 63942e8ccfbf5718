// SPDX-License-Identifier: Apache-2.0
// Arguments as C has them, to those of sinks; how many values primitives have. Private to the room.
#pragma once

#include "interface/ri/request_types.h"
#include "interface/ri/variable_counts.h"
#include "ri.h"

#include <algorithm>
#include <numeric>
#include <string>

namespace candela::c {

inline std::string text(RtToken token) { return token ? token : ""; }
/// Zero numbers where there are none.
inline std::size_t countOf(RtInt n, const void *values) {
    return values ? std::size_t(std::max(n, 0)) : 0;
}
inline Floats floats(RtInt n, const RtFloat *values) {
    return Floats(values, values + countOf(n, values));
}
inline Integers integers(RtInt n, const RtInt *values) {
    return Integers(values, values + countOf(n, values));
}
inline Strings texts(RtInt n, const RtToken *values) {
    Strings result;
    for (std::size_t i = 0; i < countOf(n, values); ++i)
        result.push_back(text(values[i]));
    return result;
}
inline RtInt sum(RtInt n, const RtInt *values) {
    return std::accumulate(values, values + countOf(n, values), 0);
}
/// One more than the largest.
inline RtInt above(RtInt n, const RtInt *values) {
    const std::size_t count = countOf(n, values);
    return count ? *std::max_element(values, values + count) + 1 : 0;
}
inline candela::Color colorOf(const RtFloat *color) {
    return candela::Color(color[0], color[1], color[2]);
}
inline Matrix4 matrixOf(const RtFloat (*rows)[4]) {
    Matrix4 matrix;
    std::copy(&rows[0][0], &rows[0][0] + 16, matrix.m.begin());
    return matrix;
}
// How many values variables have (RI 3.2, section 5).
inline constexpr VariableCounts single{1, 1, 1, 1, 1}, quadric{};
inline VariableCounts polygonCounts(int polygons, int corners, int vertices) {
    return {polygons, vertices, vertices, corners, corners};
}
inline VariableCounts pointCounts(int points) { return {1, points, points, points, points}; }
inline VariableCounts leafCounts(int leaves) { return {leaves, leaves, leaves, leaves, leaves}; }
inline VariableCounts volumeCounts(const RtInt *dimensions) {
    return pointCounts(dimensions ? dimensions[0] * dimensions[1] * dimensions[2] : 0);
}
inline VariableCounts nuPatchCounts(int uVertices, int uOrder, int vVertices, int vOrder) {
    const int u = uVertices - uOrder + 1, v = vVertices - vOrder + 1;
    const int vertices = uVertices * vVertices, corners = (u + 1) * (v + 1);
    return {u * v, corners, vertices, corners, vertices};
}

} // namespace candela::c
