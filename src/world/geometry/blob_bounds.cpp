// SPDX-License-Identifier: Apache-2.0
// What fields of blobs may be within a box, by intervals.
#include "world/geometry/blob_field.h"

#include <algorithm>
#include <cmath>

namespace candela {

namespace {

constexpr FieldBounds anything{-INFINITY, INFINITY};

/// Not less than any product or quotient of the two, whose infinities may make NaN.
template <class Combine>
FieldBounds ofCorners(FieldBounds a, FieldBounds b, const Combine &combine) {
    const float corners[] = {combine(a.low, b.low), combine(a.low, b.high), combine(a.high, b.low),
                             combine(a.high, b.high)};
    if (std::ranges::any_of(corners, [](float x) { return std::isnan(x); }))
        return anything;
    const auto [low, high] = std::ranges::minmax(corners);
    return {low, high};
}

bool isAffine(const Matrix4 &matrix) {
    return matrix.m[3] == 0 && matrix.m[7] == 0 && matrix.m[11] == 0 && matrix.m[15] == 1;
}

} // namespace

FieldBounds Blob::over(const Box3 &box) const {
    if (!isAffine(blobFromObject))
        return {0, 1};
    // A ball around the box, as the blob's own space has it.
    const Vec3 half = box.extent() * 0.5f;
    Vec3 reach;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row)
            reach[column] += std::fabs(blobFromObject.m[std::size_t(4 * row + column)]) * half[row];
    const Vec3 middle = transformPoint(blobFromObject, box.low + half), way = to - from;
    const float squared = dot(way, way);
    const float along = squared > 0 ? std::clamp(dot(middle - from, way) / squared, 0.0f, 1.0f) : 0;
    const float distance = length(middle - from - way * along) / radius;
    const float around = length(reach) / radius;
    const auto valueAt = [](float r) {
        const float rest = std::max(0.0f, 1 - r * r);
        return rest * rest * rest;
    };
    return {valueAt(distance + around), valueAt(std::max(0.0f, distance - around))};
}

FieldBounds BlobField::bound(const Instruction &of, const Box3 &box,
                             std::span<const FieldBounds> earlier) const {
    const auto operands = operandsOf(of);
    const auto operand = [&](std::size_t i) { return earlier[operands[i]]; };
    const auto fold = [&](FieldBounds start, const auto &combine) {
        for (std::size_t i = 0; i < operands.size(); ++i)
            start = combine(start, operand(i));
        return start;
    };
    const auto times = [](float a, float b) { return a * b; };
    switch (of.kind) {
    case Kind::Constant: return {of.value, of.value};
    case Kind::BlobLeaf: return blobs_[of.blob].over(box);
    case Kind::Add:
        return fold({}, [](FieldBounds a, FieldBounds b) {
            return FieldBounds{a.low + b.low, a.high + b.high};
        });
    case Kind::Multiply:
        return fold({1, 1}, [&](FieldBounds a, FieldBounds b) { return ofCorners(a, b, times); });
    case Kind::Maximum:
        return fold(operand(0), [](FieldBounds a, FieldBounds b) {
            return FieldBounds{std::max(a.low, b.low), std::max(a.high, b.high)};
        });
    case Kind::Minimum:
        return fold(operand(0), [](FieldBounds a, FieldBounds b) {
            return FieldBounds{std::min(a.low, b.low), std::min(a.high, b.high)};
        });
    case Kind::Subtract:
        return {operand(0).low - operand(1).high, operand(0).high - operand(1).low};
    case Kind::Divide:
        if (!(operand(1).low > 0) && !(operand(1).high < 0))
            return anything;
        return ofCorners(operand(0), operand(1), [](float a, float b) { return a / b; });
    case Kind::Negate: break;
    }
    return {-operand(0).high, -operand(0).low};
}

FieldBounds BlobField::over(const Box3 &box) const {
    std::vector<FieldBounds> values(instructions_.size());
    for (std::size_t i = 0; i < instructions_.size(); ++i)
        values[i] = bound(instructions_[i], box, values);
    return values.empty() ? FieldBounds{} : values.back();
}

} // namespace candela
