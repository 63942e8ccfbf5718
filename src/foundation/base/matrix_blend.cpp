// SPDX-License-Identifier: Apache-2.0
#include "foundation/base/matrix_blend.h"

#include <cmath>
#include <optional>

namespace candela {

namespace {

/// The linear part alone.
Matrix4d linearPart(const Matrix4d &matrix) {
    Matrix4d result;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            result.at(row, column) = matrix.at(row, column);
    return result;
}

Matrix4d transposed(const Matrix4d &matrix) {
    Matrix4d result;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            result.at(row, column) = matrix.at(column, row);
    return result;
}

/// The rotation (or rotation with a mirror) that is nearest, by Newton's iteration on the polar
/// decomposition (Higham 1986). Nothing for what is singular.
std::optional<Matrix4d> nearestRotation(Matrix4d matrix) {
    for (int turn = 0; turn < 64; ++turn) {
        const std::optional<Matrix4d> inverted = inverse(matrix);
        if (!inverted)
            return std::nullopt;
        const Matrix4d opposite = transposed(*inverted);
        double change = 0, size = 0, own = 0, other = 0;
        for (std::size_t k = 0; k < 16; ++k)
            own += matrix.m[k] * matrix.m[k], other += opposite.m[k] * opposite.m[k];
        // Scaled at first, so that tiny and huge matrices take no longer.
        const double scale = turn < 8 ? std::pow(other / own, 0.25) : 1;
        for (int row = 0; row < 3; ++row)
            for (int column = 0; column < 3; ++column) {
                const double next =
                    (matrix.at(row, column) * scale + opposite.at(row, column) / scale) / 2;
                change += std::fabs(next - matrix.at(row, column)), size += std::fabs(next);
                matrix.at(row, column) = next;
            }
        if (!(change > 1e-15 * size))
            break;
    }
    return isFinite(matrix) ? std::optional(matrix) : std::nullopt;
}

/// Turns at an even rate to the rotation at share 1.
Matrix4d partOf(const Matrix4d &rotation, double share) {
    const auto at = [&](int row, int column) { return rotation.at(row, column); };
    // Row vectors: the part of a turn about an axis that is not symmetric is the axis' cross
    // product.
    const double x = at(1, 2) - at(2, 1), y = at(2, 0) - at(0, 2), z = at(0, 1) - at(1, 0);
    const double twiceSine = std::sqrt(x * x + y * y + z * z);
    const double angle = std::atan2(twiceSine, at(0, 0) + at(1, 1) + at(2, 2) - 1);
    if (angle < 1e-12)
        return {};
    Vec3 axis{float(x / twiceSine), float(y / twiceSine), float(z / twiceSine)};
    if (twiceSine < 1e-6) { // Half a turn: R + I has the axis for its rows.
        int longest = 0;
        for (int k = 1; k < 3; ++k)
            if (at(k, k) > at(longest, longest))
                longest = k;
        for (int k = 0; k < 3; ++k)
            axis[k] = float(at(longest, k) + (k == longest ? 1 : 0));
    }
    return rotationInDouble(share * angle * 180 / M_PI, axis);
}

} // namespace

Matrix4d straight(const Matrix4d &a, const Matrix4d &b, double share) {
    Matrix4d result;
    for (std::size_t k = 0; k < 16; ++k)
        result.m[k] = a.m[k] == b.m[k] ? a.m[k] : a.m[k] * (1 - share) + b.m[k] * share;
    return result;
}

Matrix4d blend(const Matrix4d &a, const Matrix4d &b, double share) {
    const Matrix4d fromLinear = linearPart(a), toLinear = linearPart(b);
    const std::optional<Matrix4d> from = nearestRotation(fromLinear);
    const std::optional<Matrix4d> to = nearestRotation(toLinear);
    if (!from || !to || flipsHandedness(a) != flipsHandedness(b))
        return straight(a, b, share);
    const Matrix4d turn = partOf(transposed(*from) * *to, share);
    if (turn == Matrix4d{})
        return straight(a, b, share);
    const Matrix4d stretch =
        straight(fromLinear * transposed(*from), toLinear * transposed(*to), share);
    Matrix4d result = stretch * *from * turn;
    for (int column = 0; column < 3; ++column)
        result.at(3, column) = a.at(3, column) * (1 - share) + b.at(3, column) * share;
    return result;
}

} // namespace candela
