// SPDX-License-Identifier: Apache-2.0
// Transformations in time: motion blocks (RI 3.2, section 6), each between what stands still inside
// and around it.
#pragma once

#include "foundation/base/matrix4d.h"

#include <memory>
#include <vector>

namespace candela {

/// A transformation request by its parameters, as motion blocks interpolate them.
struct TransformSample {
    enum class Kind { Matrix, Translation, Rotation, Scaling, Skew };
    Kind kind = Kind::Matrix;
    Matrix4d matrix;    ///< Of Kind::Matrix.
    double angle = 0;   ///< Degrees.
    Vec3 first, second; ///< Distances, factors, the axis; both axes.

    Matrix4d factor() const;
};

/// Parameters change at an even rate, so that a wheel turns as far as its angles say. Matrices are
/// blended (foundation/base/matrix_blend.h).
Matrix4d between(const TransformSample &, const TransformSample &, double share);

/// What one motion block says: at least two samples, times in increasing order.
struct MotionBlock {
    std::vector<double> times;
    std::vector<TransformSample> samples;
    /// Before the first time and after the last one it stands still.
    Matrix4d at(double time) const;
};

/// Immutable: a point goes through `inner`, the block, and what is around.
class TransformMotion {
public:
    using Shared = std::shared_ptr<const TransformMotion>;
    /// `around`: what stands still around the block, or moves itself.
    TransformMotion(std::shared_ptr<const MotionBlock> block, const Matrix4d &around)
        : block_(std::move(block)), around_(around) {}
    TransformMotion(std::shared_ptr<const MotionBlock> block, Shared around)
        : block_(std::move(block)), movingAround_(std::move(around)) {}
    /// What goes through `inner` before.
    Shared after(const Matrix4d &inner) const;

    /// Affine.
    Matrix4d at(double time) const;
    /// Adds the times of all its blocks.
    void addTimes(std::vector<double> &) const;
    const Matrix4d &inner() const { return inner_; }
    /// Both differ in what stands still inside, at most: they move together.
    bool movesLike(const TransformMotion &) const;

private:
    Matrix4d inner_;
    std::shared_ptr<const MotionBlock> block_;
    Matrix4d around_;
    Shared movingAround_; ///< Null: `around_` holds.
};

} // namespace candela
