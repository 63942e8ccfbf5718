// SPDX-License-Identifier: Apache-2.0
// Where light paths are worth beginning, learned from pilots: what the camera sees directly of
// point lights' surroundings, and from then on which paths have been seen.
#pragma once

#include "light/path/wave.h"
#include "world/scene/emission_guide.h"

#include <span>
#include <vector>

namespace candela {

/// The frame is a pilot's own. `darkness`, by cell of LightTally: the luminance that light counts
/// over there. x[i], y[i]: pixels that are spread over the frame. `rounds` of some thousand paths.
/// Paths that are to be `besidePath` go nowhere straight.
EmissionGuide learnEmission(FrameContext &, const std::vector<double> &darkness,
                            std::span<const int> x, std::span<const int> y, int rounds,
                            bool besidePath);

} // namespace candela
