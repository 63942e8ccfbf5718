// SPDX-License-Identifier: Apache-2.0
// Loops that cross themselves and each other, as faces whose loops do not.
#pragma once

#include "world/geometry/flat_polygon.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace candela {

/// A corner where sides cross: on the way from one corner of a loop to the next.
struct MadeCorner {
    std::array<int, 2> between; ///< What these stand for (FlatVertex::index).
    double share = 0;           ///< Of the way.
};

struct UntangledFaces {
    struct Face {
        FlatLoop outside;            ///< Counter-clockwise.
        std::vector<FlatLoop> holes; ///< Clockwise.
    };
    std::vector<Face> faces;
    bool cross = false; ///< Sides did, or one lay upon another's end, or ends upon each other.
};

/// What the outside winds around an odd number of times, as even-odd rules have it, and holes do
/// not. Corners that are made are appended to `made`, whose first stands for the number
/// `firstMade`. Nothing if loops cross more than a million times, or so nearly that rounding hides
/// how.
std::optional<UntangledFaces> untangle(const FlatLoop &outside, std::span<const FlatLoop> holes,
                                       int firstMade, std::vector<MadeCorner> &made);

} // namespace candela
