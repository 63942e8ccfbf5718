// SPDX-License-Identifier: Apache-2.0
#include "foundation/base/matrix4.h"

#include "foundation/base/matrix4d.h"

#include <algorithm>
#include <cmath>

namespace candela {

Matrix4 operator*(const Matrix4 &a, const Matrix4 &b) {
    Matrix4 product;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column) {
            float sum = 0;
            for (int k = 0; k < 4; ++k)
                sum += a.at(row, k) * b.at(k, column);
            product.at(row, column) = sum;
        }
    return product;
}

std::optional<Matrix4> inverse(const Matrix4 &matrix) {
    std::optional<Matrix4d> exact = inverse(inDouble(matrix));
    if (!exact)
        return std::nullopt;
    Matrix4 result = exact->rounded();
    bool finite = std::ranges::all_of(result.m, [](float entry) { return std::isfinite(entry); });
    return finite ? std::optional(result) : std::nullopt;
}

double determinant3(const Matrix4 &a) { return determinant3(inDouble(a)); }

Matrix4 translation(float x, float y, float z) {
    return {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1}};
}

Matrix4 scaling(float x, float y, float z) {
    return {{x, 0, 0, 0, 0, y, 0, 0, 0, 0, z, 0, 0, 0, 0, 1}};
}

Matrix4 rotation(float degrees, Vec3 axis) { return rotationInDouble(degrees, axis).rounded(); }

Matrix4 skew(float degrees, Vec3 dy, Vec3 dx) { return skewInDouble(degrees, dy, dx).rounded(); }

Matrix4 perspective(float fieldOfViewDegrees) {
    return perspectiveInDouble(fieldOfViewDegrees).rounded();
}

Vec3 transformPoint(const Matrix4 &a, Vec3 p) {
    Vec3 r{p.x * a.at(0, 0) + p.y * a.at(1, 0) + p.z * a.at(2, 0) + a.at(3, 0),
           p.x * a.at(0, 1) + p.y * a.at(1, 1) + p.z * a.at(2, 1) + a.at(3, 1),
           p.x * a.at(0, 2) + p.y * a.at(1, 2) + p.z * a.at(2, 2) + a.at(3, 2)};
    float w = p.x * a.at(0, 3) + p.y * a.at(1, 3) + p.z * a.at(2, 3) + a.at(3, 3);
    return w == 1 ? r : r / w;
}

Vec3 transformVector(const Matrix4 &a, Vec3 v) {
    return {v.x * a.at(0, 0) + v.y * a.at(1, 0) + v.z * a.at(2, 0),
            v.x * a.at(0, 1) + v.y * a.at(1, 1) + v.z * a.at(2, 1),
            v.x * a.at(0, 2) + v.y * a.at(1, 2) + v.z * a.at(2, 2)};
}

Vec3 transformNormal(const Matrix4 &i, Vec3 n) {
    return {n.x * i.at(0, 0) + n.y * i.at(0, 1) + n.z * i.at(0, 2),
            n.x * i.at(1, 0) + n.y * i.at(1, 1) + n.z * i.at(1, 2),
            n.x * i.at(2, 0) + n.y * i.at(2, 1) + n.z * i.at(2, 2)};
}

} // namespace candela
