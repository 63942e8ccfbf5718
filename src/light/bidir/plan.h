// SPDX-License-Identifier: Apache-2.0
// How often each technique is tried in a frame, found by pilots: samples that are thrown away, so
// that what is counted has nothing to do with what is seen.
#pragma once

#include "light/path/wave.h"
#include "world/scene/emission_guide.h"

namespace candela {

/// Some light begins paths. Volumes that keep them from it are said.
bool lightsMayBeginPaths(const FrameContext &);
/// Depends on scene, seed and settings alone; no technique but the camera's where nothing begins
/// paths on lights. Learns besides where paths from lights begin best.
BidirectionalPlan planTechniques(FrameContext &, EmissionGuide &);

} // namespace candela
