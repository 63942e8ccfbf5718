// SPDX-License-Identifier: Apache-2.0
// Imager shaders: what becomes of each pixel's colour and alpha between exposure and quantisation
// (RI 3.2, 4.1.4).
#pragma once

#include "image/display_sources.h"
#include "interface/ri/options.h"
#include "world/shading/shader_library.h"

#include <array>
#include <optional>

namespace candela {

class Imager {
public:
    /// The imager of the options, compiled; nothing if there is none, or a faulty one (reported).
    static std::optional<Imager> of(const Options &, ShaderLibrary &, DiagnosticSink &);

    /// Ci through exposure and imager, with the alpha that the imager gives it. It is asked in
    /// batches on all cores, a pixel a lane: P is the pixel's centre in raster space, u, v (and s,
    /// t) where that is in the frame, from 0 at the left and the top to 1; time is the
    /// opening of the shutter, Oi and alpha those that displays would show; where filters have
    /// given Ci another size and these not, they are 1. What it makes of Oi is not shown. Answers
    /// that are not finite count as 0, with a warning.
    ImagedPicture run(const DisplaySources &, DiagnosticSink &) const;

private:
    Imager(ShaderInstance instance, const Options &options)
        : instance_(std::move(instance)), exposure_(options.exposure.value_or(ExposureRecord{})),
          time_(options.camera.shutterOpen), frame_(options.format.effectiveResolution()) {}

    ShaderInstance instance_;
    ExposureRecord exposure_;
    float time_;
    std::array<int, 2> frame_; ///< Pixels of the whole frame.
};

} // namespace candela
