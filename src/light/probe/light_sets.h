// SPDX-License-Identifier: Apache-2.0
// Paths from lights for points: a set for each batch of samples, so that batches stay independent
// of each other. All points share them.
#pragma once

#include "light/bidir/light_vertices.h"
#include "light/path/wave.h"

#include <vector>

namespace candela {

class LightSets {
public:
    /// None if no light begins paths.
    LightSets(FrameContext &, int sets);

    bool isEmpty() const { return sets_.empty(); }
    const LightVertices &operator[](int set) const { return sets_[std::size_t(set)]; }
    /// How often camera paths are connected with each.
    const TechniqueCounts &counts() const { return counts_; }
    static constexpr int connections = 1;

private:
    std::vector<LightVertices> sets_;
    TechniqueCounts counts_;
};

} // namespace candela
