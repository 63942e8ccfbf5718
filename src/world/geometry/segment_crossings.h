// SPDX-License-Identifier: Apache-2.0
// Where segments in the plane meet.
#pragma once

#include "world/geometry/flat_polygon.h"

#include <span>
#include <vector>

namespace candela {

struct FlatSegment {
    FlatPoint from, to;
};

/// A place within a segment where another one crosses it or ends.
struct SegmentCut {
    int segment = 0;
    double share = 0; ///< Of the way along it.
    FlatPoint place;  ///< The same for both segments that cross.
};

/// All of them, in no order. False if they are too many to be looked for.
bool findCuts(std::span<const FlatSegment>, std::vector<SegmentCut> &cuts);

} // namespace candela
