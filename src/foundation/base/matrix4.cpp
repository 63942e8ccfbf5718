// SPDX-License-Identifier: Apache-2.0
#include "foundation/base/matrix4.h"

#include <cmath>
#include <utility>

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
    // Gauss-Jordan with partial pivoting on the matrix beside the identity.
    double work[4][8];
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column) {
            work[row][column] = matrix.at(row, column);
            work[row][column + 4] = row == column;
            if (!std::isfinite(work[row][column]))
                return std::nullopt;
        }
    for (int pivot = 0; pivot < 4; ++pivot) {
        int best = pivot;
        for (int row = pivot + 1; row < 4; ++row)
            if (std::fabs(work[row][pivot]) > std::fabs(work[best][pivot]))
                best = row;
        if (work[best][pivot] == 0)
            return std::nullopt;
        std::swap(work[pivot], work[best]);
        double scale = 1 / work[pivot][pivot];
        for (double &entry : work[pivot])
            entry *= scale;
        for (int row = 0; row < 4; ++row) {
            if (row == pivot)
                continue;
            double factor = work[row][pivot];
            for (int column = 0; column < 8; ++column)
                work[row][column] -= factor * work[pivot][column];
        }
    }
    Matrix4 result;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column) {
            result.at(row, column) = float(work[row][column + 4]);
            if (!std::isfinite(result.at(row, column)))
                return std::nullopt;
        }
    return result;
}

double determinant3(const Matrix4 &a) {
    auto e = [&](int r, int c) { return double(a.at(r, c)); };
    return e(0, 0) * (e(1, 1) * e(2, 2) - e(1, 2) * e(2, 1)) -
           e(0, 1) * (e(1, 0) * e(2, 2) - e(1, 2) * e(2, 0)) +
           e(0, 2) * (e(1, 0) * e(2, 1) - e(1, 1) * e(2, 0));
}

Matrix4 translation(float x, float y, float z) {
    return {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1}};
}

Matrix4 scaling(float x, float y, float z) {
    return {{x, 0, 0, 0, 0, y, 0, 0, 0, 0, z, 0, 0, 0, 0, 1}};
}

Matrix4 rotation(float degrees, Vec3 axis) {
    Vec3 a = normalize(axis);
    double angle = degrees * M_PI / 180;
    double s = std::sin(angle), c = std::cos(angle), k = 1 - c;
    double x = a.x, y = a.y, z = a.z;
    auto f = [](double value) { return float(value); };
    return {{f(x * x * k + c), f(x * y * k + z * s), f(x * z * k - y * s), 0, //
             f(x * y * k - z * s), f(y * y * k + c), f(y * z * k + x * s), 0, //
             f(x * z * k + y * s), f(y * z * k - x * s), f(z * z * k + c), 0, //
             0, 0, 0, 1}};
}

Matrix4 skew(float degrees, Vec3 dy, Vec3 dx) {
    // A point's height along `dy` (orthogonal to `dx`) moves it by tan(angle) along `dx`,
    // where the angle is the one that turns `dy` by `degrees` towards `dx`.
    Vec3 along = normalize(dx);
    Vec3 unit = normalize(dy);
    double lean = std::acos(std::fmax(-1.0, std::fmin(1.0, dot(unit, along))));
    Vec3 up = normalize(unit - along * dot(unit, along));
    double from = M_PI / 2 - lean, to = from + degrees * M_PI / 180;
    float shear = float(std::tan(to) - std::tan(from));
    Matrix4 result;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            result.at(row, column) += up[row] * along[column] * shear;
    return result;
}

Matrix4 perspective(float fieldOfViewDegrees) {
    float scale = float(1 / std::tan(fieldOfViewDegrees * M_PI / 360));
    return {{scale, 0, 0, 0, 0, scale, 0, 0, 0, 0, 1, 1, 0, 0, -1, 0}};
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
