// SPDX-License-Identifier: Apache-2.0
#include "foundation/base/matrix4d.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace candela {

namespace {

using Axis = std::array<double, 3>;

double dot(const Axis &a, const Axis &b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// The unit vector along the axis; zero stays zero.
Axis unit(const Axis &a) {
    double length = std::sqrt(dot(a, a));
    if (length == 0)
        return a;
    return {a[0] / length, a[1] / length, a[2] / length};
}

Axis unit(Vec3 a) { return unit(Axis{a.x, a.y, a.z}); }

/// Sine and cosine, exact at multiples of a right angle.
std::pair<double, double> sineCosine(double degrees) {
    const double quarter = std::remainder(degrees, 360) / 90;
    if (quarter == std::trunc(quarter)) {
        constexpr double sines[] = {0, 1, 0, -1};
        const int turns = (int(quarter) + 4) % 4;
        return {sines[turns], sines[(turns + 1) % 4]};
    }
    const double angle = degrees * M_PI / 180;
    return {std::sin(angle), std::cos(angle)};
}

} // namespace

Matrix4d inDouble(const Matrix4 &matrix) {
    Matrix4d result;
    std::ranges::copy(matrix.m, result.m.begin());
    return result;
}

Matrix4 Matrix4d::rounded() const {
    Matrix4 result;
    std::ranges::transform(m, result.m.begin(), [](double entry) { return float(entry); });
    return result;
}

Matrix4d operator*(const Matrix4d &a, const Matrix4d &b) {
    Matrix4d product;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column) {
            double sum = 0;
            for (int k = 0; k < 4; ++k)
                sum += a.at(row, k) * b.at(k, column);
            product.at(row, column) = sum;
        }
    return product;
}

bool isFinite(const Matrix4d &matrix) {
    return std::ranges::all_of(matrix.m, [](double entry) { return std::isfinite(entry); });
}

std::optional<Matrix4d> inverse(const Matrix4d &matrix) {
    if (!isFinite(matrix))
        return std::nullopt;
    // Gauss-Jordan with partial pivoting on the matrix beside the identity.
    Matrix4d left = matrix, right;
    for (int pivot = 0; pivot < 4; ++pivot) {
        int best = pivot;
        for (int row = pivot + 1; row < 4; ++row)
            if (std::fabs(left.at(row, pivot)) > std::fabs(left.at(best, pivot)))
                best = row;
        if (left.at(best, pivot) == 0)
            return std::nullopt;
        for (Matrix4d *half : {&left, &right})
            std::swap_ranges(half->m.begin() + 4 * pivot, half->m.begin() + 4 * pivot + 4,
                             half->m.begin() + 4 * best);
        const double scale = 1 / left.at(pivot, pivot);
        for (Matrix4d *half : {&left, &right})
            for (int column = 0; column < 4; ++column)
                half->at(pivot, column) *= scale;
        for (int row = 0; row < 4; ++row) {
            if (row == pivot)
                continue;
            const double factor = left.at(row, pivot);
            for (Matrix4d *half : {&left, &right})
                for (int column = 0; column < 4; ++column)
                    half->at(row, column) -= factor * half->at(pivot, column);
        }
    }
    return isFinite(right) ? std::optional(right) : std::nullopt;
}

double determinant3(const Matrix4d &a) {
    auto e = [&](int row, int column) { return a.at(row, column); };
    return e(0, 0) * (e(1, 1) * e(2, 2) - e(1, 2) * e(2, 1)) -
           e(0, 1) * (e(1, 0) * e(2, 2) - e(1, 2) * e(2, 0)) +
           e(0, 2) * (e(1, 0) * e(2, 1) - e(1, 1) * e(2, 0));
}

Matrix4d translationInDouble(double x, double y, double z) {
    return {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1}};
}

Matrix4d scalingInDouble(double x, double y, double z) {
    return {{x, 0, 0, 0, 0, y, 0, 0, 0, 0, z, 0, 0, 0, 0, 1}};
}

Matrix4d rotationInDouble(double degrees, Vec3 axis) {
    const auto [s, c] = sineCosine(degrees);
    const auto [x, y, z] = unit(axis);
    const double k = 1 - c;
    return {{x * x * k + c, x * y * k + z * s, x * z * k - y * s, 0, //
             x * y * k - z * s, y * y * k + c, y * z * k + x * s, 0, //
             x * z * k + y * s, y * z * k - x * s, z * z * k + c, 0, //
             0, 0, 0, 1}};
}

Matrix4d skewInDouble(double degrees, Vec3 dy, Vec3 dx) {
    // A point's height along `dy` (orthogonal to `dx`) moves it by tan(angle) along `dx`,
    // where the angle is the one that turns `dy` by `degrees` towards `dx`.
    const Axis along = unit(dx), turned = unit(dy);
    const double cosine = dot(turned, along);
    const double lean = std::acos(std::clamp(cosine, -1.0, 1.0));
    Axis up;
    for (int i = 0; i < 3; ++i)
        up[i] = turned[i] - along[i] * cosine;
    up = unit(up);
    const double from = M_PI / 2 - lean, to = from + degrees * M_PI / 180;
    const double shear = std::tan(to) - std::tan(from);
    Matrix4d result;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            result.at(row, column) += up[row] * along[column] * shear;
    return result;
}

Matrix4d perspectiveInDouble(double fieldOfViewDegrees) {
    const double scale = 1 / std::tan(fieldOfViewDegrees * M_PI / 360);
    return {{scale, 0, 0, 0, 0, scale, 0, 0, 0, 0, 1, 1, 0, 0, -1, 0}};
}

} // namespace candela
