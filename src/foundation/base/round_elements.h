// SPDX-License-Identifier: Apache-2.0
// Bodies that rays meet as they are, without triangles.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace candela {

/// What rays may meet exactly: balls, or tubes round cubic curves. An element is a knot, or four.
struct RoundElements {
    /// x, y, z and radius: balls, or Bezier control points.
    std::vector<std::array<float, 4>> knots;
    /// The first of a tube's four knots each; empty: the knots are balls.
    std::vector<std::uint32_t> tubes;
    /// They change their shape: knots at later even steps over the shutter's interval, between
    /// which each goes straight. Else empty.
    std::vector<std::vector<std::array<float, 4>>> later = {};

    bool isOneBall() const { return tubes.empty() && knots.size() == 1; }
    std::size_t size() const { return tubes.empty() ? knots.size() : tubes.size(); }

    /// The knots at all steps, in their order.
    template <class Do> void forSteps(Do work) {
        work(knots);
        for (auto &step : later)
            work(step);
    }
    template <class Do> void forSteps(Do work) const {
        work(knots);
        for (const auto &step : later)
            work(step);
    }
};

} // namespace candela
