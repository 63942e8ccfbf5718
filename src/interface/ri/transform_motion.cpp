// SPDX-License-Identifier: Apache-2.0
#include "interface/ri/transform_motion.h"

#include "foundation/base/matrix_blend.h"
#include "interface/ri/motion_of_numbers.h"

namespace candela {

Matrix4d TransformSample::factor() const {
    switch (kind) {
    case Kind::Matrix: return matrix;
    case Kind::Translation: return translationInDouble(first.x, first.y, first.z);
    case Kind::Rotation: return rotationInDouble(angle, first);
    case Kind::Scaling: return scalingInDouble(first.x, first.y, first.z);
    case Kind::Skew: return skewInDouble(angle, first, second);
    }
    return matrix;
}

Matrix4d between(const TransformSample &a, const TransformSample &b, double share) {
    if (a.kind == TransformSample::Kind::Matrix)
        return blend(a.matrix, b.matrix, share);
    TransformSample result = a;
    // The same turn about the opposite axis.
    const bool opposite = a.kind == TransformSample::Kind::Rotation && dot(a.first, b.first) < 0;
    const double sign = opposite ? -1 : 1;
    result.angle = a.angle * (1 - share) + sign * b.angle * share;
    const float to = float(share), from = 1 - to;
    result.first = a.first * from + b.first * float(sign) * to;
    result.second = a.second * from + b.second * to;
    return result.factor();
}

Matrix4d MotionBlock::at(double time) const {
    const KnotPlace place = placeAmong(times, time);
    return place.share > 0 ? between(samples[place.knot], samples[place.next], place.share)
                           : samples[place.knot].factor();
}

TransformMotion::Shared TransformMotion::after(const Matrix4d &inner) const {
    auto result = std::make_shared<TransformMotion>(*this);
    result->inner_ = inner * inner_;
    return result;
}

void TransformMotion::addTimes(std::vector<double> &times) const {
    times.insert(times.end(), block_->times.begin(), block_->times.end());
    if (movingAround_)
        movingAround_->addTimes(times);
}

bool TransformMotion::movesLike(const TransformMotion &other) const {
    if (block_ != other.block_ || !movingAround_ != !other.movingAround_)
        return false;
    if (!movingAround_)
        return around_ == other.around_;
    return movingAround_->inner_ == other.movingAround_->inner_ &&
           movingAround_->movesLike(*other.movingAround_);
}

Matrix4d TransformMotion::at(double time) const {
    Matrix4d whole = inner_ * block_->at(time);
    whole = whole * (movingAround_ ? movingAround_->at(time) : around_);
    const double w = whole.at(3, 3);
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            whole.at(row, column) = column < 3 ? whole.at(row, column) / w : row == 3;
    return whole;
}

} // namespace candela
