// SPDX-License-Identifier: Apache-2.0
#include "interface/ri/transformations.h"

#include <cmath>
#include <optional>

namespace candela {

/// The matrix without what rounding has left in its last column; nothing if it is projective.
static std::optional<Matrix4d> affine(const Matrix4d &matrix) {
    const double w = matrix.at(3, 3);
    Matrix4d result;
    for (int row = 0; row < 4; ++row) {
        if (row < 3 && !(std::fabs(matrix.at(row, 3)) <= 1e-6 * std::fabs(w)))
            return std::nullopt;
        for (int column = 0; column < 3; ++column)
            result.at(row, column) = matrix.at(row, column) / w;
    }
    return result;
}

static bool isFiniteAsFloats(const Matrix4d &matrix) {
    return isFinite(inDouble(matrix.rounded()));
}

/// Space loses a dimension, or so nearly that the rounding of coordinates is all that is left of
/// it: a volume of 1e-12 of what the stretches of the three coordinates would give at right angles.
static bool flattens(const Matrix4d &matrix) {
    const auto at = [&](int row, int column) { return matrix.at(row, column); };
    double volume = 0, box = 1;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        volume += at(0, i) * (at(1, j) * at(2, k) - at(1, k) * at(2, j));
        box *= std::hypot(at(0, i), at(1, i), at(2, i));
    }
    return !(std::fabs(volume) > 1e-12 * box) || !inverse(matrix.rounded());
}

TransformDefect assign(CurrentTransform &transform, const Matrix4d &matrix) {
    const std::optional<Matrix4d> kept = affine(matrix);
    if (!kept && inverse(matrix))
        return TransformDefect::Projective;
    if (!kept || !isFiniteAsFloats(*kept))
        return TransformDefect::NotFinite;
    transform = {*kept, nullptr, flattens(*kept)};
    return TransformDefect::None;
}

TransformDefect concatenate(CurrentTransform &transform, const Matrix4d &inner) {
    const TransformMotion::Shared motion = transform.motion;
    const bool flat = motion && transform.flat;
    const TransformDefect defect = assign(transform, inner * transform.matrix);
    if (motion && defect == TransformDefect::None) {
        transform.motion = motion->after(inner);
        transform.flat |= flat;
    }
    return defect;
}

TransformDefect concatenate(CurrentTransform &transform, std::shared_ptr<const MotionBlock> block,
                            double open) {
    const auto around = transform.motion;
    const auto motion = around ? std::make_shared<const TransformMotion>(block, around)
                               : std::make_shared<const TransformMotion>(block, transform.matrix);
    bool flat = transform.flat;
    CurrentTransform moved;
    for (const double time : block->times) {
        if (const TransformDefect defect = assign(moved, motion->at(time));
            defect != TransformDefect::None)
            return defect;
        flat |= moved.flat;
    }
    if (const TransformDefect defect = assign(moved, motion->at(open));
        defect != TransformDefect::None)
        return defect;
    transform = {moved.matrix, motion, moved.flat || flat};
    return TransformDefect::None;
}

} // namespace candela
