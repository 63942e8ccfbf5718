// SPDX-License-Identifier: Apache-2.0
// How different two pictures look to who alternates between them: FLIP (Andersson et al. 2020), and
// HDR-FLIP (Andersson et al. 2021) of light, which looks at all exposures that show something.
#pragma once

#include "image/picture.h"

#include <optional>
#include <vector>

namespace candela {

/// Pixels to a degree of the eye's: those of a screen 0.7 m wide of 3840 pixels, 0.7 m away.
inline constexpr double flipPixelsPerDegree = 67.0206;

struct FlipMap {
    std::vector<float> values; ///< By pixel, from 0, the same, to 1.
    double mean = 0;
    int exposures = 1; ///< 1 for display values.
};

/// Of R, G and B of two pictures of one window, `reference` being what b is for compare.h. Values
/// as displays have them (Picture::hasDisplayValues of both) are compared as they are, light at the
/// exposures that the reference asks for. What is not finite counts as 0, negative light too.
/// Nothing if either has not R, G and B, or has no pixels.
std::optional<FlipMap> flipOf(const Picture &test, const Picture &reference,
                              double pixelsPerDegree = flipPixelsPerDegree);

} // namespace candela
