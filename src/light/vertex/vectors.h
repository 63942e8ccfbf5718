// SPDX-License-Identifier: Apache-2.0
// Vectors that lie in planes, and what densities are weighed by.
#pragma once

#include "foundation/base/vec3.h"
#include "light/sampling/cone_mixture.h"

namespace candela {

inline double square(double x) { return x * x; }

inline Vec3 at(const ConstVec3Planes &planes, int i) {
    return {planes[0][i], planes[1][i], planes[2][i]};
}
inline void put(const MutableVec3Planes &planes, int i, const Vec3 &value) {
    for (int c = 0; c < 3; ++c)
        planes[c][i] = value[c];
}
inline ConstVec3Planes constant(const MutableVec3Planes &planes) {
    return {planes[0], planes[1], planes[2]};
}

} // namespace candela
