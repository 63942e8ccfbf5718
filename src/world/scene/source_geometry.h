// SPDX-License-Identifier: Apache-2.0
// Elements and pieces of lights as geometry: areas, bounds, and pairs of triangles that are
// rectangles.
#pragma once

#include "world/rays/ray_world.h"
#include "world/scene/light_sources.h"

#include <optional>

namespace candela {

/// Of a triangle, rectangle or sphere, m^2.
double areaOf(const LightElement &);
/// How much of the sky above the origin the whole of it fills, from either side, sr.
double solidAngleOf(const LightElement &);
/// What the tree is to know of a source with geometry; its power is left out. `elementSign` as in
/// Appearance.
EmitterBound boundOf(const LightTable &, const LightSource &, LightSides, float elementSign);
/// Grown to all that it bounds where its space goes these steps (none: it stands still).
/// `objectFromOpen`: the inverse of where it stands when the shutter opens.
void spreadByMotion(std::span<const Matrix4> steps, const Matrix4 &objectFromOpen, EmitterBound &);
/// Corner and edges of element `number` in current space.
void setTriangle(LightElement &, const RayShape &, std::uint32_t number,
                 const Matrix4 &currentFromOuter);
/// The sphere in current space that the shape is, if it is one and stays one; the rest
/// is as in `like`.
std::optional<LightElement> sphereOf(const LightElement &like, const RayShape &,
                                     const Matrix4 &currentFromOuter);
/// The rectangle that both triangles make up, its edges turned as the first one's are; nothing if
/// they don't.
std::optional<LightElement> rectangleOf(const LightElement &, const LightElement &);

} // namespace candela
