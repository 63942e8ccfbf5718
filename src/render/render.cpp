// SPDX-License-Identifier: Apache-2.0
#include "render/render.h"

#include "foundation/base/parallel.h"
#include "render/console.h"
#include "render/frame.h"
#include "render/interrupt.h"
#include "render/read_scenes.h"
#include "render/statistics.h"

#include <unistd.h>

namespace candela {

int renderFile(const std::string &path, const RenderSettings &settings) {
    Console console(!settings.quiet && isatty(STDERR_FILENO));
    ErrorPolicy diagnostics(console);
    ThreadLimit threads(settings.threads);
    Statistics statistics;
    const FrameListeners listeners{diagnostics, console, statistics};
    bool interrupted = false;
    readScenes(path, settings, listeners, [&](const Scene &scene, ShaderLibrary &shaders) {
        if (!interrupted)
            interrupted = !renderFrame(scene, shaders, settings, path, listeners);
    });
    if (!settings.statisticsFile.empty())
        statistics.write(settings.statisticsFile, diagnostics);
    return interrupted ? statusOfInterrupt : console.failed() ? 1 : 0;
}

} // namespace candela
