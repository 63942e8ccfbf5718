// SPDX-License-Identifier: Apache-2.0
#include "interface/ri/transform_motion.h"

#include "foundation/base/matrix_blend.h"
#include "interface/ri/motion_of_numbers.h"

#include <algorithm>
#include <cmath>

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

namespace {

/// The same turn about the opposite axis.
bool areOpposite(const TransformSample &a, const TransformSample &b) {
    return a.kind == TransformSample::Kind::Rotation && dot(a.first, b.first) < 0;
}

/// By how many degrees the angle changes.
double turnBetween(const TransformSample &a, const TransformSample &b) {
    return (areOpposite(a, b) ? -b.angle : b.angle) - a.angle;
}

} // namespace

Matrix4d between(const TransformSample &a, const TransformSample &b, double share) {
    if (a.kind == TransformSample::Kind::Matrix)
        return blend(a.matrix, b.matrix, share);
    TransformSample result = a;
    const float sign = areOpposite(a, b) ? -1 : 1;
    result.angle = a.angle + share * turnBetween(a, b);
    const float to = float(share), from = 1 - to;
    result.first = a.first * from + b.first * sign * to;
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

/// Adds the block's times, and others so near that nothing turns by more than a quarter between two
/// (up to a hundred turns): who looks at these alone must not see one attitude at all of them.
static void addTimesOf(const MotionBlock &block, std::vector<double> &all) {
    constexpr double quarter = 90, most = 400;
    all.insert(all.end(), block.times.begin(), block.times.end());
    for (std::size_t k = 0; k + 1 < block.times.size(); ++k) {
        const double turn = std::fabs(turnBetween(block.samples[k], block.samples[k + 1]));
        const int parts = int(std::min(std::ceil(turn / quarter), most));
        for (int part = 1; part < parts; ++part)
            all.push_back(block.times[k] + (block.times[k + 1] - block.times[k]) * part / parts);
    }
}

void TransformMotion::addTimes(std::vector<double> &times) const {
    addTimesOf(*block_, times);
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
