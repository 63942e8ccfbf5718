// SPDX-License-Identifier: Apache-2.0
// Orders of derivatives by u and v. A value's jet is its Taylor series: the coefficient of order
// (a, b) is the derivative, a times by u and b times by v, over a! b!.
#pragma once

#include "language/ir/core/ir.h"

#include <bitset>
#include <compare>
#include <optional>

namespace candela::ir {

struct Order {
    int u = 0, v = 0;

    constexpr int total() const { return u + v; }
    int along(Direction d) const { return d == Direction::U ? u : v; }
    /// Once more by that direction.
    Order raised(Direction d) const {
        return d == Direction::U ? Order{u + 1, v} : Order{u, v + 1};
    }
    Order operator-(Order o) const { return {u - o.u, v - o.v}; }
    auto operator<=>(const Order &) const = default;
};

/// Derivatives of derivatives are known up to here.
inline constexpr int highestOrder = 16;
inline constexpr int partCount = (highestOrder + 1) * (highestOrder + 2) / 2;

/// Orders numbered by their total; 0 is the value itself.
constexpr int partOf(Order o) { return o.total() * (o.total() + 1) / 2 + o.v; }
constexpr Order orderOf(int part) {
    int total = 0;
    while (partOf({total + 1, 0}) <= part)
        ++total;
    const int v = part - partOf({total, 0});
    return {total - v, v};
}

using Parts = std::bitset<partCount>;

} // namespace candela::ir
