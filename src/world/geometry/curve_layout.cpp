// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/curve_layout.h"

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
    curves_.reserve(record.vertexCounts.size());
    for (int count : record.vertexCounts) {
        const auto segments = std::uint32_t(curveSegments(record, count, basis.step));
        curves_.push_back({std::uint32_t(curveOf_.size()), vertices_, ends_, std::uint32_t(count)});
        curveOf_.insert(curveOf_.end(), segments, std::uint32_t(curves_.size() - 1));
        vertices_ += std::uint32_t(count);
        ends_ += segments + (periodic_ ? 0 : 1);
    }
}

std::uint32_t CurveLayout::segmentsOf(const Curve &curve) const {
    const std::uint32_t next = std::uint32_t(&curve - curves_.data()) + 1;
    return (next < curves_.size() ? curves_[next].firstSegment : segments()) - curve.firstSegment;
}

std::uint32_t CurveLayout::segmentsBeside(std::uint32_t segment) const {
    return segmentsOf(of(segment));
}

std::uint32_t CurveLayout::segmentsBefore(std::uint32_t segment) const {
    return segment - of(segment).firstSegment;
}

std::optional<std::uint32_t> CurveLayout::previous(std::uint32_t segment) const {
    const Curve &curve = of(segment);
    if (segment > curve.firstSegment)
        return segment - 1;
    return periodic_ ? std::optional(curve.firstSegment + segmentsOf(curve) - 1) : std::nullopt;
}

std::optional<std::uint32_t> CurveLayout::next(std::uint32_t segment) const {
    const Curve &curve = of(segment);
    if (segment + 1 < curve.firstSegment + segmentsOf(curve))
        return segment + 1;
    return periodic_ ? std::optional(curve.firstSegment) : std::nullopt;
}

int CurveLayout::valuesOf(StorageClass storage) const {
    switch (storage) {
    case StorageClass::Constant: return 1;
    case StorageClass::Uniform: return int(curves_.size());
    case StorageClass::Varying:
    case StorageClass::FaceVarying: return int(ends_);
    case StorageClass::Vertex:
    case StorageClass::FaceVertex: break;
    }
    return int(vertices_);
}

CurveOrdinates CurveLayout::ordinates(const NumericVariable &variable, std::uint32_t segment,
                                      int component) const {
    const Curve &curve = of(segment);
    const std::uint32_t number = segment - curve.firstSegment;
    auto value = [&](std::uint32_t place) {
        return variable.values[std::size_t(place) * variable.components + component];
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
    case StorageClass::Uniform: return line(value(curveOf_[segment]), value(curveOf_[segment]));
    case StorageClass::Varying:
    case StorageClass::FaceVarying: {
        const std::uint32_t ends = segmentsOf(curve) + (periodic_ ? 0 : 1);
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
