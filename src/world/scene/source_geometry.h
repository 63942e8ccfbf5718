// SPDX-License-Identifier: Apache-2.0
// Pieces of lights as geometry: their area, and pairs of triangles that are rectangles.
#pragma once

#include "world/rays/ray_world.h"
#include "world/scene/light_sources.h"

#include <optional>

namespace candela {

double areaOf(const LightSource &);
/// What the tree is to know of a source, for so much power.
EmitterBound boundOf(const LightSource &, double power);
/// Corner and edges of element k in current space.
void setTriangle(LightSource &, const RayShape &, std::uint32_t element,
                 const Matrix4 &currentFromOuter);
/// The rectangle that both triangles make up, its edges turned as the first one's are; nothing if
/// they don't.
std::optional<LightSource> rectangleOf(const LightSource &, const LightSource &);

} // namespace candela
