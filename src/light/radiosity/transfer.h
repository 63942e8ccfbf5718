// SPDX-License-Identifier: Apache-2.0
// The kernel between two elements: K = cos cos' / (pi r^2), without what stands between them.
#pragma once

#include "light/radiosity/mesh.h"

namespace candela::radiosity {

/// The form factor of a point with unit normal N to what a closed line spans (Lambert), clipped at
/// the point's horizon. `turned` as Element has it: the side that sends.
float contourFactor(Vec3 P, Vec3 N, std::span<const Vec3> corners, float turned);

/// What sends: an element, or a quarter of one.
struct Sender {
    std::array<Node, mostNodes> nodes;
    int count = 0;
    std::array<Vec3, 4> corners;
    std::size_t sides = 0;
    float area = 0, turned = 1, fullness = 1;
    bool isPlane = true; ///< Its contour says all; of curved elements the rule does.

    Sender(const Mesh &, int element);

    /// Fills the row and returns the form factor, and by how much the rule alone has missed it. The
    /// rule says where on the sender light comes from, the contour how much.
    float factor(Vec3 P, Vec3 N, bool byContour, float *row, float &missed) const;
};

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

/// Integrates anew what the rules say roughly, by those of quarters of the elements.
void refineKernel(const Mesh &, int receiver, int sender, Transfer &);

/// No point of the one sees the front of the other, as far as nodes and corners tell.
bool areTurnedAway(const Mesh &, int a, int b);

} // namespace candela::radiosity
