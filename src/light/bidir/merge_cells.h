// SPDX-License-Identifier: Apache-2.0
// Points sorted into cubes, to be found by what is near.
#pragma once

#include "foundation/base/vec3.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace candela {

class MergeCells {
public:
    /// No points.
    MergeCells() = default;
    /// What is asked for later lies within `radius`, above 0, of where it is asked for.
    MergeCells(std::span<const Vec3> points, float radius);

    float radius() const { return radius_; }
    /// Cell by cell: the k-th point of this order was given as order()[k]. It depends on all points
    /// alone; what is asked of them is to lie in it, too, near what is asked next.
    const std::vector<std::int32_t> &order() const { return order_; }
    /// Places in that order of the points within the radius.
    void findNear(const Vec3 &, std::vector<std::int32_t> &found) const;

private:
    std::size_t bucketOf(const std::array<std::int64_t, 3> &cell) const;

    float radius_ = 0;
    double perCell_ = 0;               ///< Cells have edges of two radii, so eight hold a ball.
    std::vector<std::uint32_t> start_; ///< By bucket, and one more: where its points begin.
    std::vector<Vec3> points_;         ///< In the order.
    std::vector<std::int32_t> order_;
};

} // namespace candela
