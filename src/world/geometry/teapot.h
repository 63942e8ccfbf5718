// SPDX-License-Identifier: Apache-2.0
// Martin Newell's teapot of 1975, as published: 32 bicubic Bezier patches.
#pragma once

#include <vector>

namespace candela {

/// Control points of each patch, 48 floats, u fastest. z is up, the teapot stands on z = 0, its
/// spout points along x; natural normals are outside.
std::vector<std::vector<float>> teapotPatches();

} // namespace candela
