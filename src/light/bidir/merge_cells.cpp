// SPDX-License-Identifier: Apache-2.0
#include "light/bidir/merge_cells.h"

#include "foundation/base/hash.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace candela {

namespace {

/// Cells farther out than this from the origin are one: what is there is told apart by distance.
constexpr double farthestCell = 1e15;

std::int64_t cellAt(double inCells) {
    return std::int64_t(std::floor(std::clamp(inCells, -farthestCell, farthestCell)));
}

} // namespace

MergeCells::MergeCells(std::span<const Vec3> points, float radius)
    : radius_(radius), perCell_(1 / (2 * double(radius))) {
    std::vector<std::uint32_t> bucket;
    bucket.reserve(points.size());
    start_.assign(std::bit_ceil(points.size() + 1) + 1, 0);
    for (const Vec3 &P : points) {
        const std::array<std::int64_t, 3> cell{cellAt(P.x * perCell_), cellAt(P.y * perCell_),
                                               cellAt(P.z * perCell_)};
        bucket.push_back(std::uint32_t(bucketOf(cell)));
        ++start_[bucket.back() + 1];
    }
    for (std::size_t k = 1; k < start_.size(); ++k)
        start_[k] += start_[k - 1];
    points_.resize(points.size()), order_.resize(points.size());
    std::vector<std::uint32_t> next(start_.begin(), start_.end() - 1);
    for (std::size_t k = 0; k < points.size(); ++k) {
        const std::uint32_t at = next[bucket[k]]++;
        points_[at] = points[k], order_[at] = std::int32_t(k);
    }
}

std::size_t MergeCells::bucketOf(const std::array<std::int64_t, 3> &cell) const {
    std::uint64_t bits = 0;
    for (std::int64_t k : cell)
        bits = mixBits(bits ^ std::uint64_t(k));
    return std::size_t(bits) & (start_.size() - 2);
}

void MergeCells::findNear(const Vec3 &P, std::vector<std::int32_t> &found) const {
    found.clear();
    if (points_.empty())
        return;
    std::array<std::int64_t, 3> low;
    for (int c = 0; c < 3; ++c)
        low[c] = cellAt(P[c] * perCell_ - 0.5);
    std::array<std::size_t, 8> buckets;
    for (int corner = 0; corner < 8; ++corner)
        buckets[corner] =
            bucketOf({low[0] + (corner & 1), low[1] + (corner >> 1 & 1), low[2] + (corner >> 2)});
    // Cells may share a bucket, which is searched but once.
    std::ranges::sort(buckets);
    const auto last = std::ranges::unique(buckets).begin();
    for (auto bucket = buckets.begin(); bucket != last; ++bucket)
        for (std::uint32_t k = start_[*bucket]; k < start_[*bucket + 1]; ++k) {
            const Vec3 apart = points_[k] - P;
            if (dot(apart, apart) <= radius_ * radius_)
                found.push_back(std::int32_t(k));
        }
}

} // namespace candela
