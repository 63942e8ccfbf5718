// SPDX-License-Identifier: Apache-2.0
// Pictures of how pictures differ.
#pragma once

#include "image/compare_seeds.h"
#include "image/flip.h"

namespace candela {

/// Channels of both pictures, a - b; and "flip", if there is such a map. Of one window.
Picture differenceOf(const Picture &a, const Picture &b, const std::optional<FlipMap> &);

/// For the eye, as display values in R, G and B: the map in a glow from black, 0, to white, 1; else
/// the difference of luminance, red where a is brighter, blue where b is, full where it is `full`
/// (a part of the brighter value) or more. Without R, G and B it is the first channel of both.
Picture shownDifference(const Picture &a, const Picture &b, const std::optional<FlipMap> &,
                        float full);

/// Each region's z in "z", a - b of the means in "difference", by channel of the comparison if
/// there are several ("z.R").
Picture differenceOf(const SeedComparison &, const FrameWindow &);

/// Red where a is brighter than chance allows, blue where b is; full at a |z| of 5. Of the first
/// channel.
Picture shownDifference(const SeedComparison &, const FrameWindow &);

} // namespace candela
