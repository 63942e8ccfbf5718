// SPDX-License-Identifier: Apache-2.0
// What comes through between pairs of elements: rays from nodes to nodes, many pairs at once.
#pragma once

#include "light/radiosity/mesh.h"

namespace candela::radiosity {

/// Of a pair, a colour; 1 = nothing stands between.
using Visibility = std::array<float, colorSamples>;

/// One a thread.
class VisibilityRays {
public:
    static constexpr int raysOfPair = 16;
    static constexpr int pairs = 256; ///< Most at once.
    VisibilityRays();

    struct Pair {
        int receiver, sender;
    };
    /// The mean over rays between nodes that face each other; 0 where none do.
    void ask(const Mesh &, std::span<const Pair>, Visibility *);

private:
    RayBatch rays_;
    Planes<float> transmittance_;
};

} // namespace candela::radiosity
