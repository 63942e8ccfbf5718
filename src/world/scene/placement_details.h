// SPDX-License-Identifier: Apache-2.0
// How finely objects are wanted where they stand.
#pragma once

#include "world/scene/declared_world.h"
#include "world/shapes/dicing_plan.h"

#include <span>
#include <vector>

namespace candela {

/// An object is diced at three levels at most, one eight times as coarse as the next.
struct PlacementDetail {
    int level = 0;   ///< 0 = as fine as the object's nearest placement wants it.
    float pixel = 0; ///< Units of the object's space that a pixel spans at that level.
};

/// Of each placement; those of objects that stand but once have no levels.
std::vector<PlacementDetail> detailsOf(std::span<const Placement>,
                                       const std::vector<int> &timesPlaced, const DeclaredWorld &,
                                       const DicingPlan &);

} // namespace candela
