// SPDX-License-Identifier: Apache-2.0
// The estimators' common face: a scene and a range of samples in, samples of whole pixels out.
#pragma once

#include "light/frame/frame_progress.h"
#include "light/path/settings.h"
#include "world/camera/pixel_filter.h"
#include "world/scene/sample_sink.h"
#include "world/scene/scene.h"

namespace candela {

/// Renders all pixels of the crop window, pass by pass, from where `progress` is up to
/// settings.lastSample or until it is stopped. The bytes depend neither on stops nor on how often a
/// frame is taken up again. Non-finite radiance is reported once to `diagnostics`, with shader,
/// pixel and sample, then counted.
void integrate(const Scene &, const IntegratorSettings &, const PixelFilterSampler &, SampleSink &,
               FrameProgress &progress, TransportStatistics &, DiagnosticSink &);

} // namespace candela
