// SPDX-License-Identifier: Apache-2.0
// One frame: samples to film, film through filters to displays.
#pragma once

#include "interface/ri/error_policy.h"
#include "render/console.h"
#include "render/frame_keeper.h"
#include "render/render.h"
#include "render/statistics.h"

namespace candela {

/// Whom a frame tells what.
struct FrameListeners {
    ErrorPolicy &diagnostics;
    Console &console; ///< Its progress.
    Statistics &statistics;
};

/// Renders, filters and writes the scene, unless what is known before the first sample says that it
/// cannot be done. `file` is the RIB's name. Of a frame that is ended before it is whole what there
/// is is written.
FrameEnd renderFrame(const Scene &, ShaderLibrary &, const RenderSettings &,
                     const std::string &file, const FrameListeners &, const FrameKeeping & = {});

/// What the program answers the shell after that end.
int exitStatusOf(FrameEnd, const Console &);

} // namespace candela
