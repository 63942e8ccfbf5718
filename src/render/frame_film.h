// SPDX-License-Identifier: Apache-2.0
// The film of a frame: what its displays and filters want of it.
#pragma once

#include "image/film.h"
#include "image/filter/filter_stack.h"
#include "world/camera/pixel_filter.h"
#include "world/scene/scene.h"

namespace candela {

/// What modes of displays may name: what a first hit tells, what shaders leave in output
/// parameters, and the maps that filters make.
std::vector<ChannelInfo> channelsToShow(const Scene &, const FilterStack &);

Film::Settings filmSettings(const Scene &, const std::array<int, 4> &crop,
                            const PixelFilterSampler &, const FilterStack &);

/// What keeps a film of these settings, and `maps` bytes beside it, from being made is reported.
bool canHold(const Film::Settings &, double maps, const Options &, DiagnosticSink &);

} // namespace candela
