// SPDX-License-Identifier: Apache-2.0
// What comes through between pairs of elements: rays from nodes to nodes, many pairs at once.
#pragma once

#include "light/radiosity/mesh.h"

namespace candela::radiosity {

struct Visibility {
    int rays = 0; ///< Sent.
    /// Of the pair, a colour; 1 = nothing stands between.
    std::array<float, colorSamples> mean{};
    /// What comes through between the receiver's node i and the sender's node j, at i times the
    /// sender's nodes + j, in shares of the mean; 1 where no ray was sent.
    std::array<float, mostNodes * mostNodes> share{};
};

/// One a thread.
class VisibilityRays {
public:
    static constexpr int raysOfPair = 16;
    static constexpr int pairs = 256; ///< Most at once.
    VisibilityRays();

    struct Pair {
        int receiver, sender;
    };
    /// By rays between nodes that face each other; 0 where none do.
    void ask(const Mesh &, std::span<const Pair>, Visibility *);

private:
    RayBatch rays_;
    Planes<float> transmittance_;
    Planes<std::uint32_t> around_;    ///< Between elements there is air,
    Planes<std::int32_t> atmosphere_; ///< or that of what receives.
    std::vector<std::uint8_t> place_; ///< Of each ray: which of its pair's node pairs.
};

} // namespace candela::radiosity
