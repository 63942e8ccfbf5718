// SPDX-License-Identifier: Apache-2.0
// What trim curves leave of the unit square that a NuPatch is a map of.
#pragma once

#include "interface/ri/trim_record.h"
#include "world/geometry/patch_grid.h"

#include <array>
#include <span>
#include <vector>

namespace candela {

/// Straight pieces of trim curves, in the unit square and beyond.
class TrimOutline {
public:
    using Place = std::array<double, 2>;
    struct Segment {
        Place from, to;
    };

    /// Follows the curves to within these tolerances in u and v, as far as 1024 steps a span can.
    TrimOutline(const TrimRecord &, const PatchGrid &, Place tolerance);

    const std::vector<Segment> &segments() const { return segments_; }
    /// Loops that do not end where they begin; they have been closed by a straight line.
    int openLoops() const { return openLoops_; }
    /// How often curves go round a place, to the left.
    int winding(Place) const;
    /// Numbers of segments that may have places between these v.
    std::span<const std::uint32_t> near(double lowV, double highV,
                                        std::vector<std::uint32_t> &found) const;

private:
    void addLoop(const std::vector<TrimCurveRecord> &, const PatchGrid &, Place tolerance);
    int rowOf(double v) const;

    static constexpr int rows = 512;
    std::vector<Segment> segments_;
    std::vector<std::vector<std::uint32_t>> byRow_;
    int openLoops_ = 0;
};

/// RI keeps what lies to the left of curves, and what a line from far away reaches after an odd
/// number of curves. Where the two differ the second is followed, as renderers have, except that
/// loops which run clockwise, with nothing round them, cut holes.
class TrimRule {
public:
    TrimRule(const TrimOutline &, bool trimsInside);
    bool keeps(int winding) const { return (winding + offset_) % 2 != 0; }

private:
    int offset_ = 0;
};

} // namespace candela
