// SPDX-License-Identifier: Apache-2.0
#include "render/render.h"

#include "foundation/base/parallel.h"
#include "render/console.h"
#include "render/read_scenes.h"
#include "render/render_run.h"
#include "render/statistics.h"

namespace candela {

int renderFiles(const std::vector<std::string> &paths, const RenderSettings &settings) {
    Console console(settings.quiet ? Console::Words::Messages : Console::Words::Results);
    ErrorPolicy diagnostics(console);
    ThreadLimit threads(settings.threads);
    Statistics statistics;
    const FrameListeners listeners{diagnostics, console, statistics};
    RenderRun run(paths.front(), settings, listeners);
    if (!run.begin())
        return 1;
    readScenes(
        paths, settings, listeners,
        [&](const Scene &scene, ShaderLibrary &shaders, const SceneFingerprints &fingerprints) {
            run.take(scene, shaders, fingerprints);
        });
    run.finish();
    if (!settings.statisticsFile.empty())
        statistics.write(settings.statisticsFile, diagnostics);
    return exitStatusOf(run.end(), console);
}

} // namespace candela
