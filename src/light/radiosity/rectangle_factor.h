// SPDX-License-Identifier: Apache-2.0
// The form factor between two rectangles in closed form, touching ones too, where kernels are
// singular (VALIDATION B6).
#pragma once

#include "foundation/base/vec3.h"

#include <optional>
#include <span>

namespace candela::radiosity {

/// The share of what the one sends diffusely that meets the other, nothing between them: rectangles
/// by their corners in order, whose edges are parallel or square to each other. Nothing if they are
/// no such rectangles, or one goes through the plane of the other. Which sides they are is not
/// asked.
std::optional<double> rectangleFactor(std::span<const Vec3> from, std::span<const Vec3> to);

} // namespace candela::radiosity
