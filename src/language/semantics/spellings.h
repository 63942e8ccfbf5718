// SPDX-License-Identifier: Apache-2.0
// Strings that name something of the language, as shaders spell them. The checker and the lowering
// (which meets strings that come from scenes) know them from here alone.
#pragma once

#include <string_view>

namespace candela::sl {

/// The standard spelling; empty if the name stands for nothing.
std::string_view colorSpaceSpelled(std::string_view name);
std::string_view splineBasisSpelled(std::string_view name);

/// For messages.
inline constexpr const char *colorSpaceNames = "rgb, hsv, hsl, XYZ, xyY or YIQ";
/// Before the name of a basis: the spline is to be inverted.
inline constexpr std::string_view inverseSpline = "solve";
inline constexpr const char *splineBasisNames =
    "catmull-rom, bezier, bspline, hermite, linear or power";

} // namespace candela::sl
