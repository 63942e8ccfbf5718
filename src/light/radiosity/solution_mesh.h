// SPDX-License-Identifier: Apache-2.0
// The solution for other programs: its elements with the radiance at their corners.
#pragma once

#include "foundation/base/matrix4.h"
#include "light/radiosity/solution.h"

#include <string>

namespace candela::radiosity {

/// A PLY file (binary, little-endian): an element a face, each with corners of its own: x, y, z and
/// the normal nx, ny, nz of its side, in world space, and red, green, blue: the radiance that
/// leaves it there, W m^-2 sr^-1, as a matt surface's. Backs that are dark are left out. What light
/// sources send that are sampled and not linked is not in it.
std::string plyOf(const Solution &, const Matrix4 &worldFromCurrent);

} // namespace candela::radiosity
