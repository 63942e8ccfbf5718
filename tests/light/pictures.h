// SPDX-License-Identifier: Apache-2.0
// Small pictures of small worlds, pixel by pixel.
#pragma once

#include <string>
#include <vector>

namespace candela::test {

struct SmallPicture {
    std::vector<float> red, alpha;
};

inline const std::string inPath = "Option \"radiometry\" \"string units\" [\"si\"]\n"
                                  "Option \"render\" \"string integrator\" [\"path\"]\n";
inline const std::string inClassic = "Option \"radiometry\" \"string units\" [\"si\"]\n"
                                     "Option \"render\" \"string integrator\" [\"classic\"]\n";

/// A square of pixels of an orthographic look along +z over a square of half-width .1, with these
/// RIB options before the camera and this RIB in the world. The shaders of tests/light/shaders are
/// at hand.
SmallPicture takePicture(const std::string &options, const std::string &world, int samples,
                         int seed = 0, int pixelsAcross = 8);

/// A square about (0,0,z) of that half-width that faces the eye.
std::string squareAt(double z, double halfWidth = 1);

} // namespace candela::test
