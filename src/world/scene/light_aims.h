// SPDX-License-Identifier: Apache-2.0
// From points to their samples of light, all lanes of a block at once: directions, distances and
// densities, and where shadow rays end.
#pragma once

#include <cstdint>

namespace candela {

using Planes3 = const float *const *;

/// Direction, distance and density of samples that lie on surfaces; light 0 where they aren't to
/// be had: those that turn their back where rays do not meet it, for one. L ends before the zone in
/// which the light's own elements might stand in the way.
void aim(int count, Planes3 point, Planes3 normal, float frontSign, const float *offset, Planes3 P,
         const float *drawnPdf, const float *probability, const std::int32_t *index,
         float *const L[3], float *distance, float *pdf, std::int32_t *light);
/// The same for lights without extent, whose shaders have said L, from the light to Ps. A distant
/// one's is a direction, of any length: the same from wherever a ray starts.
void aimAtDelta(int count, Planes3 given, Planes3 Ps, Planes3 P, bool distant,
                const std::int32_t *index, float *const L[3], float *distance, float *pdf,
                std::int32_t *light);
/// Ends L before the zone in which the light's own elements might stand in the way, where it leads
/// to the point of the element that was drawn; shaders may say another L.
void endBeforeZone(int count, Planes3 point, Planes3 normal, const float *offset, Planes3 P,
                   float *const L[3], float *distance);

} // namespace candela
