// SPDX-License-Identifier: Apache-2.0
// Which shapes bound the bodies of solids, as rays are to be told.
#pragma once

#include "foundation/base/diagnostics.h"
#include "world/rays/solid.h"
#include "world/scene/declared_solids.h"

#include <map>
#include <vector>

namespace candela {

struct PlacedBodies {
    std::vector<Solid> all;
    std::vector<std::vector<SourceLocation>> where; ///< Of each solid, of its nodes.
};

/// Hears of shapes and instances as they are added; nodes are those of PlacedSolids, -1 for what
/// belongs to no solid.
class SolidBodies {
public:
    SolidBodies(const DeclaredSolids &declared, const PlacedSolids &placed)
        : declared_(declared), placed_(placed) {}

    void addShape(std::uint32_t shape, std::int32_t node, const SourceLocation &);
    /// The next instance, by its shapes; empty if it belongs to none.
    void addInstance(std::vector<std::int32_t> nodes);
    /// The next instance, of shapes that have been told.
    void addInstanceOfWorld(std::uint32_t firstShape, std::uint32_t shapes);

    /// What solids consist of may be cut.
    bool isCut(std::uint32_t shape) const { return nodeOfShape_.contains(shape); }
    PlacedBodies solids(std::uint32_t worldShapes) const;

private:
    const DeclaredSolids &declared_;
    const PlacedSolids &placed_;
    std::map<std::uint32_t, std::int32_t> nodeOfShape_;
    std::map<std::int32_t, SourceLocation> where_; ///< By node.
    std::map<std::uint32_t, std::vector<std::int32_t>> nodesOfInstance_;
    std::uint32_t instances_ = 0;
};

} // namespace candela
