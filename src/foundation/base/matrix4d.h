// SPDX-License-Identifier: Apache-2.0
// Matrix4 in double precision, for composing: chains of transformations are multiplied here and
// rounded once, when the world gets them. Conventions as in matrix4.h.
#pragma once

#include "foundation/base/matrix4.h"

#include <array>
#include <optional>

namespace candela {

struct Matrix4d {
    std::array<double, 16> m{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

    double &at(int row, int column) { return m[row * 4 + column]; }
    double at(int row, int column) const { return m[row * 4 + column]; }
    /// To the nearest floats; entries beyond their range become infinite.
    Matrix4 rounded() const;
    friend bool operator==(const Matrix4d &, const Matrix4d &) = default;
};

Matrix4d inDouble(const Matrix4 &);
Matrix4d operator*(const Matrix4d &a, const Matrix4d &b);
/// Nothing if the matrix is singular or not finite.
std::optional<Matrix4d> inverse(const Matrix4d &);
/// See determinant3(const Matrix4 &).
double determinant3(const Matrix4d &);
inline bool flipsHandedness(const Matrix4d &m) { return determinant3(m) < 0; }
bool isFinite(const Matrix4d &);

Matrix4d translationInDouble(double x, double y, double z);
Matrix4d scalingInDouble(double x, double y, double z);
/// The factors of RiRotate, RiSkew and RiPerspective: see matrix4.h.
Matrix4d rotationInDouble(double degrees, Vec3 axis);
Matrix4d skewInDouble(double degrees, Vec3 dy, Vec3 dx);
Matrix4d perspectiveInDouble(double fieldOfViewDegrees);

} // namespace candela
