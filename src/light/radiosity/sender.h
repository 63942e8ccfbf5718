// SPDX-License-Identifier: Apache-2.0
// What an element sends to a point: by the rule of its nodes, and in closed form, by its contour.
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
    /// Of an element, by what its nodes tell of it.
    static std::array<Sender, 4> quartersOf(const Mesh &, int element);

    /// Fills the row and returns the form factor, and by how much the rule alone has missed it. The
    /// rule says where on the sender light comes from, the contour how much.
    float factor(Vec3 P, Vec3 N, bool byContour, float *row, float &missed) const;
};

/// How an element's points follow from its nodes; constant elements have a shape, too.
const Basis &shapeOf(const Mesh &, int element);
/// The point of an element that its nodes lead to; `area` is that of a unit of its (u,v).
Node between(const Basis &shape, const Node *nodes, Place at);
/// A place of a child in its parent.
Place inParent(const Basis::ChildPlace &child, Place own);
std::span<const Vec3> cornersOf(const Mesh &, int element);

} // namespace candela::radiosity
