// SPDX-License-Identifier: Apache-2.0
// What motion blocks say of numbers: values at times, which go straight between these.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

namespace candela {

/// Where a time falls among knots: between the one and the next, `share` of the way. Before the
/// first and after the last one there is nothing to go to.
struct KnotPlace {
    std::size_t knot = 0, next = 0;
    double share = 0;
};
KnotPlace placeAmong(const std::vector<double> &times, double time);

/// Values in time: at least two, times in increasing order.
template <class Value> struct InTime {
    std::vector<double> times;
    std::vector<Value> values;
};

/// By a member of its own; null: it stays the same.
template <class Value> using SharedInTime = std::shared_ptr<const InTime<Value>>;

/// As many even steps over an interval as bring one to each of the times that lie in it, or nearly;
/// 32 at most.
int stepsThrough(const std::vector<double> &times, double open, double close);

} // namespace candela
