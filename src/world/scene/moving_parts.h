// SPDX-License-Identifier: Apache-2.0
// Primitives that move, taken together as they move.
#pragma once

#include "world/scene/declared_world.h"

#include <span>
#include <vector>

namespace candela {

/// Makes of primitives that move within an object instances of objects of their own: those that
/// move together are one. Once all is declared, before placementsOf().
void separateMovingParts(DeclaredWorld &);

/// Primitives of the world that move together.
struct MovingGroup {
    std::vector<const DeclaredPrimitive *> primitives;
    /// From where points are when the shutter opens, in current space, to where they are then.
    std::vector<Matrix4> steps;
};
std::vector<MovingGroup> movingGroupsOf(const DeclaredWorld &);
/// The same of a placement, from its own steps.
std::vector<Matrix4> stepsFromOpen(std::span<const Matrix4> steps);

} // namespace candela
