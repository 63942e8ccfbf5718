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
    /// Indices of the points within the radius; in an order that depends on all points alone.
    void findNear(const Vec3 &, std::vector<std::int32_t> &found) const;

private:
    struct Entry {
        Vec3 P;
        std::int32_t index;
    };
    std::size_t bucketOf(const std::array<std::int64_t, 3> &cell) const;

    float radius_ = 0;
    double perCell_ = 0;               ///< Cells have edges of two radii, so eight hold a ball.
    std::vector<std::uint32_t> start_; ///< By bucket, and one more: where its entries begin.
    std::vector<Entry> entries_;
};

} // namespace candela
