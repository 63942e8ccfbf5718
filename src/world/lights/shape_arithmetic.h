// SPDX-License-Identifier: Apache-2.0
// What samplers of shapes share: vectors of doubles, planes of vectors, heights and densities.
#pragma once

#include "foundation/base/vec3.h"

#include <cmath>
#include <limits>

namespace candela {

struct Double3 {
    double x, y, z;
};

inline Double3 operator+(Double3 a, Double3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Double3 operator-(Double3 a, Double3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Double3 operator*(Double3 a, double s) { return {a.x * s, a.y * s, a.z * s}; }
inline double dot(Double3 a, Double3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Double3 cross(Double3 a, Double3 b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Double3 wide(Vec3 a) { return {a.x, a.y, a.z}; }
inline Vec3 narrow(Double3 a) { return {float(a.x), float(a.y), float(a.z)}; }

/// Three planes from lane `first` on, their pointers read ahead of the loop.
template <class Vector> struct Columns {
    Columns(const float *const planes[3], int first = 0)
        : x(planes[0] + first), y(planes[1] + first), z(planes[2] + first) {}
    Vector operator[](int i) const { return {x[i], y[i], z[i]}; }
    const float *x, *y, *z;
};

inline void store(float *const planes[3], int i, Vec3 p) {
    planes[0][i] = p.x, planes[1][i] = p.y, planes[2][i] = p.z;
}

inline constexpr float largestDensity = std::numeric_limits<float>::max();

/// A density as callers get it; false comparisons turn NaN to 0.
inline float rounded(double density) {
    return density <= double(largestDensity) ? float(density) : 0.0f;
}

/// Distance of P from a plane through `corner`, 0 if it's but rounding.
[[gnu::always_inline]] inline double heightOver(Double3 toCorner, Double3 unitNormal) {
    double height = std::fabs(dot(toCorner, unitNormal));
    double scale = std::fabs(toCorner.x) + std::fabs(toCorner.y) + std::fabs(toCorner.z);
    return height > 4e-15 * scale ? height : 0.0;
}

} // namespace candela
