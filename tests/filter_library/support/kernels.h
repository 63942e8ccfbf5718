// SPDX-License-Identifier: Apache-2.0
// Reconstruction kernels in double precision, for references.
#pragma once

#include <string>

namespace candela::filters {

inline constexpr const char *kernelNames[] = {"box", "triangle", "gaussian", "catmull-rom",
                                              "lanczos"};

/// At a distance in pixels from the middle of a kernel of that whole width; a box counts the part
/// of the pixel that it covers.
double kernelAt(const std::string &name, double distance, double width);
/// The width over a picture of the same resolution.
double usualWidth(const std::string &name);

} // namespace candela::filters
