// SPDX-License-Identifier: Apache-2.0
// A surface shader's bounds over a grid of boxes, and how far it strays: `candela run --bounds`.
#pragma once

#include "render/named_planes.h"
#include "world/shading/shader_code.h"

namespace candela {

/// The square of runShader(), cut into boxes: of reflectance, emission ("Ce") and opacity ("Oi")
/// the value in the middle of each, slopes, tolerance, and how far any of 64 points lies off the
/// slopes
/// ("reflectance deviation").
std::vector<NamedPlanes> boundsOfBoxes(const ShaderInstance &, int width, int height);

} // namespace candela
