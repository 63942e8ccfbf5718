// SPDX-License-Identifier: Apache-2.0
// How finely pieces of a subdivision surface must be cut: into the squares of its tree, or parts of
// these.
#pragma once

#include "world/geometry/patch_positions.h"
#include "world/geometry/subdivision_tree.h"

namespace candela {

/// How fine is fine enough: bounds of what SubdivisionErrors knows of cells, and the smallest cell.
struct SubdivisionRate {
    double chord = 0, edge = 0;
    int mostLevels = 10;
};

class SubdivisionErrors {
public:
    SubdivisionErrors() = default;
    SubdivisionErrors(const SubdivisionTree &, const PatchPositions &,
                      std::span<const PatchBounds> leaves);

    /// Cells of a tree's part, or of a leaf that is cut `levels` times.
    struct Bounds {
        /// The largest distance between a triangle whose corners lie in one cell and the surface,
        /// between points of the same name.
        double chord = 0;
        double edge = 0; ///< No edge in a cell is longer.
    };
    Bounds ofNode(std::int32_t node) const { return nodes_[node]; }
    Bounds ofLeaf(std::uint32_t leaf, int levels) const;
    /// How many times a leaf is cut at this rate.
    int levels(const SubdivisionLeaf &, std::uint32_t leaf, const SubdivisionRate &) const;
    bool isFine(const Bounds &bounds, const SubdivisionRate &rate) const {
        return bounds.chord <= rate.chord && bounds.edge <= rate.edge;
    }

private:
    std::vector<Bounds> nodes_, leaves_;
};

} // namespace candela
