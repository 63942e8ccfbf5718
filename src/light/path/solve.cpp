// SPDX-License-Identifier: Apache-2.0
#include "light/path/solve.h"

namespace candela {

std::unique_ptr<radiosity::Solution> solve(const Scene &scene, const IntegratorSettings &settings,
                                           TransportStatistics &statistics,
                                           DiagnosticSink &diagnostics) {
    std::unique_ptr<radiosity::Solution> solution;
    if (settings.kind != IntegratorKind::Radiosity)
        return solution;
    if (settings.solved)
        solution = radiosity::Solution::restored(scene, *settings.solved);
    if (settings.solved && !solution)
        diagnostics.warning({}, "the solution that has been kept is of other faces than this view "
                                "has (levels of detail go by the camera): it is solved anew");
    if (!solution)
        solution = std::make_unique<radiosity::Solution>(scene, settings.solver, diagnostics,
                                                         settings.solving);
    if (settings.whenSolved)
        settings.whenSolved(*solution);
    statistics.solver = solution->statistics();
    return solution;
}

} // namespace candela
