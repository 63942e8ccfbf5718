// SPDX-License-Identifier: Apache-2.0
// From a RIB file and points to numbers: `candela probe`.
#pragma once

#include "light/probe/probe.h"
#include "render/probe_answers.h"
#include "render/render.h"
#include "render/work_plane.h"

#include <optional>
#include <string>
#include <vector>

namespace candela {

struct ProbeFileSettings {
    std::string scene;        ///< RIB file; "-" = standard input.
    std::string points = "-"; ///< File of points, unless there is a plane; "-" = standard input.
    std::optional<WorkPlane> plane;
    /// Of a plane: a picture in place of the table. PNG: in false colours; else EXR.
    std::string output;
    std::vector<std::string> falsecolor; ///< Parameters of that filter: NAME=VALUE.
    ProbeSettings probe;                 ///< The scene has its integrator.
    AnswerFormat format = AnswerFormat::Plain;
    RenderSettings render; ///< Of pictures' settings those that concern the scene.
};

/// Probes the first world of the scene. Answers go to standard output, in the order of the points,
/// as soon as they are there. 0 if all went well, 1 if anything was wrong and has been reported:
/// then all other points have been answered.
int probeFile(const ProbeFileSettings &);

} // namespace candela
