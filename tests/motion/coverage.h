// SPDX-License-Identifier: Apache-2.0
// What moving things cover, by brute force.
#pragma once

#include "tests/support/frames.h"

#include <functional>
#include <string>
#include <vector>

namespace candela::test {

/// An orthographic look along +z at [-2,2] x [-1,1], 32 x 16 pixels.
inline constexpr int coverageWidth = 32, coverageHeight = 16;
inline const std::string coverageView =
    "Format 32 16 1\nProjection \"orthographic\"\nScreenWindow -2 2 -1 1\n";

/// Whether the point is covered when that share of the shutter's interval has passed.
using Covers = std::function<bool(double x, double y, double share)>;

/// Red, which is 1 on what is covered, is as likely as not to be so far off in places and on the
/// whole: five standard errors of as many samples that know nothing of each other.
void expectCoverage(const FramePixels &, int samples, const Covers &);

} // namespace candela::test
