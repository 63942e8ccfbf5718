// SPDX-License-Identifier: Apache-2.0
// Plain loops over planes that evaluation is made of.
#pragma once

#include "foundation/base/matrix4.h"
#include "world/geometry/surface.h"

#include <cstdint>

namespace candela {

/// No triangle: what is given is (u,v) of the surface already.
inline constexpr std::uint32_t noTriangle = 0xffffffff;

/// (u,v) of the dicing's triangles becomes (u,v) of the surface: corners by triangle number.
void interpolateUv(int count, const std::uint32_t *triangle, const float *baryU, const float *baryV,
                   const std::array<std::uint32_t, 3> *triangles,
                   const std::array<float, 2> *vertexUv, float *u, float *v);

void transformPoints(int count, const Matrix4 &, Vec3Planes);
void transformVectors(int count, const Matrix4 &, Vec3Planes);
/// Normals, given the inverse of the matrix for points; times `sign`.
void transformNormals(int count, const Matrix4 &inverse, float sign, Vec3Planes);

/// to[place[i]] = from[i].
void scatter(int count, const std::int32_t *place, const float *from, float *to);

/// to = a - b.
void subtract(int count, const float *a, const float *b, float *to);
/// offset += share of max(|x|,|y|,|z|).
void addRounding(int count, Vec3Planes P, float share, float *offset);

} // namespace candela
