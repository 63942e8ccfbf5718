// SPDX-License-Identifier: Apache-2.0
// Constructive solid geometry as rays see it: which bodies a solid is made of, and how.
#pragma once

#include <cstdint>
#include <vector>

namespace candela {

/// Inside where the body that its own members bound is, or as its child nodes say.
struct SolidNode {
    std::int32_t parent = -1; ///< Stands before it; of the first node, the solid itself: none.
    bool subtracted = false;  ///< The parent looks at what is outside of it.
    bool needsAll = false;    ///< Inside where all child nodes are; else where any is.
};

/// A shape of the world, or an instance, that belongs to a solid.
struct SolidMember {
    /// The shape's number; of instances, their own number behind all shapes of the world.
    std::uint32_t geometry = 0;
    /// Whose body each shape bounds: of the one shape, or of the instance's object.
    std::vector<std::int32_t> nodes;
};

struct Solid {
    std::vector<SolidNode> nodes;
    std::vector<SolidMember> members;
};

} // namespace candela
