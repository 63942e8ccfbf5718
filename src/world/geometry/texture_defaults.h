// SPDX-License-Identifier: Apache-2.0
// The s and t that shapes have where none are given: RiTextureCoordinates over their (u,v).
#pragma once

#include "world/geometry/surface.h"

namespace candela {

/// Appends the variable unless there is one of its name. Its place, or -1.
int addDefault(const char *name, std::vector<VariableInfo> &);

/// Surface::evaluateVariable of a default s (0) or t (1) at `count` places.
void evaluateDefault(const std::array<float, 8> &textureCoordinates, int component, int count,
                     const float *u, const float *v, float *const *value, float *const *valueDu,
                     float *const *valueDv);

} // namespace candela
