// SPDX-License-Identifier: Apache-2.0
// The kernel between two elements: K = cos cos' / (pi r^2), without what stands between them.
#pragma once

#include "light/radiosity/sender.h"

namespace candela::radiosity {

struct Transfer {
    /// What exitance at node j of the sender gives as irradiance at node i of the receiver.
    std::array<float, mostNodes * mostNodes> kernel{};
    int senders = 0;   ///< Columns.
    float largest = 0; ///< Form factor of any of the receiver's nodes.
    /// By how much the receiver's basis misses irradiance by a unit of exitance,
    float receiverError = 0;
    /// and by how much the rule misses a unit of variation over the sender.
    float senderError = 0;
    /// By how much the kernel varies over the sender other than its basis does, about.
    float curvature = 0;
    bool isNear = false; ///< Integrated in closed form, as to how much.

    float operator()(int i, int j) const { return kernel[std::size_t(i * senders + j)]; }
};

Transfer transferBetween(const Mesh &, int receiver, int sender);

/// By how much the kernel misses irradiance near the receiver's corners, and where its border comes
/// nearest to the sender, by a unit of exitance.
float errorAtBorder(const Mesh &, int receiver, int sender, const Transfer &);

/// Nothing stands between: rectangles that are near each other exchange what their closed form
/// says, as a whole (rectangle_factor.h).
void completeKernel(const Mesh &, int receiver, int sender, Transfer &);

/// Integrates anew what the rules say roughly, by those of quarters of the elements.
void refineKernel(const Mesh &, int receiver, int sender, Transfer &);

/// No point of the one sees the front of the other, as far as nodes and corners tell.
bool areTurnedAway(const Mesh &, int a, int b);

} // namespace candela::radiosity
