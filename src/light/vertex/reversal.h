// SPDX-License-Identifier: Apache-2.0
// Whether light may pass a vertex of one direction the other way: a shader that looks along one
// direction and asks trace() along another is a mirror or a window only if it asks along the first
// when it is looked at from there.
#pragma once

#include "light/vertex/surface_vertices.h"

namespace candela {

/// passes[i] = 1 where one of the delta requests of the view (from where the other direction leads)
/// asks along `back`, unit vectors; else 0. Where `request` is given, which.
void reversals(int count, const PreparedSurface &view, const ConstVec3Planes &back, float *passes,
               std::int32_t *request = nullptr);

} // namespace candela
