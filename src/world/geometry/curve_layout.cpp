// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/curve_layout.h"

#include <algorithm>
#include <functional>

namespace candela {

CurveLayout::CurveLayout(const CurvesRecord &record, const BasisRecord &basis)
    : cubic_(record.cubic), periodic_(record.periodic), step_(std::uint32_t(basis.step)) {
    for (int j = 0; j < 4; ++j) {
        // Rows of the basis are powers, the third first.
        const float cube = basis.matrix[j], square = basis.matrix[4 + j];
        const float line = basis.matrix[8 + j], constant = basis.matrix[12 + j];
        bezierFromBasis_[0][j] = constant;
        bezierFromBasis_[1][j] = constant + line / 3;
        bezierFromBasis_[2][j] = constant + (2 * line + square) / 3;
        bezierFromBasis_[3][j] = constant + line + square + cube;
    }
    const std::vector<int> &counts = record.vertexCounts;
    count_ = std::uint32_t(counts.size());
    areAlike_ = std::ranges::adjacent_find(counts, std::not_equal_to()) == counts.end();
    for (int count : counts) {
        const auto segments = std::uint32_t(curveSegments(record, count, basis.step));
        const Curve curve{segments_, vertices_, ends_, std::uint32_t(count), segments};
        if (!areAlike_)
            curveOf_.insert(curveOf_.end(), segments, std::uint32_t(curves_.size()));
        if (!areAlike_ || curves_.empty())
            curves_.push_back(curve);
        segments_ += segments, vertices_ += curve.vertices, ends_ += endsOf(curve);
    }
}

CurveLayout::Curve CurveLayout::of(std::uint32_t segment) const {
    const std::uint32_t number = curveOf(segment);
    if (!areAlike_)
        return curves_[number];
    const Curve &one = curves_.front();
    return {number * one.segments, number * one.vertices, number * endsOf(one), one.vertices,
            one.segments};
}

std::uint32_t CurveLayout::segmentsBeside(std::uint32_t segment) const {
    return of(segment).segments;
}

std::uint32_t CurveLayout::segmentsBefore(std::uint32_t segment) const {
    return segment - of(segment).firstSegment;
}

std::optional<std::uint32_t> CurveLayout::previous(std::uint32_t segment) const {
    const Curve curve = of(segment);
    if (segment > curve.firstSegment)
        return segment - 1;
    return periodic_ ? std::optional(curve.firstSegment + curve.segments - 1) : std::nullopt;
}

std::optional<std::uint32_t> CurveLayout::next(std::uint32_t segment) const {
    const Curve curve = of(segment);
    if (segment + 1 < curve.firstSegment + curve.segments)
        return segment + 1;
    return periodic_ ? std::optional(curve.firstSegment) : std::nullopt;
}

int CurveLayout::valuesOf(StorageClass storage) const {
    switch (storage) {
    case StorageClass::Constant: return 1;
    case StorageClass::Uniform: return int(count_);
    case StorageClass::Varying:
    case StorageClass::FaceVarying: return int(ends_);
    case StorageClass::Vertex:
    case StorageClass::FaceVertex: break;
    }
    return int(vertices_);
}

CurveOrdinates CurveLayout::ordinates(const NumericVariable &variable, std::uint32_t segment,
                                      int component, Moment moment) const {
    const CurveOrdinates from = ordinates(variable, segment, component, moment.step);
    if (moment.share == 0)
        return from;
    return between(from, ordinates(variable, segment, component, moment.step + 1), moment.share);
}

CurveOrdinates CurveLayout::ordinates(const NumericVariable &variable, std::uint32_t segment,
                                      int component, int step) const {
    const Curve curve = of(segment);
    const std::uint32_t number = segment - curve.firstSegment;
    const std::size_t before =
        step == 0 ? 0 : std::size_t(step) * std::size_t(valuesOf(variable.declaration.storage));
    auto value = [&](std::uint32_t place) {
        return variable.values[(before + place) * variable.components + component];
    };
    auto line = [](float from, float to) {
        const float third = (to - from) / 3;
        return CurveOrdinates{from, from + third, to - third, to};
    };
    auto vertex = [&](std::uint32_t place) {
        return value(curve.firstVertex + place % curve.vertices);
    };
    switch (variable.declaration.storage) {
    case StorageClass::Constant: return line(value(0), value(0));
    case StorageClass::Uniform: {
        const float one = value(curveOf(segment));
        return line(one, one);
    }
    case StorageClass::Varying:
    case StorageClass::FaceVarying: {
        const std::uint32_t ends = endsOf(curve);
        return line(value(curve.firstEnd + number), value(curve.firstEnd + (number + 1) % ends));
    }
    case StorageClass::Vertex:
    case StorageClass::FaceVertex: break;
    }
    if (!cubic_)
        return line(vertex(number), vertex(number + 1));
    CurveOrdinates result{};
    for (std::uint32_t j = 0; j < 4; ++j) {
        const float control = vertex(number * step_ + j);
        for (int k = 0; k < 4; ++k)
            result[k] += bezierFromBasis_[k][j] * control;
    }
    return result;
}

} // namespace candela
