// SPDX-License-Identifier: Apache-2.0
// Plain loops over planes that evaluation is made of.
#pragma once

#include "foundation/base/matrix4.h"
#include "world/geometry/surface.h"

#include <cstdint>

namespace candela {

/// (u,v) of elements becomes (u,v) of the surface: corners by element number.
void interpolateUv(int count, const std::uint32_t *element, const float *baryU, const float *baryV,
                   const std::array<std::uint32_t, 3> *triangles,
                   const std::array<float, 2> *vertexUv, float *u, float *v);

void transformPoints(int count, const Matrix4 &, Vec3Planes);
void transformVectors(int count, const Matrix4 &, Vec3Planes);
/// Normals, given the inverse of the matrix for points.
void transformNormals(int count, const Matrix4 &inverse, Vec3Planes);

/// The same with a matrix a point: that of row[i], 32 floats a row, a matrix and its inverse.
void transformPointsEach(int count, const float *matrices, const std::uint32_t *row, Vec3Planes);
void transformVectorsEach(int count, const float *matrices, const std::uint32_t *row, Vec3Planes);
void transformNormalsEach(int count, const float *matrices, const std::uint32_t *row, Vec3Planes);

/// to[place[i]] = from[i].
void scatter(int count, const std::int32_t *place, const float *from, float *to);

/// to = a - b.
void subtract(int count, const float *a, const float *b, float *to);
/// Unit length, times a sign each; vectors without length stay as they are.
void makeUnit(int count, const float *sign, Vec3Planes);
/// offset = min(offset, share of |P|), P being seen from the eye.
void limitOffsets(int count, Vec3Planes P, const float *share, float *offset);
/// offset += share of max(|x|,|y|,|z|).
void addRounding(int count, Vec3Planes P, float share, float *offset);

} // namespace candela
