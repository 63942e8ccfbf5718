// SPDX-License-Identifier: Apache-2.0
// The estimators' common face: a scene and a range of samples in, samples of whole pixels out.
#pragma once

#include "light/path/settings.h"
#include "world/camera/pixel_filter.h"
#include "world/scene/sample_sink.h"
#include "world/scene/scene.h"

namespace candela {

/// Renders the samples [settings.firstSample, settings.lastSample) of all pixels of the crop
/// window, pass by pass. A film that has got the samples up to the beginning of a pass, and that
/// pass's number, are all that a render needs to be continued: the bytes do not depend on how the
/// passes were shared out among calls. Non-finite radiance is reported once to `diagnostics`, with
/// shader, pixel and sample, then counted.
void integrate(const Scene &, const IntegratorSettings &, const PixelFilterSampler &, SampleSink &,
               TransportStatistics &, DiagnosticSink &);

} // namespace candela
