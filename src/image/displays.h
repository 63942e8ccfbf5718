// SPDX-License-Identifier: Apache-2.0
// From the film to files: every display of a frame through the imaging pipeline into its format.
#pragma once

#include "image/display_plan.h"
#include "image/display_sources.h"
#include "image/picture.h"
#include "interface/ri/options.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace candela {

/// What the files say about the frame beside what film and options know.
struct FrameDescription {
    /// Free text: "renderer" (name and version), "integrator", "spp", "seed" and whatever else a
    /// reader may ask. Units, exposure, filter and quantisation are added to it.
    std::map<std::string, std::string> metadata;
    std::optional<Matrix4> worldToCamera, worldToNdc;
};

/// Writes the displays, each whole or not at all. One that fails all the same (a full disk) is
/// reported and the others still come. Planes of another size than a display's first one (filters
/// change sizes) are left out with a warning. Returns the paths that were written, in order.
std::vector<std::string> writeDisplays(const DisplaySources &, std::span<const PlannedDisplay>,
                                       const Options &, const FrameDescription &, DiagnosticSink &);

/// Hands the displays that are taken over, as floats that are not quantised. Planes that there are
/// not yet (of filters) are missing.
void handOver(const DisplaySources &, std::span<const PlannedDisplay>, const Options &,
              const FrameDescription &, DisplayTaker &, bool isFinished);

/// How a display wants its planes.
struct PlaneSettings {
    ExposureRecord exposure;
    bool srgbCurve = false;     ///< Behind it.
    bool straightAlpha = false; ///< Colors are those of what covers the pixel.
    QuantizeRecord color, depth;
    std::map<std::string, QuantizeRecord> channels; ///< Of other channels, by name.
    std::optional<QuantizeRecord> own;              ///< The display's, of all others.
    bool quantizeAll = false;                       ///< The format holds whole numbers only.
    bool halves = false;
};
/// The picture a display shows: Ci through exposure and, if `color.one` is not 0, quantised, as
/// alpha and depth are; other channels as they are unless `quantizeAll`, `own` or `channels` says
/// otherwise. Planes of the halves lie
/// under "half0" and "half1" if wanted and the film has them.
Picture developPicture(const DisplaySources &, const std::vector<DisplayPlane> &,
                       const PlaneSettings &);

} // namespace candela
