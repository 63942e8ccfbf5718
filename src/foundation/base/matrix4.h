// SPDX-License-Identifier: Apache-2.0
// 4x4 transformations in the RenderMan convention: points are row vectors, so p' = p * M, and
// `A * B` means "first A, then B". A matrix that takes object space to current space is named
// currentFromObject.
#pragma once

#include "foundation/base/vec3.h"

#include <array>
#include <optional>

namespace candela {

struct Matrix4 {
    std::array<float, 16> m{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

    float &at(int row, int column) { return m[row * 4 + column]; }
    float at(int row, int column) const { return m[row * 4 + column]; }
    friend bool operator==(const Matrix4 &, const Matrix4 &) = default;
};

Matrix4 operator*(const Matrix4 &a, const Matrix4 &b);
/// Nothing if the matrix is singular or not finite. Computed in double precision.
std::optional<Matrix4> inverse(const Matrix4 &);
/// Determinant of the upper 3x3 part: negative if the transformation mirrors.
double determinant3(const Matrix4 &);
inline bool flipsHandedness(const Matrix4 &m) { return determinant3(m) < 0; }

Matrix4 translation(float x, float y, float z);
Matrix4 scaling(float x, float y, float z);
/// RiRotate: `degrees` about the axis through the origin, left-handed positive in left-handed
/// space (so the usual right-hand rule in right-handed space).
Matrix4 rotation(float degrees, Vec3 axis);
/// RiSkew: shear by `degrees` of points along `dy` towards `dx`.
Matrix4 skew(float degrees, Vec3 dy, Vec3 dx);
/// RiPerspective: the pinhole at the origin looking along +z, depth mapped as z' = z - 1 over z.
Matrix4 perspective(float fieldOfViewDegrees);

/// p * M with the homogeneous divide.
Vec3 transformPoint(const Matrix4 &, Vec3 p);
/// v * M without translation.
Vec3 transformVector(const Matrix4 &, Vec3 v);
/// A normal, given the inverse of the matrix that points are transformed by.
Vec3 transformNormal(const Matrix4 &inverseOfPointMatrix, Vec3 n);

} // namespace candela
